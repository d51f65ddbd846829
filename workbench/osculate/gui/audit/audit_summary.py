"""What an audit found, in a few lines."""

from typing import NamedTuple

from osculate.gui import colors
from osculate.gui.audit import audit_words
from osculate.gui.panel.report_label import ReportLabel
from osculate.gui.qt import translate
from osculate.gui.verdict import missing_text


class AuditSummary(ReportLabel):
    """How many joins, how many of each order in its colour, the worst, what was left out."""

    def html(self, report):
        lines = [_headline(report), self._orders(report)]
        if report.worst:
            lines.append(translate("Osculate", "Worst: {}").format(report.worst))
        aside = _aside(report)
        if aside:
            lines.append(self.faint(aside))
        return "".join(f'<div style="margin-bottom:3px">{line}</div>' for line in lines)

    @staticmethod
    def _orders(found):
        return "&nbsp; ".join(
            f'<span style="color:{colors.of_order(order)}">■</span>&nbsp;'
            f"{audit_words.order_name(order)}&nbsp;<b>{count:,}</b>"
            for order, count in enumerate(found.orders, -1))


class Found(NamedTuple):
    """The numbers of a document object Audit, which may go while they are shown."""

    joins: int
    edges: int
    below: int     #: joins that are below
    required: int  #: this order
    orders: list   #: how many gaps, G0, G1, ...
    worst: str
    corners: int
    undecided: int

    @classmethod
    def of(cls, obj, audited):
        orders = [obj.Gaps, *(getattr(obj, f"G{order}") for order in range(obj.OrderAsked + 1))]
        worst = _worst(audited) if audited is not None and len(audited.rows) else ""
        return cls(obj.Joins, obj.EdgeCount, obj.OutOfTolerance, obj.Required, orders, worst,
                   obj.Corners, obj.Undecided)


def _headline(found):
    phrase = (translate("Osculate", "{} join of {} edges") if found.joins == 1
              else translate("Osculate", "{} joins of {} edges"))
    joins = phrase.format(f"<b>{found.joins:,}</b>", f"{found.edges:,}")
    name = audit_words.order_name(found.required)
    if found.below:
        return f"{joins}, " + translate("Osculate", "{} below {}").format(
            f"<b>{found.below:,}</b>", name)
    return f"{joins}, " + translate("Osculate", "none below {}").format(name)


def _worst(audited):
    """"Edge3 – Edge4: G1, misses G2 by 12 %"."""
    rows = audited.rows
    index = int(rows.worst()[0])
    missing = missing_text(int(rows.order[index]), audit_words.verdicts_of(rows, index),
                           rows.residuals[index])
    name = audit_words.look_of_row(rows, index).name
    label = audited.model.row_label(audited.report.rows[index])
    text = f"{label}: {name}{', ' if missing else ''}{missing}"
    return text.replace(" mm", "\u00a0mm").replace(" %", "\u00a0%")


def _aside(found):
    parts = []
    if found.corners:
        parts.append(translate("Osculate", "corners left out: {}").format(f"{found.corners:,}"))
    if found.undecided:
        parts.append(translate("Osculate", "undecided: {}").format(f"{found.undecided:,}"))
    return ", ".join(parts)
