"""How a CurvePlot is drawn with matplotlib: one pair of axes a quantity, over a common arc length.

Imports matplotlib; nothing that is imported with osculate does.
"""

import math
from dataclasses import dataclass, field

import numpy

try:
    import matplotlib
    from matplotlib.collections import LineCollection
    from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator
except Exception as error:  # a broken installation raises RuntimeError, among others
    raise ImportError("curve plots are drawn with matplotlib, which does not load (Debian: "
                      f"python3-matplotlib; pip install matplotlib): {error}",
                      name="matplotlib") from error

from osculate import number_text, palette
from osculate.comb_drawing import DIMENSIONS, is_rounding, size_of, usual_largest
from osculate.combs import SYMBOLS, UNITS, names_of

#: Values more than so many times as large as what this share of the length stays below are cut off,
#: and how far beyond that the axis reaches.
_OUTSTANDING, _USUAL, _BEYOND = 4.0, 0.98, 1.5

#: An axis shows at least this share of the magnitude of what it has, so that rounding of a constant
#: stays a straight line; and this share of its height stays free above and below.
_LEAST_SPAN, _MARGIN = 0.05, 0.08

#: What is drawn of joins: width, style.
_LINES = {"join": (1.6, "-"), "closing": (1.6, "-"), "knot": (0.7, "-"), "gap": (1.6, (0, (3, 3)))}

#: Margins around the axes and between them, and the height of a row of text, in points; for each
#: point of the text size.
_LEFT, _RIGHT, _BOTTOM, _BETWEEN, _ROW = 4.4, 1.2, 3.2, 2.1, 1.6


@dataclass(frozen=True)
class PlotLook:
    """Colours and words of a plot."""

    ink: str = "#16202b"      #: of text and axes
    paper: str = "#ffffff"    #: behind the whole
    ground: str = "#ffffff"   #: behind the curves
    text_points: float = 9.0
    words: dict = field(default_factory=lambda: {
        "gap": "gap", "cut": "cut, up to {}", "zero": "zero everywhere",
        "missing": "does not exist"})


