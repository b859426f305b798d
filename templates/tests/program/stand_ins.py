"""Stand-ins for the parts of a vehicle around a part that is looked at by itself."""


class Thing:
    """Has the attributes that it is given."""

    def __init__(self, **attributes):
        for name, value in attributes.items():
            setattr(self, name, value)


class Texts:
    """Notes what is told, with its severity."""

    def __init__(self):
        self.told = []

    def __call__(self, *parts):
        """Note a text, without a severity."""
        self.told.append((None, " ".join([str(part) for part in parts])))

    def say(self, severity, text):
        """Note a text."""
        self.told.append((severity, text))
