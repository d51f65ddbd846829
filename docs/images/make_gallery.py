#!/usr/bin/env python3
"""Draws all pictures of the documentation: runs each make_*pictures.py beside this file.

    python3 docs/images/make_gallery.py              all of them
    python3 docs/images/make_gallery.py comb page    those of which a picture is named

A picture that looks as before keeps its bytes, so that a commit has only what has changed. What the
scripts need is installed by `.ci/setup freecad gui pictures`.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ON_SCREEN = FOLDER.parents[1] / "tests" / "gui" / "on_screen"

#: So many pixels may differ, as a blinking cursor does, by more than a shade.
_PIXELS, _SHADE = 25, "3%"


def pictures_of(script):
    """The names of the pictures that a script draws, as its functions say in their first line:
    "name.png: what is seen".
    """
    first_lines = re.findall(r'^    """((?:\w+\.png(?:, )?)+): ', script.read_text("utf-8"), re.M)
    return [name for line in first_lines for name in re.findall(r"(\w+)\.png", line)]


def scripts():
    """{script: names of its pictures}"""
    return {script: pictures_of(script) for script in sorted(FOLDER.glob("make_*pictures.py"))}


def main(wanted):
    chosen = {script: names for script, names in scripts().items()
              if not wanted or wanted.intersection(names)}
    unknown = wanted.difference(*chosen.values())
    if unknown:
        print(f"no script draws: {', '.join(sorted(unknown))}", file=sys.stderr)
        return 2
    return max([draw(script, names) for script, names in chosen.items()])


def draw(script, names):
    """Runs a script; returns its exit status, or 1 where it did not draw what it says."""
    with tempfile.TemporaryDirectory() as folder:
        before = {name: keep(name, folder) for name in names}
        status = subprocess.run([ON_SCREEN, script]).returncode
        for name, old in before.items():
            status = max(status, settle(name, old))
    return status


def keep(name, folder):
    """Moves a picture away; returns where it is, or None."""
    picture = FOLDER / f"{name}.png"
    if not picture.exists():
        return None
    return picture.replace(Path(folder) / picture.name)


def settle(name, old):
    """Puts the old picture back where the new one looks the same, or is missing."""
    picture = FOLDER / f"{name}.png"
    is_drawn = picture.exists()
    word = "drawn" if is_drawn else "NOT DRAWN"
    if old is not None and (not is_drawn or look_alike(old, picture)):
        picture.write_bytes(old.read_bytes())
        word = "as before" if is_drawn else "NOT DRAWN, the old one stays"
    print(f"{name}.png: {word}", flush=True)
    return 0 if is_drawn else 1


def look_alike(first, second):
    """Whether two pictures have one size and hardly a pixel differs (ImageMagick's `compare`)."""
    found = subprocess.run(["compare", "-metric", "AE", "-fuzz", _SHADE, first, second, "null:"],
                           capture_output=True, text=True)
    return found.returncode < 2 and float(found.stderr.split()[0]) <= _PIXELS


if __name__ == "__main__":
    sys.exit(main(set(sys.argv[1:])))
