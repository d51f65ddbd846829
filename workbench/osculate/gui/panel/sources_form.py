"""The base of the forms of what is drawn along edges: which edges these are."""

from osculate.gui import resources
from osculate.gui.panel.message import Message
from osculate.gui.qt import QtWidgets, Signal, translate


class SourcesForm(QtWidgets.QWidget):
    """Shows the edges of an object; tells what the user changes.

    A subclass adds rows to `rows`, which are seen where there is an object.
    """

    #: Properties to set, as a dict, and whether this ends a step (False while a slider moves).
    edited = Signal(object, bool)
    settled = Signal()             #: ends the step that began with edits
    selection_wanted = Signal(bool)  #: take the selection: instead of the edges (False), or as well

    def __init__(self, title, icon, name):
        """name: of the Qt object."""
        super().__init__()
        self.setWindowTitle(title)
        self.setWindowIcon(resources.icon(icon))
        self.setObjectName(name)
        self.advice, self.trouble, self.warnings = Message(), Message(), Message()
        self.sources = QtWidgets.QLabel()
        self.sources.setWordWrap(True)
        self.replace = QtWidgets.QPushButton(translate("Osculate", "Take selection"))
        self.replace.setToolTip(translate("Osculate", "What is selected takes the place of these "
                                                      "edges"))
        self.add = QtWidgets.QPushButton(translate("Osculate", "Add selection"))
        self.add.setToolTip(translate("Osculate", "What is selected counts as well"))
        self.replace.clicked.connect(lambda: self.selection_wanted.emit(False))
        self.add.clicked.connect(lambda: self.selection_wanted.emit(True))
        self._content = QtWidgets.QWidget()
        self.rows = QtWidgets.QFormLayout(self._content)
        self.rows.setContentsMargins(0, 0, 0, 0)
        self._lay_out()
        self.show_parts(False)

    def _lay_out(self):
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self.replace)
        buttons.addWidget(self.add)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setSpacing(8)
        for widget in (self.advice, self.sources):
            layout.addWidget(widget)
        layout.addLayout(buttons)
        for widget in (self.trouble, self.warnings, self._content):
            layout.addWidget(widget)
        layout.addStretch(1)

    def switches(self, label, texts, columns=1):
        """Check boxes for properties {name: text}, row by row; returns {name: box}. Without a label
        they take the whole width.
        """
        boxes = {}
        grid = QtWidgets.QGridLayout()
        for number, (name, text) in enumerate(texts.items()):
            boxes[name] = box = QtWidgets.QCheckBox(text)
            box.clicked.connect(self._switch(name, box))
            grid.addWidget(box, number // columns, number % columns)
        if label:
            self.rows.addRow(label, grid)
        else:
            self.rows.addRow(grid)
        return boxes

    def _switch(self, name, box):
        return lambda: self.edited.emit({name: box.isChecked()}, True)

    def show_parts(self, has_object):
        """Shows what changes the object only where there is one."""
        for widget in (self.sources, self._content):
            widget.setVisible(has_object)
        self.add.setEnabled(has_object)

    def show_object(self, obj):
        """Shows the edges of an object, and which of them are left out."""
        self.sources.setText(_sources_text(obj))
        self.warnings.say("" if obj.Proxy.result is None else "\n".join(obj.Proxy.problems),
                          "warning")

    def show_trouble(self, sentence):
        """Says why there is no result; nothing if there is."""
        self.trouble.say(sentence, "error")


def _sources_text(obj):
    """"12 edges: Sketch, Pad.Face3"."""
    names = [f"{source.Label}.{sub.rpartition('.')[2]}" if sub else source.Label
             for source, subs in obj.Sources
             for sub in ((subs,) if isinstance(subs, str) else subs or ("",))]
    listed = ", ".join(names[:4]) + (", …" if len(names) > 4 else "")
    if obj.EdgeCount == 1:
        return translate("Osculate", "1 edge: {}").format(listed)
    return translate("Osculate", "{} edges: {}").format(obj.EdgeCount, listed)
