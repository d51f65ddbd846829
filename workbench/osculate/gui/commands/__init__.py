"""The commands of Osculate, one a file."""

import FreeCADGui

from osculate.gui.commands.analyze_join import AnalyzeJoin
from osculate.gui.commands.audit import Audit
from osculate.gui.commands.blend import Blend
from osculate.gui.commands.control_polygons import ControlPolygons
from osculate.gui.commands.curvature_comb import CurvatureComb
from osculate.gui.commands.curve_plot import CurvePlot
from osculate.gui.commands.extend import Extend
from osculate.gui.commands.interpolate import Interpolate
from osculate.gui.commands.join import Join
from osculate.gui.commands.match import Match
from osculate.gui.commands.probe import Probe
from osculate.gui.commands.solids import SOLID_COMMANDS

#: In the order of the toolbar and of the menu.
COMMANDS = (AnalyzeJoin, Audit, CurvatureComb, CurvePlot, Probe, ControlPolygons, Blend, Extend,
            Match, Join, Interpolate)


def register():
    """Makes the commands known to FreeCAD; returns the names of those of curves, and of solids."""
    for command in (*COMMANDS, *SOLID_COMMANDS):
        FreeCADGui.addCommand(command.name, command())
    return tuple([command.name for command in commands] for commands in (COMMANDS, SOLID_COMMANDS))
