"""osculate.audit on real models: counts and verdicts of every join by a second route."""
import unittest

from osculate import audit
from audit_models import model, rows_of
from support import Part, needs_freecad

if Part is not None:
    from independent_joins import Model, is_clear, order_of

#: Joins at vertices and at inner knots between B-spline edges, as the data's own table counts them.
MODELS = {
    "impeller.igs": (4649, 3771, 1420), "NIST_MBE_PMI_4.stp": (1212, 2786, 745),
    "Fuselage_guides.brep": (360, 288, 3240), "Gordon-1.fcstd": (37, 32, 497),
    "Propeller.brep": (170, 204, 118), "mayo_bezier_curve.brep": (1, 0, 0),
    "igesio_input.igs": (60, 30, 0),
}


@needs_freecad
class SecondRouteTest(unittest.TestCase):
    """Every join of the real models, against independent_joins.py."""

    def assert_same(self, report, row, found):
        """Residuals agree within the uncertainty that the report states, verdicts with them."""
        full = report.analyze(row)
        self.assertEqual(full.residuals, row.residuals)
        for k, (own, other) in enumerate(zip(row.residuals, found)):
            allowed = full.uncertainties[k] + 1e-9 * max(abs(other), 1e-3)
            self.assertLessEqual(abs(own - other), allowed, f"{row.edges}, order {k}")
        if is_clear(found):
            self.assertEqual(row.order, order_of(found), row.edges)

    def check_vertices(self, report, second):
        expected = sorted(second.vertex_joins())
        rows = rows_of(report, "vertex")
        distinct = {(row.edges, row.ends) for row in rows}
        self.assertEqual(sorted(distinct), expected)
        self.assertEqual(len(rows), len(expected))
        for row in rows:
            self.assert_same(report, row, second.vertex_residuals(row.edges, row.ends))

    def check_knots(self, report, second):
        rows = iter(rows_of(report, "knot"))
        for number, spline in second.splines.items():
            for knot in spline.inner_knots():
                row = next(rows)
                self.assertEqual(row.edges, (number, number))
                self.assertAlmostEqual(row.parameter, float(knot), delta=1e-12 * abs(knot) + 1e-15)
                self.assert_same(report, row, second.knot_residuals(number, knot))
        self.assertEqual(list(rows), [])

    def check_counts(self, report, second, expected):
        splines = {number for number, edge in second.edges.items() if not edge.Degenerated
                   and edge.Curve.TypeId == "Part::GeomBSplineCurve"}
        closed = {row.edges[0] for row in rows_of(report, "seam")}
        vertices = {(row.edges, *row.point) if closed & set(row.edges) else (row.edges, row.ends)
                    for row in rows_of(report, "vertex") if splines.issuperset(row.edges)}
        knots = [row for row in rows_of(report, "knot") if row.edges[0] in splines]
        self.assertEqual((report.edge_count, len(vertices), len(knots)), expected)

    def check_model(self, name):
        shape = model(name)
        report, second = audit(shape), Model(shape)
        self.check_counts(report, second, MODELS[name])
        self.check_vertices(report, second)
        self.check_knots(report, second)
        degenerated = [number for number, edge in second.edges.items() if edge.Degenerated]
        self.assertEqual([entry.edge for entry in report.skipped], degenerated)

    def test_impeller(self):
        self.check_model("impeller.igs")

    def test_nist(self):
        self.check_model("NIST_MBE_PMI_4.stp")

    def test_fuselage_guides(self):
        self.check_model("Fuselage_guides.brep")

    def test_gordon(self):
        self.check_model("Gordon-1.fcstd")

    def test_propeller(self):
        self.check_model("Propeller.brep")

    def test_mayo(self):
        self.check_model("mayo_bezier_curve.brep")

    def test_igesio(self):
        self.check_model("igesio_input.igs")


if __name__ == "__main__":
    unittest.main()
