"""The demo without a screen: analyses, makes a G3 blend; writes report.txt, joins.json, joins.csv
and joins.FCStd.

Run by resources/demo/run inside freecadcmd, which ends with 0 whatever a script raises.
"""
import contextlib
import os
import sys
import time
import traceback
from collections import Counter
from pathlib import Path

import FreeCAD
from numpy.linalg import norm

import osculate
from osculate.features import make_join_check
from osculate.features.edge_link import EdgeLink, edges_of_object
from osculate.features.joins import analyze_links

import construction
import models

OUTPUT = Path(os.environ["OSCULATE_DEMO_OUTPUT"])
TOLERANCES = osculate.Tolerances.preset("osculate")
NEAR_MISS_DEGREES = 10.0


def title(text):
    print(f"\n{text}\n{'=' * len(text)}")


def timed_joins(name, link_groups):
    """The joins of each group of edges; says how many there are of each order."""
    start = time.perf_counter()
    joins = [join for links in link_groups for join in analyze_links(links, 4, TOLERANCES)]
    seconds = time.perf_counter() - start
    orders = Counter(report.order for _place, report in joins)
    counts = ", ".join(f"{'gap' if order < 0 else f'G{order}'} {orders[order]}"
                       for order in sorted(orders))
    title(f"{name}: {len(joins)} joins in {1000 * seconds:.0f} ms: {counts}")
    return joins


def near_misses(joins):
    """Joins that look tangent and are not, the nearest to tangency first."""
    corners = [(report.deviation["tangent_angle_deg"], place, report)
               for place, report in joins if report.order == 0]
    return sorted((corner for corner in corners if corner[0] < NEAR_MISS_DEGREES),
                  key=lambda corner: corner[0])


def show_near_misses(joins):
    rows = near_misses(joins)
    print(f"{len(rows)} joins look tangent and are not, e.g.")
    for angle, place, _report in rows[:5]:
        print(f"  {place.label():40s} {angle:.3f} degrees")
    return [(place, report) for _angle, place, report in rows]


def apart(joins, distance_mm):
    """Those of the joins that are not near one before them."""
    chosen = []
    for place, report in joins:
        if all(norm(report.sides[0].point - other.sides[0].point) > distance_mm
               for _place, other in chosen):
            chosen.append((place, report))
    return chosen


def show_report(place, report):
    print(f"\n{place.label()}\n{report}")


def add_check(document, place):
    first, second = (FreeCAD.getDocument(link.document).getObject(link.object)
                     for link in (place.first, place.second))
    check = make_join_check(document, (first, place.first.sub), (second, place.second.sub),
                            ends=place.ends, knot=place.knot)
    if check.Status != "OK":
        raise RuntimeError(f"{check.Label}: {check.Status}")


def analyse_sample(document):
    pairs = models.add_sample(document)
    joins = timed_joins("Sample", [[EdgeLink.of(feature, "Edge1") for feature in pair]
                                   for pair in pairs])
    for place, report in joins:
        print(f"  {place.label():20s} {report.headline}")
    show_report(*joins[2])
    return joins, joins


def analyse_part(document):
    part = models.add_part(document, "SOT428_DPAK.stp", FreeCAD.Vector(-20, 10, 0))
    joins = timed_joins("SOT428_DPAK.stp", [edges_of_object(part)])
    arcs_to_lines = [join for join in joins if join[1].order == 1]
    show_report(*arcs_to_lines[0])
    return joins, apart(arcs_to_lines, 3.0)[:4]


def blend_part(document, joins):
    """Replaces a join of an arc and a line of the part by a G3 blend."""
    place, report = max((join for join in joins
                         if join[1].order == 1 and join[0].first.object == "SOT428_DPAK"),
                        key=construction.evenness)
    title("A join of the part, made G3")
    construction.show_blend(place, report, *construction.replace_join(document, place))


def analyse_text(document):
    outline = models.add_text(document, "Osculate", 40, FreeCAD.Vector(10, -60, 0))
    joins = timed_joins("DejaVu Sans, \"Osculate\"", [edges_of_object(outline)])
    missed = show_near_misses(joins)
    show_report(*missed[0])
    return joins, apart(missed, 30.0)[:4]


def analyse_and_write():
    document = FreeCAD.newDocument("Osculate")
    joins, checks = [], []
    for analyse in (analyse_sample, analyse_part, analyse_text):
        found, chosen = analyse(document)
        joins += found
        checks += chosen
    blend_part(document, joins)
    for place, _report in checks:
        add_check(document, place)
    labels = [place.label() for place, _report in joins]
    reports = [report for _place, report in joins]
    osculate.write_json(reports, OUTPUT / "joins.json", labels=labels)
    osculate.write_csv(reports, OUTPUT / "joins.csv", labels=labels)
    models.keep_no_backups()
    document.saveAs(str(OUTPUT / "joins.FCStd"))


try:
    with open(OUTPUT / "report.txt", "w", encoding="utf-8") as file, \
            contextlib.redirect_stdout(file):
        analyse_and_write()
    code = 0
except BaseException:
    traceback.print_exc(file=sys.stdout)
    code = 1
sys.stdout.flush()
os._exit(code)
