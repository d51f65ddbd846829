"""The task panel that makes or edits a Probe."""

from osculate.features.probe import make_object
from osculate.gui.panel.sources_panel import SourcesPanel
from osculate.gui.probe.probe_drag import ProbeDrag
from osculate.gui.probe.probe_form import ProbeForm


class ProbePanel(SourcesPanel):
    """Makes or edits a Probe; every change is seen at once."""

    def __init__(self, document, obj=None):
        super().__init__(document, ProbeForm(), obj)
        self._drag = ProbeDrag(document.Name)
        self._observers.append(self._drag)
        self._drag.moved.connect(self._moved)
        self._drag.let_loose.connect(self.session.settle)
        self._drag.taken_back.connect(self._taken_back)
        self._drag.fixed.connect(self._fixed)
        self.form.special_wanted.connect(self._go_to_special)
        self.form.snap.toggled.connect(self._snap_toggled)
        self.form.follow.toggled.connect(self._follow_toggled)
        self.show()

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def _moved(self, s):
        probe = self._probe()
        if probe is not None:
            self.session.set(Position=s / probe.length)

    def _taken_back(self):
        self.session.give_up()
        self.form.follow.setChecked(False)

    def _fixed(self):
        self.form.follow.setChecked(False)

    def _follow_toggled(self, is_on):
        self._drag.follows = is_on
        if not is_on:
            self.session.settle()

    def _snap_toggled(self, is_on):
        self._drag.snaps = is_on

    def _go_to_special(self, is_forward):
        special = self._probe().next_special(self.session.result.s, is_forward)
        if special is not None:
            self.session.do(Position=special.s / self._probe().length)

    def _probe(self):
        """The CurveProbe; None where there is none."""
        obj = self.session.obj
        return None if obj is None or self.session.result is None else obj.Proxy.probe

    def show(self):
        super().show()
        self._drag.show(self._probe(), self.session.result)

    def keep(self):
        if self._drag.follows:  # until now, and what depends on the point does not know
            self.session.changed.disconnect(self.show)  # the form may be gone
            self.session.settle()
        super().keep()
