"""How a page looks: the colours of orders, and its style sheet."""

from typing import NamedTuple

import numpy

from osculate import palette
from osculate.analysis import VERDICTS


class Look(NamedTuple):
    """An order as it is named and coloured."""

    name: str     #: "gap", "undecided", "G0", ...
    color: str    #: "#rrggbb", dark enough for white text
    order: int    #: -1 for a gap and for what is undecided from the start

    def misses(self, asked):
        """Whether a join of this look misses the order asked for."""
        return self.order < asked


GAP = Look("gap", palette.GAP, -1)
UNDECIDED = Look("undecided", palette.UNDECIDED, -1)


def of_order(order):
    """The Look of an order from 0."""
    return Look(f"G{order}", palette.of_order(order), order)


def named(name):
    """The Look of a name."""
    return {GAP.name: GAP, UNDECIDED.name: UNDECIDED}.get(name) or of_order(int(name[1:]))


def all_looks(asked):
    """The looks that the joins of an audit can have, the worst first."""
    return [GAP, UNDECIDED, *map(of_order, range(asked + 1))]


def look_of(row):
    """The Look of an AuditRow."""
    if row.order >= 0:
        return of_order(row.order)
    return UNDECIDED if row.verdicts[0] == "undecided" else GAP


def looks_of(columns):
    """(N,) names of looks for AuditColumns."""
    names = numpy.array([GAP.name] + [f"G{k}" for k in range(columns.verdicts.shape[1])],
                        dtype=object)[columns.order.astype(int) + 1]
    open_ = columns.verdicts[:, 0] == VERDICTS.index("undecided")
    return numpy.where((columns.order < 0) & open_, UNDECIDED.name, names)


SHEET = """
:root { color-scheme: light dark; --paper: #fff; --ink: #1c232b; --soft: #5d6875; --rule: #d9dee4;
  --band: #f4f6f8; --side0: SIDE0; --side1: SIDE1; }
@media (prefers-color-scheme: dark) { :root { --paper: #171b20; --ink: #e6eaee; --soft: #9aa6b2;
  --rule: #353d46; --band: #20262d; } }
@media print { :root { color-scheme: only light; --paper: #fff; --ink: #000; --soft: #444;
  --rule: #bbb; --band: #f4f6f8; } }
@page { size: A4; margin: 14mm 12mm; }
* { box-sizing: border-box; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
body { margin: 0 auto; padding: 1.5rem; max-width: 66rem; background: var(--paper);
  color: var(--ink); font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif; }
h1 { margin: 0; font-size: 1.7rem; line-height: 1.2; overflow-wrap: anywhere; }
h2 { margin: 2rem 0 .6rem; font-size: 1.15rem; break-after: avoid; }
.facts { margin: .3rem 0 0; color: var(--soft); overflow-wrap: anywhere; }
.columns { display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 0 2.5rem; }
.warning { margin: 1rem 0 0; padding: .4rem .8rem; border-left: 4px solid #c98a00;
  background: var(--band); overflow-wrap: anywhere; }
.warning ul { margin: .2rem 0; padding-left: 1.2rem; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th { font-weight: 600; text-align: left; color: var(--soft); font-size: .85em; }
td, th { padding: .25rem .6rem .25rem 0; vertical-align: middle; }
.bars td { padding: .12rem .6rem .12rem 0; }
.bars td:nth-child(1) { width: 5.5rem; } .bars td:nth-child(3) { width: 8.5rem; }
.bar { height: .8rem; min-width: 1px; border-radius: 2px; }
.right { text-align: right; white-space: nowrap; }
.badge { display: inline-block; min-width: 2.2rem; padding: 0 .4rem; border-radius: 3px;
  color: #fff; font-size: .85em; font-weight: 600; text-align: center; white-space: nowrap; }
.options .right { white-space: normal; }
.options td { border-bottom: 1px solid var(--rule); }
.worst thead { display: table-header-group; }
.worst th { border-bottom: 2px solid var(--rule); }
.worst td { border-bottom: 1px solid var(--rule); padding: .5rem .7rem .5rem 0; }
.worst tr { break-inside: avoid; }
.worst .rank { font-size: 1.15rem; font-weight: 600; }
.worst small { display: block; color: var(--soft); white-space: nowrap; }
.worst small.wide { white-space: normal; }
.side0, .side1 { white-space: nowrap; }
.side0::before, .side1::before { content: ""; display: inline-block; width: .65em; height: .65em;
  margin-right: .35em; border-radius: 50%; background: var(--side0); }
.side1::before { background: var(--side1); }
figure { margin: 0; break-inside: avoid; }
figcaption { margin-top: .3rem; color: var(--soft); font-size: .88em; }
svg, img { display: block; max-width: 100%; height: auto; }
svg { overflow: hidden; background: var(--paper); border: 1px solid var(--rule);
  border-radius: 4px; }
svg path { fill: none; stroke-linejoin: round; }
.edge { stroke: var(--ink); stroke-width: 10; } .far { opacity: .3; } .middle { opacity: .5; }
.near { opacity: .8; }
.leader { stroke-width: 12; }
rect.number { fill: var(--paper); stroke-width: 15; }
text.number { fill: var(--ink); font: 600 120px system-ui, "DejaVu Sans", sans-serif;
  text-anchor: middle; }
.around { stroke: var(--soft); stroke-width: 10; opacity: .7; }
.curve0, .curve1 { stroke-width: 26; stroke-linecap: round; } .curve0 { stroke: var(--side0); }
.curve1 { stroke: var(--side1); }
.teeth0, .teeth1, .tips0, .tips1 { stroke-width: 8; opacity: .65; }
.tips0, .tips1 { stroke-width: 13; opacity: 1; }
.teeth0, .tips0 { stroke: var(--side0); } .teeth1, .tips1 { stroke: var(--side1); }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr));
  gap: 1rem; }
footer { margin-top: 1.5rem; padding-top: .6rem; border-top: 1px solid var(--rule);
  color: var(--soft); font-size: .88em; }
@media screen and (max-width: 48rem) { .columns { display: block; } body { padding: .8rem; }
  .scroll { overflow-x: auto; } }
@media print { body { padding: 0; max-width: none; font-size: 8pt; } h2 { margin-top: 1rem; }
  figure > svg { max-height: 86mm; margin: 0 auto; } .worst svg { width: 28mm; }
  .worst td { padding: .15rem .7rem .15rem 0; line-height: 1.25; } footer { margin-top: .5rem; }
  .options td { padding: .1rem .6rem .1rem 0; } }
""".replace("SIDE0", palette.SIDES[0]).replace("SIDE1", palette.SIDES[1])
