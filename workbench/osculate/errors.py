"""The errors of osculate that are not Python's own."""


class ContactError(ValueError):
    """A construction cannot meet the contact asked for; the message says what can."""
