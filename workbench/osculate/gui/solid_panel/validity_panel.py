"""The task panel of Check validity."""

import FreeCAD

from osculate.features.bezier_solid import check_validity
from osculate.gui import colors, numbers
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import QtWidgets, button_bits, translate
from osculate.gui.solid_panel.point_marks import PointMarks
from osculate.gui.solid_panel.solid_form import SolidForm
from osculate.gui.solid_panel.task_panel import TaskPanel
from osculate.gui.solid_panel.validity_words import places_of, verdict_of, where
from osculate.gui.transaction import transaction

_COLORS = {"singular": colors.UNDECIDED, "undecided": colors.UNDECIDED, "inverted": colors.GAP}


class ValidityPanel(TaskPanel):
    """Says of some solids whether they fold over themselves, and marks where."""

    def __init__(self, document, objects):
        self.document = document
        self.label = _ValidityLabel()
        form = SolidForm(translate("Osculate", "Check validity"), "solid-validity", self.label)
        form.label = self.label
        form.facts.hide()
        super().__init__(document, form, ends_well=True)
        self._names = [obj.Name for obj in objects]
        self._marks = [PointMarks() for _ in objects]
        with transaction(document, form.windowTitle()):
            self._show()

    def model_changed(self):
        self._show()

    def _show(self):
        self.is_busy = True
        objects = list(filter(None, map(self.document.getObject, self._names)))
        found = [(obj, *_checked(obj)) for obj in objects]
        for marks in self._marks:
            marks.remove()
        for marks, (obj, report, _problem) in zip(self._marks, found):
            if report is not None:
                places = [_point(obj, place) for place in places_of(report)]
                marks.show_places(obj, [place for place in places if place],
                                  _COLORS.get(report.verdict, colors.MADE))
        self.label.show_report(found)
        self.is_busy = False

    def stop(self, document_closes=False):
        was_open = super().stop(document_closes)
        for marks in self._marks if was_open else ():
            marks.remove(document_closes)
        return was_open

    def getStandardButtons(self):
        return button_bits(QtWidgets.QDialogButtonBox.StandardButton.Close)

    def isAllowedAlterDocument(self):
        return True


class _ValidityLabel(ReportLabel):
    """A paragraph a solid."""

    def html(self, report):
        return "".join(self._paragraph(*found) for found in report)

    def _paragraph(self, obj, report, problem):
        if report is None:
            return f"<p><b>{obj.Label}</b><br>{problem}</p>"
        kind = {"valid": "pass", "inverted": "fail"}.get(report.verdict, "undecided")
        color = colors.VERDICT_TEXT[kind][self.is_dark()]
        lines = [f"<b>{obj.Label}</b>",
                 f'<b style="color:{color}">{verdict_of(report)}</b> {where(report)}',
                 self.faint(_meaning(report))]
        if report.witness is not None:
            point = _point(obj, report.witness)
            lines.insert(2, translate("Osculate", "in space at {} mm").format(
                "; ".join(numbers.number(x, 5) for x in point)) if point else "")
        return f"<p>{'<br>'.join(filter(None, lines))}</p>"


def _meaning(report):
    if report.is_mirrored:
        return translate("Osculate", "Its corners turn the other way; exchange two of them.")
    return {
        "valid": translate("Osculate", "The Jacobian is positive everywhere: proved, not sampled."),
        "singular": translate("Osculate", "The Jacobian is nowhere negative, and 0 there."),
        "inverted": translate("Osculate", "The Jacobian is negative there and positive elsewhere."),
        "undecided": translate("Osculate", "The Jacobian comes so near to 0 there that the work "
                                           "allowed did not decide."),
    }[report.verdict]


def _checked(obj):
    """(report, None) of a BezierSolid, or (None, why there is none)."""
    try:
        return check_validity(obj), None
    except ValueError as error:
        return None, str(error)


def _point(obj, place):
    """The point of a solid at barycentric coordinates; None where it has none."""
    point = obj.Proxy.restore(obj).evaluate(place)
    return FreeCAD.Vector(*point) if all(x == x for x in point) else None
