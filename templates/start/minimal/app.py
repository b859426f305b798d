"""Code of your own. It lies on the board beside the generated modules, and is never overwritten."""

from vehicle import Vehicle


class App(Vehicle):
    """The generated program with what it does here."""

    percent = 80.0

    def measure(self):
        """Called 10 times per second: read your sensors here, and set what they say."""
        self.percent = self.percent - 0.1 if self.percent > 20 else 80.0  # a tank that is used, and filled again
        self.state.tank.level = self.percent