class PlotDrawing:
    """What is drawn on one Figure."""

    def __init__(self, figure):
        self.figure = figure
        self.axes = {}   #: quantity -> Axes, from top to bottom
        self.cut = ()    #: quantities of which some values are beyond the axis
        self._plot = self.look = None
        self._parts = {}   # quantity -> _Parts
        self._labels = []  # of joins; more than are seen, as they were needed

    def show(self, plot, *, quantities=None, look=PlotLook(), window=None, limits=None):
        """Draws a CurvePlot instead of what was drawn.

        quantities: those that are drawn; None: all that the plot was made for.
        window: (first, last) arc length that is seen; None: all.
        limits: quantity -> (lowest, highest) that is seen; chosen by the values in the window, such
            that a few outstanding ones do not hide the rest, where there are none.

        Raises ValueError for other quantities and for a window without length.
        """
        quantities = names_of(quantities or plot.quantities)
        window = _checked_window(window or (0.0, plot.length))
        self._plot, self._size = plot, size_of([plot.comb])
        with matplotlib.rc_context({"font.size": look.text_points, "svg.fonttype": "path"}):
            if quantities != tuple(self.axes) or look != self.look:
                self.look = look
                self._make_axes(quantities)
        self._ranked = sorted(plot.joins, key=_rank)
        lines = _join_lines(plot.joins)
        for quantity, parts in self._parts.items():
            parts.show(*plot.series(quantity), lines)
        self.see(window, limits)

    def see(self, window, limits=None):
        """Shows another part of the arc length, with limits as for `show`."""
        self.window = window
        self.cut = ()
        for quantity, axes in self.axes.items():
            axes.set_xlim(*window)
            chosen = (limits or {}).get(quantity)
            self._set_limits(quantity, axes, chosen)
        self.arrange()

    def arrange(self):
        """Places axes and labels by the size of the figure."""
        width, height = 72.0 * self.figure.get_size_inches()
        unit = self.look.text_points
        bottom, top = _BOTTOM * unit / height, 1.0 - 2.3 * _ROW * unit / height
        if top - bottom < 0.1 or width < 12.0 * unit:
            return  # too small to show anything
        count = len(self.axes)
        each = (height * (top - bottom) - (count - 1) * _BETWEEN * unit) / count
        self.figure.subplots_adjust(
            left=_LEFT * unit / width, right=1.0 - _RIGHT * unit / width, bottom=bottom, top=top,
            hspace=_BETWEEN * unit / max(each, 1.0))
        for axes in self.axes.values():
            locator = axes.yaxis.get_major_locator()
            if isinstance(locator, MaxNLocator):
                locator.set_params(nbins=max(2, int(each / (2.2 * unit))))
        self._place_labels(width - (_LEFT + _RIGHT) * unit)

    # What is drawn once

    def _make_axes(self, quantities):
        self.figure.clear()
        self.figure.set_facecolor(self.look.paper)
        found = self.figure.subplots(len(quantities), 1, sharex=True, squeeze=False)[:, 0]
        self.axes = dict(zip(quantities, found))
        for axes in found:
            self._dress(axes)
        self._parts = {quantity: _Parts(axes, quantity, self.look, axes is found[0])
                       for quantity, axes in self.axes.items()}
        self._labels = []
        for axes in found[:-1]:
            axes.tick_params(bottom=False)
        found[-1].set_xlabel("s  (mm)", color=self.look.ink, labelpad=2.0)

    def _dress(self, axes):
        ink = self.look.ink
        axes.set_facecolor(self.look.ground)
        axes.tick_params(colors=ink, which="both", labelcolor=ink, length=3.0)
        axes.grid(True, color=ink, alpha=0.13, linewidth=0.6)
        axes.axhline(0.0, color=ink, alpha=0.45, linewidth=0.8)
        axes.margins(0.0)
        axes.set_title("", y=1.0)  # else it is looked for a place for it, which takes long
        for spine in axes.spines.values():
            spine.set_color(ink)
            spine.set_alpha(0.4)

    # Labels of joins, in a row above the curves

    def _place_labels(self, width):
        """Shows the labels that have room, the worst joins first."""
        first, last = self.window
        letter, taken = 0.62 * self.look.text_points, []
        for join in self._ranked:
            place = (join.s - first) / (last - first) * width
            half = 0.5 * letter * len(self._label_of(join)) + 4.0
            if first <= join.s <= last and all(
                    abs(place - other) >= half + other_half for other, other_half in taken):
                self._show_label(len(taken), join)
                taken.append((place, half))
        for label in self._labels[len(taken):]:
            label.set_visible(False)

    def _show_label(self, number, join):
        if number == len(self._labels):
            self._labels.append(self._new_label())
        label = self._labels[number]
        label.set_text(self._label_of(join))
        label.xy = join.s, 1.0
        label.get_bbox_patch().set_facecolor(palette.of_order(join.order))
        label.set_visible(True)

    def _new_label(self):
        top = next(iter(self.axes.values()))
        return top.annotate(
            " ", (0.0, 1.0), (0.0, 3.0), top.get_xaxis_transform(), "offset points", va="bottom",
            ha="center", color="#ffffff", weight="bold", annotation_clip=False,
            fontsize=0.85 * self.look.text_points,
            bbox={"edgecolor": "none", "boxstyle": "round,pad=0.25"})

    def _label_of(self, join):
        if join.order >= 0:
            return join.label
        return f"{self.look.words['gap']} {number_text.quantity(join.gap_mm, 'mm', 3)}"

    # Limits of the values

    def _set_limits(self, quantity, axes, chosen):
        lowest, highest, note = self._automatic(quantity)
        is_empty = note in (self.look.words["zero"], self.look.words["missing"])
        if chosen is not None:
            lowest, highest = chosen
            note = note if is_empty else ""
        axes.set_ylim(lowest, highest)
        axes.yaxis.set_major_locator(FixedLocator((0.0,)) if is_empty else MaxNLocator(nbins=3))
        power = 0 if is_empty else _power(max(abs(lowest), abs(highest)))
        axes.yaxis.set_major_formatter(FuncFormatter(
            lambda value, _place: f"{value / 10.0 ** power:.5g}".replace("-", "−")))
        factor = number_text.power_of_ten(power) + " " if power else ""
        parts = self._parts[quantity]
        parts.name.set_text(f"{SYMBOLS[quantity]}  ({factor}{UNITS[quantity]})")
        parts.note.set_text(note)

    def _automatic(self, quantity):
        """(lowest, highest, note) by the values that are seen."""
        comb, s, values = self._plot.comb, self._plot.s, getattr(self._plot.comb, quantity)
        first, last = self.window
        members = numpy.flatnonzero((first <= s) & (s <= last) & numpy.isfinite(values))
        ends = numpy.interp(self.window, s, values)  # of lines that lead out
        seen = numpy.concatenate((values[members], ends[numpy.isfinite(ends)]))
        unit = self._size ** -DIMENSIONS[quantity]
        if not len(seen):
            return -unit, unit, self.look.words["missing"] if self._is_missing(quantity) else ""
        largest = float(numpy.abs(seen).max())
        if is_rounding(largest, quantity, self._size):
            return -unit, unit, self.look.words["zero"]
        most = usual_largest(comb, quantity, members, _USUAL, _OUTSTANDING) or largest
        if most * _OUTSTANDING < largest:
            self.cut += (quantity,)
            most *= _BEYOND
            note = self.look.words["cut"].format(number_text.quantity(largest, UNITS[quantity], 3))
            return *_span(numpy.clip(seen, -most, most), most), note
        return *_span(seen, largest), ""

    def _is_missing(self, quantity):
        return not numpy.isfinite(getattr(self._plot.comb, quantity)).any()


