"""How the user sees that something takes long, and stops it: the GUI says so when it starts.

Nothing in osculate.features imports the GUI; without it nothing is shown and nothing stops.
"""

from contextlib import nullcontext

_maker = None


class Stopped(RuntimeError):
    """The user stopped what took long; the message is a sentence for the user."""


def register(maker):
    """From now on `maker(title)` gives the context managers of long_work."""
    global _maker
    _maker = maker


def long_work(title):
    """A context manager around something that may take long. It gives a function that takes the
    share done, 0 to 1, and returns False where the user wants it to stop; or None.
    """
    return _maker(title) if _maker is not None else nullcontext()
