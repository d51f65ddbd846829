"""The widgets of the panel of an Audit, from top to bottom."""

from osculate.features.tolerance_choice import values_of
from osculate.gui import resources
from osculate.gui.audit.audit_options import AuditLook, AuditOptions
from osculate.gui.audit.audit_summary import AuditSummary, Found
from osculate.gui.audit.audit_table import AuditTable
from osculate.gui.audit.filter_bar import FilterBar
from osculate.gui.panel.analysis import Options
from osculate.gui.panel.message import Message
from osculate.gui.panel.section import Section
from osculate.gui.panel.toggle_button import ToggleButton
from osculate.gui.qt import Qt, QtCore, QtGui, QtWidgets, Signal, translate


class AuditForm(QtWidgets.QWidget):
    """Shows an Audit; tells what the user changes and asks for."""

    edited = Signal(object)          #: properties to set, as a dict
    selection_wanted = Signal(bool)  #: take the selection: instead of the objects (False), or too
    row_chosen = Signal(int)         #: the index of a row that was clicked
    row_wanted = Signal(int)         #: of one that was double-clicked
    match_wanted = Signal()
    export_wanted = Signal(str)      #: "csv", "json" or "html"

    def __init__(self, preferences):
        super().__init__()
        self.setWindowTitle(translate("Osculate", "Audit"))
        self.setWindowIcon(resources.icon("audit"))
        self.setObjectName("OsculateAuditPanel")
        self.advice, self.trouble, self.warnings = Message(), Message(), Message()
        self.sources = QtWidgets.QLabel()
        self.sources.setWordWrap(True)
        self.replace = QtWidgets.QPushButton(translate("Osculate", "Take selection"))
        self.replace.setToolTip(translate("Osculate", "Audit what is selected, instead"))
        self.add = QtWidgets.QPushButton(translate("Osculate", "Add selection"))
        self.add.setToolTip(translate("Osculate", "Audit what is selected, as well"))
        self.summary = AuditSummary()
        self.filter = FilterBar()
        self.table = AuditTable()
        self.reason = Message()  # why the current row cannot be matched
        self.options = AuditOptions(Options(preferences.order, preferences.preset,
                                            values_of(preferences.preset)))
        self.look = AuditLook()
        self._make_buttons()
        self._audited, self._required = None, 0
        self._lay_out()
        self._connect()
        self.show_parts(False)

    def _make_buttons(self):
        self.zoom = ToggleButton()
        self.zoom.setText(translate("Osculate", "Zoom"))
        self.zoom.setToolTip(translate("Osculate", "Go to each join that is clicked; a "
                                                   "double-click always does"))
        self.zoom.setChecked(True)
        self.match = _button("match", translate("Osculate", "Match…"))
        self.csv = _button("", "CSV…")
        self.csv.setToolTip(translate("Osculate", "Save all joins as CSV"))
        self.json = _button("", "JSON…")
        self.json.setToolTip(translate("Osculate", "Save all joins as JSON"))
        self._make_page_button()
        self.buttons = QtWidgets.QWidget()
        layout = QtWidgets.QGridLayout(self.buttons)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for button, place in ((self.zoom, (0, 0, 1, 3)), (self.match, (0, 3, 1, 3)),
                              (self.csv, (1, 0, 1, 2)), (self.json, (1, 2, 1, 2)),
                              (self.page, (1, 4, 1, 2))):
            button.setSizePolicy(QtWidgets.QSizePolicy.Policy.Expanding,
                                 QtWidgets.QSizePolicy.Policy.Fixed)
            layout.addWidget(button, *place)

    def _make_page_button(self):
        self.page = _button("", translate("Osculate", "Report…"))
        self.page.setToolTip(translate("Osculate", "Save a page with pictures of the worst joins, "
                                                   "to read in a browser"))
        self.page.setPopupMode(self.page.ToolButtonPopupMode.MenuButtonPopup)
        menu = QtWidgets.QMenu(self.page)
        self.with_view = QtGui.QAction(translate("Osculate", "with the 3D view as it is"), menu)
        self.with_view.setCheckable(True)
        self.with_view.setChecked(True)
        menu.addAction(self.with_view)
        self.page.setMenu(menu)

    def _lay_out(self):
        self.sections = (
            Section(translate("Osculate", "What is required"), self.options, "AuditOptions", False),
            Section(translate("Osculate", "3D view"), self.look, "AuditLook", False))
        selection = QtWidgets.QHBoxLayout()
        selection.addWidget(self.replace)
        selection.addWidget(self.add)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setSpacing(6)
        for widget in (self.advice, self.sources):
            layout.addWidget(widget)
        layout.addLayout(selection)
        for widget in (self.trouble, self.warnings, self.summary, self.filter):
            layout.addWidget(widget)
        layout.addWidget(self.table, 1)
        for widget in (self.buttons, self.reason, *self.sections):
            layout.addWidget(widget)
        self._end = QtWidgets.QWidget()  # takes the room that the table does not
        layout.addWidget(self._end, 1)

    def _connect(self):
        self.replace.clicked.connect(lambda: self.selection_wanted.emit(False))
        self.add.clicked.connect(lambda: self.selection_wanted.emit(True))
        self.filter.changed.connect(self._show_rows)
        self.table.chosen.connect(self.row_chosen)
        self.table.wanted.connect(self.row_wanted)
        self.match.clicked.connect(self.match_wanted)
        self.csv.clicked.connect(lambda: self.export_wanted.emit("csv"))
        self.json.clicked.connect(lambda: self.export_wanted.emit("json"))
        self.page.clicked.connect(lambda: self.export_wanted.emit("html"))
        self.options.edited.connect(self.edited)
        self.look.edited.connect(self.edited)

    def show_parts(self, has_object):
        """Shows what needs an object only where there is one."""
        for widget in (self.sources, self.summary, self.filter, self.table, self.buttons,
                       *self.sections):
            widget.setVisible(has_object)
        self._end.setVisible(not has_object)
        self.add.setEnabled(has_object)

    def show_object(self, obj):
        """Shows an Audit and what it found last."""
        self.sources.setText(_sources_text(obj))
        self.options.show_object(obj)
        self.look.show_object(obj)
        self.warnings.say("\n".join(obj.Warnings), "warning")
        audited = obj.Proxy.audited(obj)
        self.summary.show_report(Found.of(obj, audited))
        if audited is self._audited and obj.Required == self._required:
            return
        current = self._current_edges()
        self._audited, self._required = audited, obj.Required
        if audited is not None:
            self.filter.show_choices(obj.Required, audited.rows.highest)
        self._show_rows()
        self.table.show_current(None if current is None or audited is None
                                else audited.rows.index_of(current))

    def show_trouble(self, sentence):
        """Says why there is no new result; nothing if there is."""
        self.trouble.say(sentence, "error")

    def show_match(self, reason):
        """Whether the current row can be matched: an empty text if so, None without a row."""
        self.match.setEnabled(reason == "")
        self.match.setToolTip(reason or translate("Osculate", "Change one of the edges so that "
                                                              "they meet as they should"))
        self.reason.say(reason or "")

    def _current_edges(self):
        index = self.table.current
        return None if index is None or self._audited is None else self._audited.rows.edges[index]

    def _show_rows(self):
        if self._audited is None:
            return
        self.table.show_rows(self._audited, self._required, self.filter.wanted())
        self.filter.show_count(len(self.table.rows_shown.members), len(self._audited.rows))


def _button(icon, text):
    button = QtWidgets.QToolButton()
    button.setText(text)
    if icon:
        button.setIcon(resources.icon(icon))
        button.setIconSize(QtCore.QSize(16, 16))
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    return button


def sources_text(obj):
    """"Body, Sketch, …": what an Audit looks at."""
    names = [source.Label for source, _ in obj.Sources]
    return ", ".join(names[:4]) + (", …" if len(names) > 4 else "")


def _sources_text(obj):
    """The same, and the curves that stand for edges."""
    if not obj.Fixes:
        return sources_text(obj)
    fixes = ", ".join(fix.Label for fix in obj.Fixes[:4]) + (", …" if len(obj.Fixes) > 4 else "")
    return sources_text(obj) + translate("Osculate", "; matched: {}").format(fixes)
