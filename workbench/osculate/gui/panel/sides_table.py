"""The numbers of both sides next to each other."""

from osculate.gui import numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate


class SidesTable(ReportLabel):
    """One row for each quantity: its name with unit, both values, their difference."""

    def __init__(self, side_colors):
        super().__init__()
        self._side_colors = side_colors

    def html(self, report):
        heads = ("", *(f'<b style="color:{color}">{number}</b>'
                       for number, color in enumerate(self._side_colors, start=1)), "Δ")
        rows = [self._row(*row) for row in _quantities(report)]
        rows.append((translate("Osculate", "legs on tangent"),
                     *(str(side.linearity) for side in report.sides), ""))
        return self.table(heads, rows, (33, 25, 25, 17)) + self._beta(report)

    def _row(self, name, unit, first, second, difference):
        return (f"{name} {self.faint(unit)}", numbers.number(first), numbers.number(second),
                self.faint(numbers.number(difference, 2)))

    def _beta(self, report):
        known = [beta for beta in report.beta if beta is not None]
        if not known:
            return ""
        listed = ", ".join(f"β<sub>{number}</sub> = {numbers.number(beta)}"
                           for number, beta in enumerate(known, start=1))
        return f"<p>{listed}</p>"


def _quantities(report):
    """(name, unit, first, second, difference) of what both sides can have."""
    first, second = report.sides
    deviation = report.deviation
    curvature = deviation["curvature_relative"]
    yield (translate("Osculate", "radius"), "mm", _radius(first), _radius(second), None)
    yield (translate("Osculate", "curvature"), "mm⁻¹", first.curvature, second.curvature,
           None if curvature is None else abs(first.curvature - second.curvature))
    yield (translate("Osculate", "torsion"), "mm⁻¹", first.torsion, second.torsion,
           deviation["torsion_per_mm"])
    yield ("dκ/ds", "mm⁻²", first.curvature_rate, second.curvature_rate,
           deviation["curvature_rate_per_mm2"])
    yield ("d²κ/ds²", "mm⁻³", first.curvature_rate2, second.curvature_rate2,
           deviation["curvature_rate2_per_mm3"])
    yield ("dτ/ds", "mm⁻²", first.torsion_rate, second.torsion_rate,
           deviation["torsion_rate_per_mm2"])


def _radius(side):
    return 1.0 / side.curvature if side.normal is not None else None
