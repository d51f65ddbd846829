"""What the tests of this folder share: curves, and what they may find beside a checkout."""
import gc
import os
import sys
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from osculate import Curve

try:
    import FreeCAD
    import Part
except ImportError:
    FreeCAD = Part = None

SHARED = Path(os.environ.get("OSCULATE_SHARED_DIR", Path(__file__).parents[3] / "shared"))

#: A plain Python, from within FreeCAD too.
PYTHON = sys.executable if Path(sys.executable).name.startswith("python") else "/usr/bin/python3"

ALLOWED_GROWTH = 2 ** 20  # bytes; 100,000 leaks of the smallest object are over five of these

needs_freecad = unittest.skipIf(Part is None, "needs FreeCAD's Part module")


def shared_file(name):
    """A file of the reference data; skips the test where there is none."""
    path = SHARED / name
    if not path.exists():
        raise unittest.SkipTest(f"no reference data {name} beside the checkout")
    return path


def cubic():
    """A twisted cubic arch with curvature and torsion at every point."""
    return Curve.bezier([(0, 0, 0), (10, 0, 0), (20, 10, 0), (20, 20, 10)])


def quarter_circle(radius=10.0):
    """From (radius, 0, 0) to (0, radius, 0), as a rational quadratic."""
    return Curve.bezier([(radius, 0, 0), (radius, radius, 0), (0, radius, 0)], [1, 0.5 ** 0.5, 1])


def full_circle(radius=10.0):
    """A rational B-spline of four quarters that begins and ends at (radius, 0, 0)."""
    poles = radius * np.array([(1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 1, 0), (-1, 0, 0),
                               (-1, -1, 0), (0, -1, 0), (1, -1, 0), (1, 0, 0)])
    return Curve.bspline(poles, [0, 1, 2, 3, 4], [3, 2, 2, 2, 3], 2, [1, 0.5 ** 0.5] * 4 + [1])


def spline(spans, seed=1, periodic=False):
    """A cubic B-spline through a random walk that does not turn back, with simple inner knots."""
    steps = np.random.default_rng(seed).uniform((0.5, -1, -1), (1.5, 1, 1), (spans + 3, 3))
    if periodic:
        return Curve.bspline(np.cumsum(steps, axis=0)[:spans], range(spans + 1), [1] * (spans + 1),
                             3, periodic=True)
    ends = [4] + [1] * (spans - 1) + [4]
    return Curve.bspline(np.cumsum(steps, axis=0), range(spans + 1), ends, 3)


def circle_then_line():
    """A quarter circle of radius 10 and a line on its end tangent: G1, curvature 0.1 against 0."""
    return quarter_circle(), Curve.bezier([(0, 10, 0), (-10, 10, 0)])


def assert_same_in_threads(case, function):
    """Fails if a function gives something else in one of four threads that call it together."""
    expected = function()
    with ThreadPoolExecutor(4) as threads:
        for found in threads.map(lambda _: function(), range(16)):
            case.assertEqual(found, expected)


def count_wakes_during(function):
    """How often this thread wakes up while another one runs the function."""
    done = threading.Event()

    def run():
        function()
        done.set()

    thread = threading.Thread(target=run)
    thread.start()
    wakes = 0
    while not done.wait(1e-4):
        wakes += 1
    thread.join()
    return wakes


def assert_no_growth(case, function, count):
    """Fails if calling the function `count` times leaves the process with more memory."""
    for _ in range(count // 10):
        function()
    gc.collect()
    before = _resident_bytes()
    for _ in range(count):
        function()
    gc.collect()
    case.assertLess(_resident_bytes() - before, ALLOWED_GROWTH)


def _resident_bytes():
    """Memory of this process in RAM."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
