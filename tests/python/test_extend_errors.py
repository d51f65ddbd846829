"""Every bad argument of osculate.extend is an error that names the argument and the rule."""
import unittest

from osculate import ContactError, Curve, extend
from support import cubic, quarter_circle

NAN, INFINITE = float("nan"), float("inf")


class ErrorsTest(unittest.TestCase):
    def assert_error(self, kind, pattern, curve=None, **keywords):
        with self.assertRaisesRegex(kind, pattern) as caught:
            extend(curve or cubic(), **keywords)
        self.assertIs(type(caught.exception), kind)

    def test_what_is_no_curve(self):
        for bad in (None, 1, "Edge1", [(0, 0, 0), (1, 0, 0)]):
            with self.assertRaisesRegex(TypeError, "^a: "):
                extend(bad)

    def test_end(self):
        for bad in ("middle", 1, None):
            self.assert_error(ValueError, f"^end: must be 'start' or 'end', got {bad!r}", end=bad)

    def test_order_and_degree(self):
        for bad in (-1, 9):
            self.assert_error(ValueError, "order: must be from 0 to 8", order=bad)
        for bad in ("G3", 3.0, None, (3, 3)):
            self.assert_error(TypeError, "order: must be an integer", order=bad)
        for bad in (0, -3):
            self.assert_error(ValueError, "degree: must be at least 1", degree=bad)
        self.assert_error(ValueError, "degree: must be from 1 to 25", degree=26)
        self.assert_error(TypeError, "degree: must be an integer", degree=5.0)

    def test_a_degree_that_cannot(self):
        self.assert_error(ContactError, "degree 3 can", degree=2)
        self.assert_error(ContactError, "degree 2 can", order=2, degree=1)
        self.assert_error(ContactError, "degree 3 can", cubic().elevated(2), order=5, degree=2)

    def test_numbers(self):
        for name in ("beta", "tangential"):
            for bad in (0, -1):
                self.assert_error(ValueError, f"{name}: .* must be > 0", **{name: (bad,)})
            for bad in (NAN, -INFINITE):
                self.assert_error(ValueError, f"{name}: every number must be finite",
                                  **{name: (1, bad)})
            self.assert_error(ValueError, f"{name}: an end of order 1 has 1 numbers, got 2",
                              order=1, **{name: (1, 0)})
            self.assert_error(TypeError, f"{name}: must be None or a tuple", **{name: 1})
            self.assert_error(TypeError, f"{name}: must be None or a tuple", **{name: "1, 1"})
            self.assert_error(TypeError, f"{name}: must be a number, got str", **{name: ("1",)})

    def test_targets(self):
        for bad in (0, -1, NAN, INFINITE):
            self.assert_error(ValueError, "length: must be finite and > 0", length=bad)
            self.assert_error(ValueError, "parameter: must be finite and > 0", parameter=bad)
        self.assert_error(TypeError, "length: must be a number", length="10")
        self.assert_error(ValueError, "to_point: must be three numbers, got 2", to_point=(1, 2))
        for name in ("to_point", "to_direction", "to_curvature"):
            self.assert_error(ValueError, f"{name}: must be finite", **{name: (0, NAN, 0)})
            self.assert_error(TypeError, f"{name}: ", **{name: "x"})
        self.assert_error(ValueError, "to_direction: must be finite and not zero",
                          to_direction=(0, 0, 0))
        self.assert_error(ValueError, "to_curvature: a number must be .* >= 0", to_curvature=-0.1)

    def test_requests_that_contradict_each_other(self):
        for pattern, given in (
                ("same free numbers", {"beta": (1,), "tangential": (5,)}),
                ("fixes the numbers", {"parametric": True, "beta": (1,)}),
                ("fixes the numbers", {"parameter": 0.5, "tangential": (1,)}),
                ("parameter shortens", {"parametric": True, "parameter": 0.5}),
                ("right angles", {"to_direction": (1, 0, 0), "to_curvature": (0.1, 0, 0)}),
                ("end itself", {"to_point": (20, 20, 10)}),
                ("longer than its chord", {"to_point": (20, 40, 10), "length": 20})):
            self.assert_error(ContactError, pattern, **given)

    def test_flags(self):
        self.assert_error(TypeError, "parametric: must be True or False", parametric=1)
        self.assert_error(TypeError, "natural: must be True or False", natural="yes")
        for bad in ("MVC", "", 1):
            self.assert_error(ValueError, "fairness: must be 'mvc', 'bending' or None",
                              fairness=bad)

    def test_singular_ends(self):
        cusp = Curve.bezier([(-20, 5, 0), (-10, 0, 0), (0, 0, 0), (0, 0, 0)])
        self.assert_error(ContactError, "order: .*singular", cusp)
        self.assert_error(ContactError, "natural: .*singular", cusp, natural=True, order=1)
        self.assert_error(ContactError, "parametric: the curve stops", cusp, order=1,
                          parametric=True)

    def test_chords_and_lengths_that_do_not_exist(self):
        self.assert_error(ContactError, "they fix the chord", quarter_circle(), order=1, degree=1,
                          beta=(1.5,))
        self.assert_error(ContactError, "length: .*100 segments", quarter_circle(), natural=True,
                          length=1e6)


if __name__ == "__main__":
    unittest.main()
