"""Reports as files: CSV with one row a join, JSON with one object a join."""

import csv
import json
import os
import tempfile
from contextlib import contextmanager
from itertools import chain

from osculate._core import JoinReport

_FIRST_COLUMNS = ("label", "order", "parametric_order", "requested_order", "preset", "first_end",
                  "second_end", "parameter", "x", "y", "z")
_SIDE_NUMBERS = ("curvature", "torsion", "curvature_rate", "curvature_rate2", "torsion_rate",
                 "linearity")


def write_csv(reports, path, *, labels=None):
    """Writes one row for each JoinReport, with a header.

    Columns: label, order, parametric_order, requested_order, preset, first_end, second_end,
    parameter (of an inner knot), x, y, z (mm, the first curve's end); then for each order k
    gk_verdict, gk_residual, gk_tolerance, gk_uncertainty (mm, degrees, dimensionless); beta1, ...;
    scale_mm; the deviations; first_... and second_... of the numbers of both sides; the verdict of
    each definition; warnings (codes, separated by spaces). A quantity that does not exist is an
    empty cell. Numbers are written so that reading them gives the same bits.

    labels: a text for each report, or None. Raises TypeError for what is no report, ValueError for
    a wrong number of labels, OSError where the file cannot be written; the old file then stays.
    """
    rows = [_row(label, report) for label, report in _labelled(reports, labels)]
    columns = list(dict.fromkeys(chain(_FIRST_COLUMNS, *rows)))
    with replacing(path) as file:
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def write_json(reports, path, *, labels=None):
    """Writes a JSON list of the reports (each as JoinReport.to_dict, with `label` if labels are
    given). Arguments and errors as for write_csv.
    """
    entries = [report.to_dict() if label is None else {"label": label, **report.to_dict()}
               for label, report in _labelled(reports, labels)]
    with replacing(path) as file:
        json.dump(entries, file, indent=1, ensure_ascii=False, allow_nan=False)
        file.write("\n")


def _labelled(reports, labels):
    reports = list(reports)
    for report in reports:
        if not isinstance(report, JoinReport):
            raise TypeError(f"reports: must be JoinReport, got {type(report).__name__}")
    labels = [None] * len(reports) if labels is None else list(labels)
    if len(labels) != len(reports):
        raise ValueError(f"labels: one for each report is needed, got {len(labels)} for "
                         f"{len(reports)} reports")
    return zip(labels, reports)


def _row(label, report):
    row = dict(zip(_FIRST_COLUMNS, (
        label, report.order, report.parametric_order, report.requested_order, report.preset,
        *report.ends, report.parameter, *map(float, report.sides[0].point))))
    for order in range(report.requested_order + 1):
        row.update({
            f"g{order}_verdict": report.verdicts[order],
            f"g{order}_residual": report.residuals[order],
            f"g{order}_tolerance": report.tolerances[order],
            f"g{order}_uncertainty": report.uncertainties[order],
        })
    row.update((f"beta{number}", beta) for number, beta in enumerate(report.beta, start=1))
    row["scale_mm"] = report.scale_mm
    row.update(report.deviation)
    for name, side in zip(("first", "second"), report.sides):
        row.update((f"{name}_{number}", getattr(side, number)) for number in _SIDE_NUMBERS)
    row.update(report.definitions)
    row["warnings"] = " ".join(warning.code for warning in report.warnings)
    return row


@contextmanager
def replacing(path, is_binary=False):
    """A file, of text or binary, that takes the place of `path` when all has been written."""
    target = os.path.realpath(path)
    descriptor, draft = tempfile.mkstemp(prefix=".osculate-", dir=os.path.dirname(target))
    try:
        kind = {"mode": "wb"} if is_binary else {"mode": "w", "encoding": "utf-8", "newline": ""}
        with open(descriptor, **kind) as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.chmod(draft, _permissions(target))
        os.replace(draft, target)
    except BaseException:
        os.unlink(draft)
        raise


def _permissions(target):
    """Those of the file that is replaced, or of a new file."""
    try:
        return os.stat(target).st_mode & 0o777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
