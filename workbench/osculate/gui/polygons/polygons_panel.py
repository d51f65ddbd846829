"""The task panel that makes or edits ControlPolygons."""

from osculate.features.control_polygons import make_object
from osculate.gui.panel.sources_panel import SourcesPanel
from osculate.gui.polygons.polygons_form import PolygonsForm


class PolygonsPanel(SourcesPanel):
    """Makes or edits a ControlPolygons; every change is seen at once."""

    def __init__(self, document, obj=None):
        super().__init__(document, PolygonsForm(), obj)
        self.show()

    def make_object(self, document, **settings):
        return make_object(document, **settings)
