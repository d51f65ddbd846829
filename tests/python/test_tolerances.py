"""osculate.Tolerances and its presets."""
import unittest

from osculate import Tolerances

FIELDS = ("gap_mm", "angle_deg", "curvature", "third", "fourth")


def values(tolerances):
    return tuple(getattr(tolerances, field) for field in FIELDS)


class TolerancesTest(unittest.TestCase):
    def test_default_is_the_preset_osculate(self):
        self.assertEqual(values(Tolerances()), (1e-3, 0.1, 0.01, 0.02, 0.05))
        self.assertEqual(Tolerances(), Tolerances.preset("osculate"))
        self.assertEqual(Tolerances().name, "osculate")

    def test_own_values(self):
        tolerances = Tolerances(gap_mm=0.5, third=0.25)
        self.assertEqual(values(tolerances), (0.5, 0.1, 0.01, 0.25, 0.05))
        self.assertEqual(tolerances.name, "custom")
        self.assertEqual(tolerances.metric, "vector")

    def test_values_are_keywords(self):
        with self.assertRaises(TypeError):
            Tolerances(1e-3)

    def test_of_order(self):
        tolerances = Tolerances.preset("exact")
        self.assertEqual([tolerances.of_order(k) for k in range(9)], [1e-7, 1e-6] + [1e-8] * 7)
        with self.assertRaisesRegex(ValueError, "order"):
            tolerances.of_order(9)

    def test_presets_of_the_contract(self):
        names = {preset.name for preset in Tolerances.presets()}
        self.assertEqual(names, {"exact", "osculate", "rhino", "opennurbs", "catia-v5", "icem",
                                 "creo", "occt", "class-a"})
        for preset in Tolerances.presets():
            self.assertEqual(Tolerances.preset(preset.name).name, preset.name)
            self.assertGreater(len(preset.source), 10)

    def test_presets_say_what_they_borrow(self):
        borrowed = {preset.name: preset.borrowed for preset in Tolerances.presets()}
        self.assertEqual(borrowed["osculate"], "")
        self.assertEqual(borrowed["exact"], "")
        self.assertIn("fourth", borrowed["creo"])

    def test_values_from_the_vendors(self):
        self.assertEqual(Tolerances.preset("catia-v5").angle_deg, 0.01)
        self.assertEqual(Tolerances.preset("catia-v5").metric, "maximum")
        self.assertEqual(Tolerances.preset("creo").curvature, 0.1)
        self.assertEqual(Tolerances.preset("occt").metric, "geometric-mean")

    def test_equality_and_hash(self):
        self.assertEqual(Tolerances(gap_mm=2), Tolerances(gap_mm=2.0))
        self.assertNotEqual(Tolerances(gap_mm=2), Tolerances())
        self.assertNotEqual(Tolerances(), None)
        self.assertEqual(len({Tolerances(gap_mm=2), Tolerances(gap_mm=2), Tolerances()}), 2)

    def test_immutable(self):
        for name in FIELDS + ("name", "metric", "note"):
            with self.assertRaises(AttributeError, msg=name):
                setattr(Tolerances(), name, 1)

    def test_repr(self):
        self.assertEqual(repr(Tolerances()),
                         "<osculate.Tolerances osculate: 0.001 mm, 0.1 deg, 0.01, 0.02, 0.05>")

    def test_bad_values_name_argument_and_rule(self):
        for field in FIELDS:
            for bad in (0, -1, float("nan"), float("inf")):
                with self.assertRaisesRegex(ValueError, f"{field}.*finite and > 0"):
                    Tolerances(**{field: bad})
            with self.assertRaisesRegex(TypeError, f"{field}.*number, got str"):
                Tolerances(**{field: "small"})

    def test_unknown_preset_lists_the_presets(self):
        with self.assertRaisesRegex(ValueError, "preset.*osculate.*catia-v5"):
            Tolerances.preset("catia")


if __name__ == "__main__":
    unittest.main()
