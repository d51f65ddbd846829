"""The page: what was audited, how many joins of each order, the model, and the worst joins."""

import os
import sys
import time

import numpy

import osculate
from osculate import number_text
from osculate.page import images, style, words
from osculate.page.closeup import close_up
from osculate.page.markup import page_text, tag
from osculate.page.overview import overview
from osculate.page.strokes import strokes_of

#: So many rows have a close-up; more would make a page that no browser likes.
_PICTURED = 200

_MOST_RESERVATIONS = 12

_NUMBERS = ("gap", "angle", "curvature")
_COLUMNS = ("", "", "join", "order", *_NUMBERS, "warnings")

#: A browser is told what the page holds anyway: no script, nothing from elsewhere.
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"

_READING = ("G0: the ends meet; G1: the tangents agree; G2: the curvature vectors too; G3 and G4: "
            "their first and second derivatives by arc length. Deviations from G2 on are shares. "
            "Close-ups: both sides with their curvature combs in one scale, thin lines are other "
            "edges nearby.")


def audit_page(report, shape, title, worst, pictures):
    """The text of a page; see AuditReport.to_html."""
    title = words.title_of(report) if title is None else title
    extra = images.figures(pictures)
    strokes, undrawn = strokes_of(report, shape)
    rows = list(enumerate(report.worst(worst), start=1))
    body = tag("body", *_heading(report, title), *_reservations(report), _summary(report),
               *_model(report, strokes, undrawn, rows), *_pictures(extra),
               *_worst(_Rows(report, strokes), rows), tag("footer", _READING))
    return page_text(tag("html", _head(title), body, lang="en"))


def _head(title):
    return tag("head", tag("meta", charset="utf-8"),
               tag("meta", http_equiv="Content-Security-Policy", content=_POLICY),
               tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
               tag("meta", name="generator", content=f"osculate {osculate.__version__}"),
               tag("title", f"Audit of {title}"), tag("style", style.SHEET))


def _heading(report, title):
    yield tag("h1", f"Audit of {title}")
    if report.source:
        yield tag("p", report.source, class_="facts")
    yield tag("p", " · ".join([_date(), *_programs()]), class_="facts")


def _date():
    """Now, or what SOURCE_DATE_EPOCH says (https://reproducible-builds.org/specs/source-date-epoch)
    """
    given = os.environ.get("SOURCE_DATE_EPOCH", "")
    moment = time.gmtime(int(given)) if given.isdecimal() else time.localtime()
    return time.strftime("%Y-%m-%d %H:%M %z", moment)


def _programs():
    """Names and versions of what made the page."""
    yield f"osculate {osculate.__version__}"
    if "Part" in sys.modules:
        yield f"OpenCASCADE {sys.modules['Part'].OCC_VERSION}"
    if "FreeCAD" in sys.modules:
        yield "FreeCAD " + ".".join(sys.modules["FreeCAD"].Version()[:3])


def _reservations(report):
    found = list(words.reservations(report))
    if not found:
        return
    more = len(found) - _MOST_RESERVATIONS
    if more > 0:
        found[_MOST_RESERVATIONS:] = [f"… and {more} more."]
    yield tag("div", "Not all of the model is in this report:",
              tag("ul", *(tag("li", text) for text in found)), class_="warning")


def _summary(report):
    summary = report.summary
    heading = (f"{words.counted(summary['joins'], 'join')} of "
               f"{words.counted(summary['edges'], 'edge')}")
    found = tag("div", tag("h2", heading), _bars(summary),
                tag("p", words.kinds(summary), class_="facts"))
    asked = tag("div", tag("h2", "How it was checked"), _options(report.options))
    return tag("section", found, asked, class_="columns")


def _bars(summary):
    most = max(1, *summary["orders"].values())
    return tag("table", *(_bar(name, count, count / most, count / max(summary["joins"], 1))
                          for name, count in summary["orders"].items()), class_="bars")


def _bar(name, count, length, share):
    look = style.named(name)
    bar = tag("div", class_="bar", style=f"width:{100.0 * length:.2f}%;background:{look.color}")
    return tag("tr", tag("td", _badge(look)), tag("td", bar if count else None),
               tag("td", f"{count:,} ({100.0 * share:.1f} %)", class_="right"))


def _badge(look):
    return tag("span", look.name, class_="badge", style=f"background:{look.color}")


def _options(choices):
    return tag("table", *(tag("tr", tag("td", name), tag("td", value, class_="right"))
                          for name, value in words.options(choices)), class_="options")


def _model(report, strokes, undrawn, rows):
    columns = report.columns()
    if not len(strokes) and not len(columns.order):
        return
    asked = report.options["order"]
    numbered = [(str(rank), row) for rank, row in rows[:_PICTURED] if row.order < asked]
    caption = ["Dots are joins in the colours above, large where they miss the order asked for"
               + ("; numbers are those of the table below." if numbered else ".")
               if len(columns.order) else "",
               f"{words.counted(undrawn, 'edge')} without a join not drawn." if undrawn else ""]
    yield tag("h2", "The model")
    yield tag("figure", overview(strokes, columns, asked, numbered),
              tag("figcaption", " ".join(filter(None, caption))))


def _pictures(figures):
    if figures:
        yield tag("h2", "Pictures")
        yield tag("div", *figures, class_="pictures")


def _worst(table, rows):
    if not rows:
        return
    yield tag("h2", _worst_heading(len(rows), len(table.report.rows)))
    head = tag("thead", tag("tr", *(tag("th", name, class_="right" if name in _NUMBERS else None)
                                    for name in _COLUMNS)))
    body = tag("tbody", *(table.row(rank, row) for rank, row in rows))
    yield tag("div", tag("table", head, body, class_="worst"), class_="scroll")


def _worst_heading(count, joins):
    if count == joins:
        return "The only join" if joins == 1 else f"All {count:,} joins, the worst first"
    return "The worst join" if count == 1 else f"The {count:,} worst joins"


class _Rows:
    """Makes rows of the table of joins."""

    def __init__(self, report, strokes):
        self.report = report
        self._strokes = strokes
        self._size = float(numpy.abs(report.columns().point).max(initial=0.0))

    def row(self, rank, row):
        look = style.look_of(row)
        deviations = words.deviations(row, self.report.options["tolerances"])
        codes = " ".join(warning.code for warning in row.warnings)
        return tag("tr", tag("td", str(rank), class_="rank right"),
                   tag("td", *self._picture(rank, row)), tag("td", *self._join(row)),
                   tag("td", _badge(look), tag("small", words.missing(row), class_="wide")),
                   *(tag("td", text, class_="right") for text in deviations),
                   tag("td", codes or number_text.MISSING))

    def _picture(self, rank, row):
        if rank > _PICTURED:
            return
        found = close_up(self._strokes, row, self.report.analyze(row))
        if found is None:
            return
        yield found.picture
        scale = ("both sides flat" if found.scale is None
                 else f"comb {number_text.number(found.scale)} mm for 1/mm")
        yield tag("small", f"{number_text.number(found.width_mm, 3)} mm wide, {scale}")

    def _join(self, row):
        for side, text in enumerate(words.edges(row)):
            yield tag("div", text, class_=f"side{side}")
        yield tag("small", words.kind(row))
        yield tag("small", words.place(row, self._size))
