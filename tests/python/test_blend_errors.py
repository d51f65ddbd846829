"""Every bad argument of osculate.blend is an error that names the argument and the rule."""
import unittest

from osculate import ContactError, Curve, blend
from blend_tasks import planar_task
from support import cubic, full_circle

NAN, INFINITE = float("nan"), float("inf")


class ErrorsTest(unittest.TestCase):
    def assert_error(self, kind, pattern, *arguments, **keywords):
        with self.assertRaisesRegex(kind, pattern) as caught:
            blend(*(arguments or planar_task()), **keywords)
        self.assertIs(type(caught.exception), kind)

    def test_ends_that_coincide(self):
        halves = cubic().split(0.5)
        self.assert_error(ContactError, "ends: they coincide", *halves)
        self.assert_error(ContactError, "ends: they coincide", full_circle(), full_circle())

    def test_a_degree_that_cannot_carry_the_orders(self):
        for degree in (1, 6, 26):
            self.assert_error(ContactError, "degree: .*from 7 to 25", degree=degree)
        for degree in (0, -3):
            self.assert_error(ValueError, "degree: must be at least 1", degree=degree)
        self.assert_error(TypeError, "degree: must be an integer, got float", degree=9.0)

    def test_a_singular_end_without_the_derivatives(self):
        cusp = Curve.bezier([(-20, 5, 0), (-10, 0, 0), (0, 0, 0), (0, 0, 0)])
        self.assert_error(ContactError, "order: .*singular", cusp, planar_task()[1], order=4,
                          ends=("end", "start"))

    def test_numbers_of_the_ends(self):
        for bad in (0, -1, NAN, INFINITE):
            for beta in (((bad,), ()), ((), (bad,))):
                self.assert_error(ValueError, "beta: beta_1 must be finite and > 0", beta=beta)
        for bad in (NAN, -INFINITE):
            self.assert_error(ValueError, "beta: every number must be finite",
                              beta=((1, bad), ()), fairness=None)

    def test_shapes_of_beta(self):
        self.assert_error(ValueError, "beta: must be a pair, got 1", beta=((1,),))
        self.assert_error(ValueError, "beta: an end of order 1 has 1 numbers, got 2", order=(3, 1),
                          beta=((1,), (1, 0)))
        self.assert_error(ValueError, "beta: an end of order 0 has 0 numbers, got 1", order=0,
                          beta=((1,), ()))
        self.assert_error(TypeError, "beta: must be None or a pair of tuples", beta=(1, 1))
        self.assert_error(TypeError, "beta: must be None or a pair of tuples", beta="1, 1")
        self.assert_error(TypeError, "beta: must be a number, got str", beta=(("1",), ()))

    def test_orders(self):
        for bad in (-1, 9, (3, 9), (-1, 3)):
            self.assert_error(ValueError, "order: must be from 0 to 8 at each end", order=bad)
        self.assert_error(ValueError, "order: must be a pair, got 3", order=(1, 2, 3))
        for bad in ("G3", 3.0, None, (3, "3")):
            self.assert_error(TypeError, "order: must be an integer", order=bad)

    def test_fairness(self):
        for bad in ("MVC", "", 1):
            self.assert_error(ValueError, "fairness: must be 'mvc', 'bending' or None",
                              fairness=bad)

    def test_symmetric(self):
        self.assert_error(TypeError, "symmetric: must be True or False", symmetric=1)

    def test_ends(self):
        self.assert_error(ValueError, "ends: each must be 'start' or 'end', got 'middle'",
                          ends=("middle", "end"))
        self.assert_error(ValueError, "ends: must be a pair, got 3", ends=("end", "start", "end"))
        self.assert_error(TypeError, "ends: must be None or a pair", ends="end")
        self.assert_error(TypeError, "ends: must be 'start', 'end' or", ends=("end", 0.5))
        self.assert_error(ValueError, "ends: the direction must be 'forward' or 'backward'",
                          ends=((0.5, "up"), "start"))
        self.assert_error(TypeError, "ends: t: must be a number", ends=(("0", "forward"), "start"))

    def test_parameters_inside(self):
        for bad in (-0.1, 1.1, NAN, INFINITE):
            self.assert_error(ValueError, r"ends: t must be within the curve's range \(0, 1\]",
                              ends=((bad, "forward"), "start"))
            self.assert_error(ValueError, r"ends: t must be within the curve's range \[0, 1\)",
                              ends=("end", (bad, "backward")))

    def test_a_part_without_length_continues_nothing(self):
        for departure in ((0.0, "forward"), (1.0, "backward")):
            self.assert_error(ValueError, "ends: t must be within", ends=(departure, "start"))

    def test_what_is_no_curve(self):
        for bad in (None, 1, "Edge1", [(0, 0, 0), (1, 0, 0)]):
            self.assert_error(TypeError, "^a: ", bad, cubic())
            self.assert_error(TypeError, "^b: ", cubic(), bad)


if __name__ == "__main__":
    unittest.main()
