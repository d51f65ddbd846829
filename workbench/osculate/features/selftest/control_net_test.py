"""Tests of control nets as lists and as text."""

import unittest

from osculate import solids
from osculate.features import net_text
from osculate.features.control_net import (
    MOST_DEGREE, NetError, count_of, degree_of, indices_of, lists_of, value_of)


class ControlNetTest(unittest.TestCase):
    def test_indices_are_those_of_the_core(self):
        for degree in (1, 2, 5):
            core = solids.random(degree, 1).indices
            self.assertEqual([list(index) for index in indices_of(degree)], core)

    def test_degree_follows_from_the_count(self):
        for degree in range(1, MOST_DEGREE + 1):
            self.assertEqual(degree_of(count_of(degree)), degree)
        for count in (0, 1, 3, 5, 560):
            with self.assertRaisesRegex(NetError, f"{count} points are no net"):
                degree_of(count)

    def test_lists_there_and_back(self):
        for value in (solids.random(3, 1), solids.random(2, 1, dimension=4), solids.cone(1, 2),
                      solids.tetrahedron((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))):
            self.assertEqual(value_of(*lists_of(value)), value)

    def test_an_error_has_its_place(self):
        points, weights, fourth = lists_of(solids.cone(1, 2))
        weights[4] = -2.0
        with self.assertRaises(NetError) as caught:
            value_of(points, weights, fourth)
        self.assertEqual((caught.exception.row, caught.exception.column), (4, "weight"))


class NetTextTest(unittest.TestCase):
    def read(self, text):
        return value_of(*net_text.read(text))

    def test_there_and_back_to_the_bit(self):
        for value in (solids.random(3, 1), solids.random(2, 1, dimension=4),
                      solids.tetrahedron((0.1, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))):
            self.assertEqual(self.read(net_text.write(value)), value)

    def test_plain_numbers(self):
        expected = solids.tetrahedron((0, 0, 0), (1.5, 0, 0), (0, 1, 0), (0, 0, 1))
        for text in ("0 0 0\n1.5 0 0\n0 1 0\n0 0 1\n", "0,0,0\n1.5,0,0\n0,1,0\n0,0,1",
                     "0; 0; 0\n1,5; 0; 0\n0; 1; 0\n0; 0; 1", "0, 0, 0\n1.5, 0, 0\n0, 1, 0\n0, 0, 1",
                     "# corners\n\n0\t0\t0\n1,5\t0\t0\n\n0\t1\t0\n0\t0\t1\n"):
            with self.subTest(text):
                self.assertEqual(self.read(text), expected)

    def test_columns_by_their_number(self):
        row = " 1 2 3 {}\n"
        for more, weights, fourth in (("", 0, 0), ("7", 4, 0), ("8 7", 4, 4)):
            points, got_weights, got_fourth = net_text.read(row.format(more) * 4)
            self.assertEqual(points, [(1, 2, 3)] * 4)
            self.assertEqual(got_weights, [7.0] * weights)
            self.assertEqual(got_fourth, [8.0] * fourth)

    def test_columns_by_their_names(self):
        points, weights, fourth = net_text.read("w z y x\n" + "2 3 4 5\n" * 4)
        self.assertEqual((points[0], weights[0], fourth), ((5, 4, 3), 2.0, []))
        points, weights, fourth = net_text.read("x1 x2 x3 x4\n" + "2 3 4 5\n" * 4)
        self.assertEqual((points[0], weights, fourth[0]), ((2, 3, 4), [], 5.0))

    def test_indices_sort(self):
        lines = net_text.write(solids.random(3, 1)).splitlines()
        self.assertEqual(self.read("\n".join([lines[0], *reversed(lines[1:])])),
                         solids.random(3, 1))

    def test_what_is_wrong_is_named(self):
        net = net_text.write(solids.random(2, 1)).splitlines()
        for text, words in (
                ("", "no table"), ("1 2\n" * 4, "2 numbers in a row"),
                ("1 2 3\n" * 5, "5 points are no net"),
                ("1 2 3\n1 2 3\n1 2\n1 2 3", "Line 3: 3 numbers are needed, not 2"),
                ("1 2 3\n1 two 3\n1 2 3\n1 2 3", "Line 2: y must be a number, not “two”"),
                ("a b c\n" + "1 2 3\n" * 4, "names no columns"),
                ("x y z x\n" + "1 2 3 4\n" * 4, "names no columns"),
                ("\n".join([*net[:-1], net[1]]), "Two rows have the index 2 0 0 0"),
                ("\n".join([*net[:-1], net[-1].replace("2", "3", 1)]), "0 0 0 3 is no index")):
            with self.subTest(words), self.assertRaisesRegex(NetError, words):
                net_text.read(text)
