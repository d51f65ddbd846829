"""What the tests of probes have in common."""

import samples
from construct_case import ConstructCase
from osculate.gui import colors
from osculate.gui.probe.probe_form import ProbeForm


class ProbeCase(ConstructCase):
    form_type = ProbeForm
    command = "Osculate_Probe"

    def setUp(self):
        super().setUp()
        self.wave = samples.add_edge(self.doc, "Wave", samples.bezier(
            (0, 0, 0), (30, 60, 0), (60, -60, 0), (90, 0, 0)))
        self.doc.recompute()
        self.fit()

    def drawn(self, name, color=colors.CIRCLE):
        """How many pixels of a colour the 3D view has."""
        self.pump()
        return self.count_pixels(self.image(name), color, 8)
