"""Every edge of real CAD models: with its neighbours at vertices, and at its own inner knots."""
import itertools
import json
import math
import unittest
from collections import defaultdict
from operator import attrgetter

from osculate import Curve, analyze, analyze_edge
from support import FreeCAD, Part, needs_freecad, shared_file


def edges_of_document(path):
    document = FreeCAD.openDocument(str(path), True)
    try:
        return [edge for obj in document.Objects if hasattr(obj, "Shape")
                for edge in obj.Shape.Edges]
    finally:
        FreeCAD.closeDocument(document.Name)


def edges_of(path):
    return edges_of_document(path) if path.suffix == ".fcstd" else Part.read(str(path)).Edges


def neighbours(edges):
    """Pairs of numbers of edges that share a vertex."""
    at_vertex = defaultdict(list)
    for number, edge in enumerate(edges):
        for vertex in edge.Vertexes:
            at_vertex[vertex.hashCode()].append((vertex, number))
    pairs = set()
    for sharing in at_vertex.values():
        for (vertex, first), (other, second) in itertools.combinations(sharing, 2):
            if first != second and vertex.isSame(other):
                pairs.add((min(first, second), max(first, second)))
    return sorted(pairs)


@needs_freecad
class RealModelsTest(unittest.TestCase):
    def check_report(self, report):
        self.assertTrue(-1 <= report.order <= 4)
        self.assertTrue(all(verdict == "pass" for verdict in report.verdicts[:report.order + 1]))
        if report.order < 4:
            self.assertNotEqual(report.verdicts[report.order + 1], "pass")
        self.assertTrue(math.isfinite(report.residuals[0]))
        json.loads(report.to_json(), parse_constant=self.fail)

    def check_model(self, name, edge_count, least_joins, least_inner_joins):
        edges = edges_of(shared_file(f"data/{name}"))
        self.assertEqual(len(edges), edge_count)
        for edge in filter(attrgetter("Degenerated"), edges):
            with self.assertRaisesRegex(ValueError, "degenerated"):
                Curve.from_edge(edge)
        edges = [edge for edge in edges if not edge.Degenerated]
        joins = [analyze(edges[first], edges[second]) for first, second in neighbours(edges)]
        inner_joins = [report for edge in edges for report in analyze_edge(edge)]
        self.assertGreaterEqual(len(joins), least_joins)
        self.assertGreaterEqual(len(inner_joins), least_inner_joins)
        for report in itertools.chain(joins, inner_joins):
            self.check_report(report)
        return joins, inner_joins

    def test_impeller(self):
        self.check_model("impeller.igs", 4649, 3771, 1420)

    def test_nist(self):
        self.check_model("NIST_MBE_PMI_4.stp", 1212, 2642, 745)

    def test_fuselage_guides(self):
        self.check_model("Fuselage_guides.brep", 360, 288, 3240)

    def test_gordon(self):
        self.check_model("Gordon-1.fcstd", 37, 32, 497)

    def test_propeller(self):
        self.check_model("Propeller.brep", 170, 204, 118)

    def test_mayo_degree_25(self):
        edge = edges_of(shared_file("data/mayo_bezier_curve.brep"))[0]
        curve = Curve.from_edge(edge)
        self.assertEqual(curve.degree, 25)
        report = analyze(*curve.split(0.5 * sum(curve.parameter_range)))
        self.assertGreaterEqual(report.order, 3)

    def test_igesio(self):
        joins, _ = self.check_model("igesio_input.igs", 60, 30, 0)
        self.assertGreaterEqual(max(report.order for report in joins), 2)


if __name__ == "__main__":
    unittest.main()
