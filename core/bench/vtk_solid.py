"""Points a second of a Bézier solid beside VTK's vtkBezierTetra, from Python in one run.

    PYTHONPATH=workbench /usr/bin/python3 core/bench/vtk_solid.py

VTK evaluates point by point, and 2 µs of each are the call from Python.
"""
import importlib.util
import tempfile
import timeit
from pathlib import Path

import numpy as np

from osculate import solids

DEGREE = 4
POINTS = 200_000
VTK_POINTS = 500


def cell_of(solid):
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "solid.vtu"
        solid.write_vtu(path)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
    return reader.GetOutput().GetCell(0)


def vtk_seconds(solid, u):
    """The time of VTK for a point."""
    from vtkmodules.vtkCommonCore import reference
    cell = cell_of(solid)
    part, point, weights = reference(0), [0.0] * 3, [0.0] * len(solid.points)
    rows = [list(row[1:]) for row in u]

    def evaluate():
        for row in rows:
            cell.EvaluateLocation(part, row, point, weights)
    return min(timeit.repeat(evaluate, number=1, repeat=5)) / len(rows)


def main():
    solid = solids.random(DEGREE, 1)
    u = np.random.default_rng(1).dirichlet((1, 1, 1, 1), POINTS)
    ours = min(timeit.repeat(lambda: solid.evaluate(u), number=1, repeat=5)) / POINTS
    print(f"solid of degree {DEGREE}, rational: {ours * 1e9:.0f} ns a point")
    if importlib.util.find_spec("vtkmodules") is None:
        print("VTK (python3-vtk9) is not installed")
        return
    theirs = vtk_seconds(solid, u[:VTK_POINTS])
    print(f"vtkBezierTetra: {theirs * 1e9:.0f} ns a point, {theirs / ours:.0f} times as long")


if __name__ == "__main__":
    main()
