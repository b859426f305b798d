# Generated from specs/smart_battery/vehicle.yaml, dialect common: do not edit.
# Inputs: da3081d7f91c27b1
"""The program: what the board starts."""

import asyncio
import gc
import sys

import micropython

vehicle = None


def vehicle_class():
    """Return the class Pack of the user's module pack, or Vehicle where there is no such module."""
    level = compile_at(3)  # without the numbers of lines, which would lie on the heap: those of your code stay
    # First, while the heap is free: to compile what they import takes most, and vehicle would import scheduler last.
    import scheduler  # noqa: F401, PLC0415
    import state  # noqa: F401, PLC0415
    import streams  # noqa: F401, PLC0415
    from vehicle import Vehicle  # noqa: PLC0415

    compile_at(level)
    try:
        import pack  # noqa: PLC0415
    except ImportError as error:
        if not str(error).endswith("'pack'"):  # the module is there, but one that it imports is not
            raise
        return Vehicle
    if not issubclass(pack.Pack, Vehicle):
        raise TypeError("pack.Pack is not derived from vehicle.Vehicle")
    return pack.Pack


def new_vehicle():
    """Return the user's vehicle; where its code is faulty, one that says so."""
    try:
        return vehicle_class()()
    except Exception as error:
        if hasattr(sys, "print_exception"):  # CPython has none
            sys.print_exception(error)
        problem = f"pack: {error!r}"
    gc.collect()
    from vehicle import Vehicle  # noqa: PLC0415

    spare = Vehicle()
    spare.check_arming = lambda: problem
    spare.texts("error:", problem)
    return spare


def collect_often(is_often):
    """Let garbage be collected while little of it is there, or only where the heap is full.

    What stays then lies close together, and not scattered among what importing a module and making the vehicle leave
    behind: the free memory is in one piece, and a smaller heap is enough.
    """
    if hasattr(gc, "threshold"):  # CPython, where the program is tried, has none
        gc.threshold(gc.mem_free() // 32 if is_often else -1)


def compile_at(level):
    """Set the level at which modules are compiled that are imported as sources; return the one before."""
    if not hasattr(micropython, "opt_level"):  # CPython, where the program is tried, has none
        return level
    before = micropython.opt_level()
    micropython.opt_level(level)
    return before


def main():
    """Make the vehicle and run it until the board starts again."""
    global vehicle  # noqa: PLW0603 - there is one, and who looks at the board from outside finds it here
    collect_often(True)
    vehicle = new_vehicle()
    collect_often(False)
    try:
        asyncio.run(vehicle.run())
    except KeyboardInterrupt:  # somebody is at the prompt
        from watchdog import hold  # noqa: PLC0415

        hold()
        raise


if __name__ == "__main__":
    main()
