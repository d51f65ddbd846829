"""The whole model with its joins in the colours of their orders."""

import numpy

from osculate.page import drawing, labels, style
from osculate.page.drawing import FINE
from osculate.page.markup import tag
from osculate.page.strokes import samples
from osculate.page.view import fitted

_WIDTH, _HEIGHTS, _MARGIN = 1000, (180, 640), 34

#: Far, middle, near: nearer lines are stronger.
_LAYERS = ("far", "middle", "near")

#: Diameter of a join that meets the order asked for, and of the others. With very many joins the
#: dots shrink, or nothing would be seen but dots.
_SMALL, _LARGE, _MANY = 4.0, 7.0, 1500

#: Dots that have shrunk so much are drawn once where several nearly coincide.
_TINY = 0.5


def overview(strokes, columns, asked, numbered):
    """A picture of Strokes and of the joins in AuditColumns.

    asked: the order asked for. numbered: (text, AuditRow) for the joins that have a number.
    """
    points = numpy.concatenate((strokes.ends, strokes.middles, columns.point))
    view = fitted(points, _WIDTH, _HEIGHTS, _MARGIN)
    return drawing.svg(view, "The edges of the model; dots are joins",
                       *_edges(view, strokes), *_joins(view, columns, asked),
                       *_numbers(view, numbered))


def _edges(view, strokes):
    depths = view.depth(strokes.middles)
    least, most = depths.min(initial=numpy.inf), depths.max(initial=-numpy.inf)
    share = (depths - least) / (most - least) if most > least else numpy.ones(len(depths))
    layers = numpy.minimum(share * len(_LAYERS), len(_LAYERS) - 1).astype(int)
    is_point = strokes.sizes() < view.unit
    for number, name in enumerate(_LAYERS):
        of_layer = layers == number
        yield drawing.dots(view.project(strokes.middles[of_layer & is_point]), FINE,
                           class_=f"edge {name}")
        lines = [samples(strokes.all[i], view.unit)
                 for i in numpy.flatnonzero(of_layer & ~is_point)]
        yield drawing.path([view.project(line) for line in lines], class_=f"edge {name}")


def _joins(view, columns, asked):
    """Dots, the worst on top."""
    shrink = min(1.0, (_MANY / max(len(columns.order), 1)) ** 0.25)
    grid = 1 if shrink > _TINY else FINE // 2
    places = view.project(columns.point)
    groups = style.looks_of(columns)
    for look in reversed(style.all_looks(asked)):
        size = shrink * (_LARGE if look.misses(asked) else _SMALL) * FINE
        group = places[groups == look.name]
        if len(group):
            yield drawing.dots(group, grid, stroke="var(--paper)",
                               stroke_width=round(size + 2 * FINE))
            yield drawing.dots(group, grid, stroke=look.color, stroke_width=round(size))


def _numbers(view, numbered):
    if not numbered:
        return
    places = view.project([row.point for _, row in numbered])
    found = labels.placed([text for text, _ in numbered], places, view.size)
    for label, (_, row) in zip(found, numbered):
        color = style.look_of(row).color
        yield tag("line", class_="leader", stroke=color,
                  **dict(zip(("x1", "y1", "x2", "y2"), _fine(*label.place, *label.center))))
    for label, (_, row) in zip(found, numbered):
        yield from _box(label, style.look_of(row).color)


def _box(label, color):
    (x, y), (width, height) = label.center, label.size
    place = dict(zip(("x", "y", "width", "height"),
                     _fine(x - 0.5 * width, y - 0.5 * height, width, height)))
    yield tag("rect", class_="number", rx=4 * FINE, stroke=color, **place)
    yield tag("text", label.text, class_="number", **dict(zip("xy", _fine(x, y + 4.3))))


def _fine(*values):
    return [round(value * FINE) for value in values]
