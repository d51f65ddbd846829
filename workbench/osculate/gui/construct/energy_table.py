"""How fair the curve is: its energies before the last step and now."""

from osculate.gui import numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate

_MOST_PERCENT = 900.0  # what grows more is shown by its factor


class EnergyTable(ReportLabel):
    """One row for each energy: its name, before, now, the change in percent."""

    def show_energies(self, before, now):
        """Shows dicts as in osculate.Construction.energy; `before` may be None."""
        self.show_report((before or {}, now))

    def html(self, report):
        before, now = report
        heads = (translate("Osculate", "Energy"), translate("Osculate", "Before"),
                 translate("Osculate", "Now"), "Δ")
        rows = [self._row(name, tip, before.get(key), now[key])
                for key, name, tip in _energies()]
        return self.table(heads, rows, (40, 20, 20, 20))

    def _row(self, name, unit, before, now):
        return (f"{name} {self.faint(unit)}", self.faint(numbers.number(before)),
                f"<b>{numbers.number(now)}</b>", self.faint(_change(before, now)))


def _energies():
    """(key, name, unit)."""
    yield "mvc", translate("Osculate", "variation of curvature"), ""
    yield "bending", translate("Osculate", "bending"), ""
    yield "speed", translate("Osculate", "unevenness"), ""
    yield "length_mm", translate("Osculate", "length"), "mm"


def _change(before, now):
    if not before:
        return numbers.MISSING
    percent = 100.0 * (now / before - 1.0)
    if percent > _MOST_PERCENT:
        return f"× {numbers.number(now / before, 3)}"
    return "0 %" if abs(percent) < 0.05 else f"{percent:+.1f} %".replace("-", "−")
