"""Curve plots as files: SVG, PDF and PNG pictures, and the samples as CSV."""

import csv
import io
import math
import os

from osculate.combs import COMB_QUANTITIES
from osculate.export import replacing

#: The endings that can be written.
PLOT_ENDINGS = (".svg", ".pdf", ".png", ".csv")

_DOTS_PER_INCH = 150


def save_plot(plot, path, *, labels=None, size=(8.0, 7.0), **options):
    """Writes a CurvePlot as a picture, or its samples, as the ending of the path says.

    labels: a text for each curve that was given, for the CSV; None: none.
    size: of the picture in inches. options: as for PlotDrawing.show.

    A CSV has a row for each sample, in the order of s, with the columns curve (its number), label,
    run, s_mm, parameter, x, y, z (mm), the five quantities of a comb, and join: "G0" to "G8" or
    "gap" on both sides of a join or knot. Rows of different runs must not be joined by a line: at a
    knot there are two rows with the same s. What does not exist is empty. Numbers read back as the
    same bits.

    The old file stays where the new one cannot be written. Raises ValueError for another ending or
    a wrong number of labels, OSError, ImportError where there is no matplotlib (not for CSV).
    """
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in PLOT_ENDINGS:
        raise ValueError(f"path: must end with one of {', '.join(PLOT_ENDINGS)}, got "
                         f"{os.path.basename(os.fspath(path))!r}")
    if ending == ".csv":
        _write_csv(plot, path, _checked(plot, labels))
        return
    picture = _picture(plot, ending[1:], size, options)
    with replacing(path, is_binary=True) as file:
        file.write(picture)


def _picture(plot, kind, size, options):
    from osculate.plot_drawing import matplotlib
    from matplotlib.figure import Figure
    figure = Figure(figsize=size)
    plot.draw(figure, **options)
    content = io.BytesIO()
    # Without a date, and with names of parts that do not change, equal plots are equal files.
    with matplotlib.rc_context({"svg.hashsalt": "osculate", "pdf.fonttype": 42}):
        metadata = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}.get(kind)
        figure.savefig(content, format=kind, dpi=_DOTS_PER_INCH, metadata=metadata,
                       facecolor=figure.get_facecolor())
    return content.getvalue()


def _checked(plot, labels):
    if labels is None:
        return [""] * len(plot.curves)
    labels = list(labels)
    if len(labels) != len(plot.curves):
        raise ValueError(f"labels: one for each curve is needed, got {len(labels)} for "
                         f"{len(plot.curves)} curves")
    return labels


def _write_csv(plot, path, labels):
    with replacing(path) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("curve", "label", "run", "s_mm", "parameter", "x", "y", "z",
                         *COMB_QUANTITIES, "join"))
        writer.writerows(_rows(plot, labels))


def _rows(plot, labels):
    comb, joins = plot.comb, _joins_at(plot)
    own = plot.own_parameters().tolist()
    values = [getattr(comb, quantity).tolist() for quantity in COMB_QUANTITIES]
    for run, (first, last, place) in enumerate(comb.runs.tolist()):
        curve = plot.order[place]
        for i in range(first, last + 1):
            join = joins.get(float(plot.s[i]), "") if i in (first, last) else ""
            yield (curve, labels[curve], run, float(plot.s[i]), own[i], *comb.point[i].tolist(),
                   *(_cell(column[i]) for column in values), join)


def _joins_at(plot):
    """The label of the worst join at each s."""
    joins = {}
    for join in sorted(plot.joins, key=lambda join: -join.order):
        joins[join.s] = join.label
    return joins


def _cell(value):
    return "" if math.isnan(value) else value
