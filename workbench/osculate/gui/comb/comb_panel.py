"""The task panel that makes or edits a CurvatureComb."""

from osculate.features.curvature_comb import automatic_scale_of, make_object
from osculate.gui.comb.comb_form import CombForm
from osculate.gui.panel.sources_panel import SourcesPanel
from osculate.gui.view_wheel import ViewWheel

_NOTCH = 1.12  # how much longer a notch of the wheel makes the teeth


class CombPanel(SourcesPanel):
    """Makes or edits a CurvatureComb; every change is seen at once."""

    def __init__(self, document, obj=None):
        super().__init__(document, CombForm(), obj)
        self._wheel = ViewWheel(document.Name)
        self._wheel.turned.connect(self._wheel_turned)
        self._observers.append(self._wheel)
        self.show()

    def make_object(self, document, **settings):
        return make_object(document, **settings)

    def _wheel_turned(self, notches):
        if self.session.obj is not None:
            self.session.do(**self.form.scaled_by(_NOTCH ** notches))

    def model_changed(self):
        self._wheel.watch_new_views()
        super().model_changed()

    def show_object(self, obj):
        self.form.show_object(obj, automatic_scale_of(obj))
