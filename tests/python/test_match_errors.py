"""Every bad argument of osculate.match is an error that names the argument and the rule."""
import unittest

from osculate import ContactError, Curve, match
from support import cubic, full_circle, spline

NAN, INFINITE = float("nan"), float("inf")


def other():
    return Curve.bezier([(21, 21, 10), (30, 25, 12), (40, 20, 10), (50, 30, 8)])


class ErrorsTest(unittest.TestCase):
    def assert_error(self, kind, pattern, a=None, b=None, **keywords):
        with self.assertRaisesRegex(kind, pattern) as caught:
            match(a or cubic(), b or other(), **keywords)
        self.assertIs(type(caught.exception), kind)

    def test_what_is_no_curve(self):
        for bad in (None, 1, "Edge1", [(0, 0, 0), (1, 0, 0)]):
            with self.assertRaisesRegex(TypeError, "^a: "):
                match(bad, other())
            with self.assertRaisesRegex(TypeError, "^b: "):
                match(cubic(), bad)

    def test_the_same_open_curve_twice(self):
        curve = cubic()
        self.assert_error(ValueError, "^b: is the same curve as a, which is open", curve, curve)

    def test_ends_of_a_closed_curve(self):
        circle = full_circle()
        self.assert_error(ValueError, "^ends: a closed curve meets itself", circle, circle,
                          ends=("end", "end"))

    def test_order_keep_spans_and_degree(self):
        for name in ("order", "keep"):
            for bad in (-1, 9):
                self.assert_error(ValueError, f"{name}: must be from 0 to 8", **{name: bad})
            for bad in ("G3", 3.0, None, (3, 3)):
                self.assert_error(TypeError, f"{name}: must be an integer", **{name: bad})
        for bad in (0, -3):
            self.assert_error(ValueError, "spans: must be at least 1", spans=bad)
            self.assert_error(ValueError, "degree: must be at least 1", degree=bad)
        for name in ("spans", "degree"):
            self.assert_error(TypeError, f"{name}: must be an integer", **{name: 2.5})

    def test_what_cannot_carry_the_order(self):
        self.assert_error(ContactError, "b has degree 3, .* got 2", degree=2)
        self.assert_error(ContactError, "at most|to 25, got 26", degree=26)
        self.assert_error(ContactError, "need at least 9, got 8", order=4, degree=8)
        self.assert_error(ContactError, "order 2 needs at least 3 to change", b=spline(20), spans=1)
        tip = Curve.bezier([(-20, 5, 0), (-10, 0, 0), (0, 0, 0), (0, 0, 0)])
        self.assert_error(ContactError, "order: the curve's end is singular", tip, order=4,
                          ends=("end", "start"))

    def test_beta(self):
        for bad in (0, -1):
            self.assert_error(ValueError, "beta: beta_1 must be finite and > 0", beta=(bad,))
        for bad in (NAN, -INFINITE):
            self.assert_error(ValueError, "beta: every number must be finite", beta=(1, bad))
        self.assert_error(ValueError, "beta: an end of order 1 has 1 numbers, got 2", order=1,
                          beta=(1, 0))
        for bad in (1, "1, 1"):
            self.assert_error(TypeError, "beta: must be None or a tuple of numbers", beta=bad)

    def test_ends(self):
        self.assert_error(TypeError, "ends: must be None or a pair", ends="end")
        for bad in (("end",), ("end", "start", "end")):
            self.assert_error(ValueError, "ends: must be a pair", ends=bad)
        self.assert_error(ValueError, "end", ends=("end", "middle"))
        self.assert_error(ValueError, "ends: t must be within", ends=((7, "forward"), "start"))


if __name__ == "__main__":
    unittest.main()
