"""The task panel that edits the control net of a solid, or makes one from points."""

import FreeCADGui

from osculate import solids
from osculate.features import net_text
from osculate.features.bezier_solid import make_object, settings_of
from osculate.features.control_net import COLUMNS, FOURTH, WEIGHT, value_of
from osculate.gui.qt import QtWidgets, translate
from osculate.gui.solid_panel.net_form import NetForm
from osculate.gui.solid_panel.point_marks import PointMarks
from osculate.gui.solid_panel.session_panel import SessionPanel

#: What a solid from points begins with, in mm.
_FIRST = ((0, 0, 0), (50, 0, 0), (0, 50, 0), (0, 0, 50))


class NetPanel(SessionPanel):
    """Edits a BezierSolid, or makes one where none is given."""

    def __init__(self, document, obj=None):
        title = (translate("Osculate", "Edit {}").format(obj.Label) if obj
                 else translate("Osculate", "Solid from points"))
        self.marks = PointMarks()
        super().__init__(document, NetForm(title), title, obj)
        self._connect()
        if obj is None:
            is_first = not document.Objects
            self.session.create(make_object, **settings_of(solids.tetrahedron(*_FIRST)))
            self.session.obj.ViewObject.Proxy.start_dragging(self.session)
            if is_first:
                FreeCADGui.SendMsgToActiveView("ViewFit")
            self.form.advice.say(translate("Osculate", "Raise the degree and edit the points, or "
                                                       "paste or read a table of them."))
        self.show()

    def _connect(self):
        form = self.form
        form.table.typed.connect(self._typed)
        form.table.refused.connect(lambda sentence: form.advice.say(sentence, "warning"))
        form.table.marked.connect(lambda _rows: self._mark())
        form.degree_wanted.connect(self._raise_degree)
        form.copy.clicked.connect(self._copy)
        form.paste.clicked.connect(
            lambda: self.take_text(QtWidgets.QApplication.clipboard().text()))
        form.open.clicked.connect(self._open)
        form.back.clicked.connect(self.session.back)
        form.forward.clicked.connect(self.session.forward)

    def show_object(self, obj):
        self.form.show_object(obj, self.session.result)
        self.form.show_steps(self.session.can_go_back, self.session.can_go_forward)
        self._mark()

    # What the user does

    def take_text(self, text):
        """Gives the solid the net in a text; says what is wrong with it where that cannot be."""
        try:
            settings = settings_of(value_of(*net_text.read(text)))
        except ValueError as error:
            self.form.advice.say(str(error), "error")
            return
        self.form.advice.say("")
        self.session.do(**settings)

    def take_file(self, path):
        """Gives the solid the net in a file, likewise."""
        try:
            with open(path, encoding="utf-8-sig") as file:
                text = file.read()
        except (OSError, UnicodeDecodeError) as error:
            self.form.advice.say(str(error), "error")
            return
        self.take_text(text)

    def _open(self):
        path = QtWidgets.QFileDialog.getOpenFileName(
            self.form, translate("Osculate", "Read control points"), "",
            translate("Osculate", "Tables (*.csv *.txt *.tsv *.dat);;All files (*)"))[0]
        if path:
            self.take_file(path)

    def _copy(self):
        value = self.session.result
        if value is not None:
            QtWidgets.QApplication.clipboard().setText(net_text.write(value))

    def _typed(self, row, column, number):
        obj = self.session.obj
        self.form.advice.say("")
        if column == WEIGHT:
            weights = list(obj.Weights) or [1.0] * len(obj.Points)
            weights[row] = number
            self.session.do(Weights=weights)
        elif column == FOURTH:
            fourth = list(obj.FourthCoordinates)
            fourth[row] = number
            self.session.do(FourthCoordinates=fourth)
        else:
            points = list(obj.Points)
            points[row][COLUMNS.index(column)] = number
            self.session.do(Points=points)

    def _raise_degree(self, degree):
        value = self.session.result
        if value is not None and degree > value.degree:
            self.session.do(**settings_of(value.elevated(degree - value.degree)))

    def _mark(self):
        obj = self.session.obj
        if obj is not None:
            self.marks.show(obj, self.form.table.marked_rows())

    # The end

    def stop(self, document_closes=False):
        was_open = super().stop(document_closes)
        if was_open:
            self.marks.remove(document_closes)
            if not document_closes:
                self._let_points_go()
        return was_open

    def _let_points_go(self):
        """The points of a new solid were dragged by the panel's wish, not in the edit mode."""
        obj = self.session.obj
        if obj is not None and not self._is_edit:
            obj.ViewObject.Proxy.stop_dragging()
