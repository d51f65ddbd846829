"""Osculate: the geometric continuity G0 to G4 (and up to G8) of curves: by how much it fails, and
curves that have it.

Works in FreeCADCmd, in FreeCAD's Python console and, with Curve values only, in plain Python:

    import osculate
    report = osculate.analyze(shape.Edges[0], shape.Edges[1])
    print(report)                        # the table
    print(report.order, report.residuals)
    osculate.blend(shape.Edges[0], shape.Edges[1], order=4).edge
    osculate.solids.cone(radius=10, height=30).to_solid()

Lengths are in mm, angles in degrees. Values are immutable and safe to share between threads.
"""

import osculate._compiled  # noqa: F401  (first: it says what to do where _core does not load)
from osculate._core import (
    MAX_ORDER, AuditRow, BezierTetrahedron, BezierTriangle, Construction, ContactReport, Curve,
    DefinitionDetail, FaceMesh, FrenetFrame, JoinReport, JoinSide, JoinWarning, OcctError,
    PointGeometry, SectionMesh, SolidMesh, TolerancePreset, Tolerances, ValidityReport, __version__)
from osculate import solids
from osculate.analysis import VERDICTS, JoinBatch, analyze, analyze_edge, analyze_joins
from osculate.auditing import JOIN_KINDS, AuditColumns, AuditReport, SkippedEdge, audit
from osculate.combs import COMB_QUANTITIES, Comb, CombMark, comb
from osculate.construction import blend, extend, join, match, nu_spline
from osculate.errors import ContactError
from osculate.export import write_csv, write_json
from osculate.fairness import energies
from osculate.plots import PLOT_QUANTITIES, CurvePlot, PlotJoin, PlotPoint, curve_plot

__all__ = [
    "AuditColumns", "AuditReport", "AuditRow", "BezierTetrahedron", "BezierTriangle",
    "COMB_QUANTITIES", "Comb", "CombMark", "Construction", "ContactError", "ContactReport", "Curve",
    "CurvePlot", "DefinitionDetail", "FaceMesh", "FrenetFrame", "JOIN_KINDS", "JoinBatch",
    "JoinReport", "JoinSide", "JoinWarning", "MAX_ORDER", "OcctError", "PLOT_QUANTITIES",
    "PlotJoin", "PlotPoint", "PointGeometry", "SectionMesh", "SkippedEdge", "SolidMesh",
    "TolerancePreset", "Tolerances", "VERDICTS", "ValidityReport", "__version__", "analyze",
    "analyze_edge", "analyze_joins", "audit", "blend", "comb", "curve_plot", "energies", "extend",
    "join", "match", "nu_spline", "solids", "write_csv", "write_json",
]
