"""Osculate: the geometric continuity G0 to G4 (and up to G8) of curves: by how much it fails, and
curves that have it.

Works in FreeCADCmd, in FreeCAD's Python console and, with Curve values only, in plain Python:

    import osculate
    report = osculate.analyze(shape.Edges[0], shape.Edges[1])
    print(report)                        # the table
    print(report.order, report.residuals)
    osculate.blend(shape.Edges[0], shape.Edges[1], order=4).edge

Lengths are in mm, angles in degrees. Values are immutable and safe to share between threads.
"""

import osculate._compiled  # noqa: F401  (first: it says what to do where _core does not load)
from osculate._core import (
    MAX_ORDER, Construction, Curve, DefinitionDetail, FrenetFrame, JoinReport, JoinSide,
    JoinWarning, OcctError, PointGeometry, TolerancePreset, Tolerances, __version__)
from osculate.analysis import VERDICTS, JoinBatch, analyze, analyze_edge, analyze_joins
from osculate.construction import blend, extend, join, nu_spline
from osculate.errors import ContactError
from osculate.export import write_csv, write_json
from osculate.fairness import energies

__all__ = [
    "Construction", "ContactError", "Curve", "DefinitionDetail", "FrenetFrame", "JoinBatch",
    "JoinReport", "JoinSide", "JoinWarning", "MAX_ORDER", "OcctError", "PointGeometry",
    "TolerancePreset", "Tolerances", "VERDICTS", "__version__", "analyze", "analyze_edge",
    "analyze_joins", "blend", "energies", "extend", "join", "nu_spline", "write_csv",
    "write_json",
]
