"""One pass of the rover's main loop in which control alone is due: nothing arrives, nothing is read."""

import counting  # isort: skip  before anybody looks at the clock
from texts import Texts
from vehicle import Vehicle

vehicle = Vehicle(ports=[], texts=Texts(counting.unheard))
run_pass = vehicle.scheduler.run_pass
slot = vehicle.scheduler._control
run_pass()  # the first pass does all jobs


def control(rounds):
    """The time has come for control, which does nothing."""
    for _ in range(rounds):
        slot.due_us = 0
        run_pass()


calls = []
vehicle.scheduler._control.call = lambda: calls.append(1)
control(1)
if calls != [1]:
    raise SystemExit("control was not called")
slot.call = vehicle.control
counting.count(control=control)
