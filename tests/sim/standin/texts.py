"""Texts as the firmware has them."""


class Texts:
    def __init__(self, echo=print, capacity=16):
        self._echo = echo
        self._capacity = capacity

    def __call__(self, *words):
        self._echo(" ".join(str(word) for word in words))
