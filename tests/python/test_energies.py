"""osculate.energies: circles and lines have closed forms; size and direction do not matter."""

import math
import unittest

import numpy

import osculate
import support

CUBIC = support.cubic()


class EnergiesTest(unittest.TestCase):
    def test_circle(self):
        """kappa = 1/r and |d(kappa n)/ds| = 1/r^2 all the way round."""
        energies = osculate.energies(support.full_circle(7.0))
        turn = 2.0 * math.pi
        self.assertAlmostEqual(energies["length_mm"] / (7.0 * turn), 1.0, delta=1e-9)
        self.assertAlmostEqual(energies["bending"] / turn ** 2, 1.0, delta=1e-8)
        self.assertAlmostEqual(energies["mvc"] / turn ** 4, 1.0, delta=1e-8)

    def test_line(self):
        energies = osculate.energies(osculate.Curve.bezier([(0, 0, 0), (3, 4, 0)]))
        self.assertEqual((energies["bending"], energies["mvc"]), (0.0, 0.0))
        self.assertAlmostEqual(energies["speed"], 0.0, delta=1e-15)
        self.assertAlmostEqual(energies["length_mm"], 5.0, delta=1e-12)

    def test_size_and_direction_do_not_matter(self):
        expected = osculate.energies(CUBIC)
        larger = osculate.Curve.bezier(CUBIC.poles * 1000.0 + numpy.array([5.0, -3.0, 2.0]))
        for curve in (larger, CUBIC.reversed(), CUBIC.elevated(2)):
            for name in ("bending", "mvc", "speed"):
                self.assertAlmostEqual(osculate.energies(curve)[name] / expected[name], 1.0,
                                       delta=1e-7)

    def test_are_those_of_a_construction(self):
        other = osculate.Curve.bezier([(90, 20, 0), (110, 25, 0), (120, 50, 10)])
        result = osculate.blend(CUBIC, other)
        energies = osculate.energies(result.curve)
        self.assertEqual(energies, {name: result.energy[name] for name in energies})
        self.assertEqual(set(result.energy) - set(energies), {"objective"})

    @support.needs_freecad
    def test_edges(self):
        edge = CUBIC.to_edge()
        self.assertEqual(osculate.energies(edge), osculate.energies(CUBIC))

    def test_what_is_no_curve(self):
        with self.assertRaisesRegex(TypeError, "a: "):
            osculate.energies([1.0, 2.0])
