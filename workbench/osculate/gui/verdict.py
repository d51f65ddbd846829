"""How a verdict looks and reads: colour, icon, name, and the sentence of what it misses."""

from dataclasses import dataclass

from osculate.features.join_check import continuity_name
from osculate.gui import colors, numbers
from osculate.gui.qt import translate

SYMBOLS = {"pass": "✓", "fail": "✗", "undecided": "?"}


def verdict_word(verdict):
    """A verdict in the user's language."""
    return {"pass": translate("Osculate", "pass"),
            "fail": translate("Osculate", "fail"),
            "undecided": translate("Osculate", "undecided"),
            None: translate("Osculate", "not defined here")}[verdict]


@dataclass(frozen=True)
class VerdictLook:
    """The order of a join as it is shown."""

    name: str    #: "G2", "gap", "?" or "!"
    color: str   #: "#rrggbb", dark enough for white text
    icon: str    #: name of an icon of resources/icons


ERROR_LOOK = VerdictLook("!", colors.ERROR, "verdict-error")


def look_of(order, verdicts):
    """The VerdictLook of an order (-1: a gap) and the verdicts of all orders."""
    undecided = len(verdicts) > order + 1 and verdicts[order + 1] == "undecided"
    if order < 0:
        if undecided:
            return VerdictLook("?", colors.UNDECIDED, "verdict-undecided")
        return VerdictLook(translate("Osculate", "gap"), colors.GAP, "verdict-gap")
    suffix = "-undecided" if undecided else ""
    return VerdictLook(continuity_name(order), colors.of_order(order),
                       f"verdict-g{order}{suffix}")


def missing_text(order, verdicts, residuals, short=False):
    """What the join misses in a few words, e.g. "misses G3 by 12.7 %", short "G3 by 12.7 %";
    empty if it misses nothing.
    """
    following = order + 1
    if following >= len(verdicts):
        return ""
    name = continuity_name(following)
    amount = numbers.residual(following, residuals[following])
    if verdicts[following] == "undecided":
        return translate("Osculate", "{} undecided").format(name)
    if amount == numbers.MISSING:
        return translate("Osculate", "{} does not exist here").format(name)
    if following == 0:
        return amount
    phrase = translate("Osculate", "{} by {}") if short else translate("Osculate",
                                                                       "misses {} by {}")
    return phrase.format(name, amount)
