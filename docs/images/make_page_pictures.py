"""Draws the pictures of the page of an audit beside this file, with Chromium.

    tests/gui/on_screen docs/images/make_page_pictures.py
"""

import os
import subprocess
import sys
import tempfile

import Part

import osculate

FOLDER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, FOLDER)
from pictures import V, run  # noqa: E402  FreeCAD does not look beside a script

#: Blink's numbers of the schemes of colours.
_SCHEMES = {"page": 1, "page_dark": 0}


def main():
    """page.png, page_dark.png: the page of an audit on light and on dark."""
    os.environ["SOURCE_DATE_EPOCH"] = "1767225600"  # the same picture tomorrow
    report = osculate.audit(bracket(), pairs="tangent")
    with tempfile.TemporaryDirectory() as folder:
        page = os.path.join(folder, "page.html")
        report.to_html(page, title="Bracket", worst=4)
        for name, scheme in _SCHEMES.items():
            photograph(page, os.path.join(FOLDER, f"{name}.png"), scheme)


def photograph(page, picture, scheme):
    # Chromium refuses to run as root with its sandbox; the page is our own
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                    f"--blink-settings=preferredColorScheme={scheme}", "--window-size=1100,1590",
                    f"--user-data-dir={os.path.dirname(page)}", f"--screenshot={picture}",
                    f"file://{page}"], check=True, timeout=60, stderr=subprocess.DEVNULL)


def bracket():
    """A plate with rounded corners, a hole and a rib that is a loft of splines."""
    plate = Part.makeBox(80, 50, 8)
    plate = plate.makeFillet(10, [edge for edge in plate.Edges if edge.BoundBox.ZLength > 1])
    plate = plate.cut(Part.makeCylinder(9, 20, V(22, 25, -5)))
    rib = Part.makeLoft([section(x, height) for x, height in ((44, 24), (56, 34), (70, 20))], True)
    return Part.Compound([plate, rib])


def section(x, height):
    curve = Part.BSplineCurve()
    curve.interpolate([V(x, 10, 8), V(x, 17, 8 + 0.7 * height), V(x, 25, 8 + height),
                       V(x, 33, 8 + 0.7 * height), V(x, 40, 8)])
    base = Part.makeLine(V(x, 40, 8), V(x, 10, 8))
    return Part.Wire([curve.toShape(), base])


run(main)
