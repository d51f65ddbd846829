"""The commands of Bézier solids, one a file."""

from osculate.gui.commands.solids.attach_solid import AttachSolid
from osculate.gui.commands.solids.check_contact import CheckContact
from osculate.gui.commands.solids.check_validity import CheckValidity
from osculate.gui.commands.solids.elevate_solid import ElevateSolid
from osculate.gui.commands.solids.export_solid import ExportSolid
from osculate.gui.commands.solids.make_solid import MakeSolid
from osculate.gui.commands.solids.project_solid import ProjectSolid
from osculate.gui.commands.solids.solid_from_points import SolidFromPoints
from osculate.gui.commands.solids.solid_to_brep import SolidToBRep
from osculate.gui.commands.solids.subdivide_solid import SubdivideSolid

#: In the order of the toolbar and of the menu.
SOLID_COMMANDS = (MakeSolid, SolidFromPoints, SubdivideSolid, ElevateSolid, AttachSolid,
                  CheckContact, CheckValidity, ProjectSolid, SolidToBRep, ExportSolid)
