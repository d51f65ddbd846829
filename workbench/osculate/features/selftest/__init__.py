"""Tests of the document objects that every user can run: freecadcmd -t osculate.features.selftest

They need no GUI and run as well inside FreeCAD's own test framework, which wants all in one module.
"""

from osculate.features.selftest.audit_test import AuditTest, FixTest
from osculate.features.selftest.bezier_solid_test import BezierSolidTest
from osculate.features.selftest.blend_curve_test import BlendCurveTest
from osculate.features.selftest.control_net_test import ControlNetTest, NetTextTest
from osculate.features.selftest.control_polygons_test import ControlPolygonsTest
from osculate.features.selftest.curvature_comb_test import CurvatureCombTest
from osculate.features.selftest.extended_curve_test import ExtendedCurveTest
from osculate.features.selftest.interpolated_curve_test import InterpolatedCurveTest
from osculate.features.selftest.joined_curve_test import JoinedCurveTest
from osculate.features.selftest.joins_test import JoinCheckTest, JoinsTest
from osculate.features.selftest.matched_curve_test import MatchedCurveTest
from osculate.features.selftest.probe_test import ProbeTest
from osculate.features.selftest.solid_brep_test import SolidBRepTest
from osculate.features.selftest.solid_contact_test import SolidContactTest

__all__ = ["AuditTest", "BezierSolidTest", "BlendCurveTest", "ControlNetTest",
           "ControlPolygonsTest", "CurvatureCombTest", "ExtendedCurveTest", "FixTest",
           "InterpolatedCurveTest", "JoinCheckTest", "JoinedCurveTest", "JoinsTest",
           "MatchedCurveTest", "NetTextTest", "ProbeTest", "SolidBRepTest", "SolidContactTest"]
