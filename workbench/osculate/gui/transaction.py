"""One step of undo around what a command does."""

from contextlib import contextmanager


@contextmanager
def transaction(document, title):
    """What is done inside is one step of undo; an error leaves the document as it was."""
    document.openTransaction(title)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