class _Parts:
    """What is drawn on the axes of one quantity, and stays while the plot changes."""

    def __init__(self, axes, quantity, look, is_top):
        color = palette.QUANTITIES[quantity]
        self.curve, = axes.plot((), (), color=color, linewidth=1.8, zorder=3.0,
                                solid_capstyle="round", solid_joinstyle="round")
        self.joins = LineCollection((), transform=axes.get_xaxis_transform(), zorder=2.0)
        axes.add_collection(self.joins, autolim=False)
        up = (_ROW if is_top else 0.0) * look.text_points + 2.0  # above the labels of joins
        self.name, self.note = (axes.annotate(
            "", (place, 1.0), (0.0, up), "axes fraction", "offset points", va="bottom", ha=side,
            color=ink, weight=weight) for place, side, ink, weight in (
                (0.0, "left", color, "bold"), (1.0, "right", look.ink, "normal")))

    def show(self, s, values, lines):
        self.curve.set_data(s, values)
        self.joins.set(**lines)


def _checked_window(window):
    first, last = map(float, window)
    if not first < last:
        raise ValueError(f"window: must be (first, last) with first < last, got {window!r}")
    return first, last


def _join_lines(joins):
    """The properties of a LineCollection."""
    looks = [_LINES["gap" if join.order < 0 else join.kind] for join in joins]
    return {"segments": [((join.s, 0.0), (join.s, 1.0)) for join in joins],
            "colors": [palette.of_order(join.order) for join in joins],
            "linewidths": [width for width, _ in looks],
            "linestyles": [style for _, style in looks]}


def _rank(join):
    """Labels of worse joins come first, those of inner knots last."""
    return join.kind == "knot", join.order, join.s


def _span(values, magnitude):
    """The ends of an axis that shows some values."""
    lowest, highest = float(values.min()), float(values.max())
    lacking = 0.5 * max(_LEAST_SPAN * magnitude - (highest - lowest), 0.0)
    margin = _MARGIN * (highest - lowest + 2.0 * lacking)
    return lowest - lacking - margin, highest + lacking + margin


def _power(magnitude):
    """The power of ten, a multiple of three, that is written beside the axis."""
    if not magnitude > 0.0:
        return 0
    power = 3 * math.floor(math.log10(magnitude) / 3.0)
    return 0 if power in (-3, 0) and magnitude >= 0.01 else power
