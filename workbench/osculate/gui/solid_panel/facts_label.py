"""What came out: degree, volume, centroid, whether the solid folds over itself."""

import math

from osculate.features.bezier_solid import CHECKED_DEGREE, warnings_of
from osculate.gui import colors, numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate
from osculate.gui.solid_panel.validity_words import verdict_of, where

_MOST_CHECKED = 8  # solids whose validity is asked for while they are made


class FactsLabel(ReportLabel):
    """Shows some BezierTetrahedra that belong together; `show_report` takes a list of them."""

    def html(self, report):
        rows = [(self.faint(name), text) for name, text in self._facts(report)]
        return self.table(("", ""), rows, (30, 70)) if rows else ""

    def table(self, heads, rows, widths):
        """A table without heads, whose texts may be broken."""
        text = super().table(heads, rows, widths).replace("white-space:nowrap", "")
        return text.replace(self._line("th", [self.faint(head) for head in heads], widths, "")
                            .replace("white-space:nowrap", ""), "")

    def _facts(self, values):
        if not values:
            return
        if len(values) > 1:
            yield translate("Osculate", "Solids"), str(len(values))
        first = values[0]
        kind = (translate("Osculate", "rational") if any(value.is_rational for value in values)
                else translate("Osculate", "polynomial"))
        points = translate("Osculate", "{} points").format(len(first.points))
        yield translate("Osculate", "Degree"), f"{first.degree}, {kind}, {points}"
        if first.dimension == 4:
            yield translate("Osculate", "Space"), translate("Osculate", "four dimensions")
            return
        volume = sum(value.volume() for value in values)
        yield translate("Osculate", "Volume"), numbers.quantity(volume, "mm³", 7)
        if len(values) == 1:
            size = abs(first.points).max()
            yield (translate("Osculate", "Centroid"),
                   "; ".join(numbers.coordinate(float(x), size) for x in first.centroid()))
        if len(values) <= _MOST_CHECKED and first.degree <= CHECKED_DEGREE:
            yield translate("Osculate", "Validity"), self._validity(values)

    def _validity(self, values):
        """The first that is not valid, or that all are."""
        reports = [value.validity() for value in values]
        report = next((report for report in reports if report.verdict != "valid"), reports[0])
        word, place = verdict_of(report), where(report)
        kind = {"valid": "pass", "inverted": "fail"}.get(report.verdict, "undecided")
        color = colors.VERDICT_TEXT[kind][self.is_dark()]
        return f'<b style="color:{color}">{word}</b>' + (f" {place}" if place else "")


def all_warnings(values):
    """The warnings of some values, each once."""
    return list(dict.fromkeys(warning for value in values
                              for warning in warnings_of(value, _volume(value))))


def _volume(value):
    return value.volume() if value.dimension == 3 else math.nan
