# Generated from templates/mocks/sim_watch.py: do not edit.
# Inputs: 29319bfe995d4c8c
"""Records the vehicle's actions in a simulation from its state whenever that changes: nothing is read out of texts."""

from array import array


class Watch:
    """Looks at a vehicle: quantities of its state, levels of its failsafes, and the actions that are called.

    `quantities` are [label, component, instance, name, ages] of what is looked at; one that ages may be forgotten
    without anything being set. `actions` are names of methods.
    """

    def __init__(self, records, quantities, actions):
        self._records = records
        self._quantities = quantities
        self._actions = actions
        self._known = {}
        self._failsafes = ()
        self._ages = any(quantity[4] for quantity in quantities)
        self._words = self._seen = None  # of the state, and what they were when its quantities were looked at last

    def begin(self, vehicle):
        """Begin to watch a vehicle: what its failsafes and methods are called."""
        found = []
        attributes = vehicle.__dict__
        for name in sorted(attributes):
            if name.startswith("_"):  # a list of what has a name of its own, too
                continue
            value = attributes[name]
            several = value if isinstance(value, (list, tuple)) else (value,)
            for index, each in enumerate(several):
                if hasattr(each, "level") and hasattr(each, "title"):
                    found.append([name, index, each, each.level])
        self._failsafes = tuple(found)
        self._words = None if self._ages else getattr(vehicle.state, "words", None)
        self._seen = None
        for name in self._actions:
            method = getattr(vehicle, name, None)
            if method is not None:
                setattr(vehicle, name, self._recorded(name, method, vehicle))

    def look(self, vehicle):
        """Record what has changed."""
        for entry in self._failsafes:
            if entry[2].level != entry[3]:
                entry[3] = entry[2].level
                self._records.put("failsafe", name=entry[0], index=entry[1], title=entry[2].title, level=entry[3])
        words = self._words
        if words is None:
            self._look_at(vehicle.state)
        elif words != self._seen:
            self._seen = array("i", words)
            self._look_at(vehicle.state)

    def _look_at(self, state):
        for label, component, instance, name, _ in self._quantities:
            value = getattr(getattr(state, component)[instance], name)
            if label not in self._known or self._known[label] != value:
                self._known[label] = value
                self._records.put("state", label=label, value=value)

    def _recorded(self, name, method, vehicle):
        def recorded(*given):
            self.look(vehicle)  # the level comes before what is done for it
            self._records.put("action", name=name)
            return method(*given)

        return recorded
