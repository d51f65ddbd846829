"""Reports as text for the clipboard and as files."""

import os
import tempfile

import osculate

_WRITERS = {"csv": osculate.write_csv, "json": osculate.write_json}


def text_of(joins, kind):
    """(JoinPlace, JoinReport) pairs as "csv" or "json" text."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "joins")
        _write(joins, path, kind)
        with open(path, encoding="utf-8") as file:
            return file.read()


def save(joins, path):
    """Writes a .csv or .json file, as the ending says; raises ValueError for others, OSError."""
    kind = os.path.splitext(path)[1].lstrip(".").lower()
    if kind not in _WRITERS:
        raise ValueError(f"{os.path.basename(path)}: the name must end with .csv or .json")
    _write(joins, path, kind)


def _write(joins, path, kind):
    labels = [place.label() for place, _ in joins]
    _WRITERS[kind]([report for _, report in joins], path, labels=labels)
