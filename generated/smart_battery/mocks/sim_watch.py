# Generated from templates/mocks/sim_watch.py: do not edit.
# Inputs: e75667ad7aacba2a
"""What the vehicle does in a simulation, taken from its state whenever that changes: nothing is read out of texts."""


class Watch:
    """Looks at a vehicle: quantities of its state, levels of its failsafes, and the actions that are called.

    `quantities` are [label, component, instance, name] of what is looked at; `actions` are names of methods.
    """

    def __init__(self, records, quantities, actions):
        self._records = records
        self._quantities = quantities
        self._actions = actions
        self._known = {}
        self._failsafes = ()

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
                    found.append((name, index, each))
                    self._known[(name, index)] = each.level
        self._failsafes = tuple(found)
        for name in self._actions:
            method = getattr(vehicle, name, None)
            if method is not None:
                setattr(vehicle, name, self._recorded(name, method, vehicle))

    def look(self, vehicle):
        """Record what has changed."""
        for name, index, failsafe in self._failsafes:
            level = failsafe.level
            if level != self._known[(name, index)]:
                self._known[(name, index)] = level
                self._records.put("failsafe", name=name, index=index, title=failsafe.title, level=level)
        state = vehicle.state
        for label, component, instance, name in self._quantities:
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
