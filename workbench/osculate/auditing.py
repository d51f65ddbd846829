"""All joins of a model at once."""

import copy
import json
import operator
import os
from collections.abc import Sequence
from typing import NamedTuple

import numpy

from osculate import _core, shapes
from osculate.export import replacing

#: What the numbers in AuditColumns.kind stand for.
JOIN_KINDS = ("vertex", "knot", "seam")


def audit(shape_or_path, *, order=4, tolerances=None, progress=None, pairs="all", corner_deg=15.0,
          touch_mm=0.01, threads=None):
    """The continuity of all joins of a model, as an AuditReport: where edges meet at a vertex that
    they share, at the inner knots of every edge, and where closed edges close.

    shape_or_path: a Part.Shape of any kind, or the path of a STEP, IGES or BREP file.
    order, tolerances: as for analyze.
    pairs: which edges at a vertex count as a join: "all" pairs; "wire": those that follow each
        other in a wire (edges in no wire pair with each other); "tangent": all pairs but corners,
        where the tangents turn by more than `corner_deg` degrees and there is no gap.
    touch_mm: edges in no wire, as wireframe files give them, share no vertices; their ends join
        where they lie within the gap tolerance, and those that are alone there within `touch_mm`.
        0: at shared vertices only.
    progress: called in this thread with the share done, 0 to 1; where it returns False the audit
        stops, and the report has the joins of a first part of the edges.
    threads: how many the audit may use; None: as many as the machine runs at once. The result does
        not depend on it. The audit runs without the GIL.

    Edges are numbered from 1 as in Edge1, those of a file as Part.read numbers them. An edge that
    has no curve or whose curve cannot be converted is in `skipped`, not an error. A vertex that
    edges share says nothing of their curves: a gap there is a join of order -1.

    A file that makes OpenCASCADE break down ends the process, as it does in FreeCAD; the program
    `osculate audit` survives it.

    Raises TypeError for what is neither shape nor path, ValueError for bad options, a null shape
    and a file that holds no model, OSError for a file that cannot be opened, OcctError (a
    RuntimeError) for what OpenCASCADE throws; an exception from `progress` ends the audit and is
    raised.
    """
    options = _core.AuditOptions(order, tolerances, pairs, corner_deg, touch_mm, threads)
    choices = _choices(order, tolerances, pairs, corner_deg, touch_mm)
    if isinstance(shape_or_path, (str, os.PathLike)):
        path = os.fspath(shape_or_path)
        with open(path, "rb"):  # the errors of Python for what is no file
            pass
        return AuditReport(_core.audit_file(os.fsencode(path), options, progress), path, choices)
    table = shapes.audit_table(shape_or_path, options, progress)
    return AuditReport(table, None, choices, shapes.alias_of(shape_or_path))


def _choices(order, tolerances, pairs, corner_deg, touch_mm):
    """The options of an audit as the schema osculate.audit/1 has them."""
    if not isinstance(tolerances, _core.Tolerances):
        tolerances = _core.Tolerances.preset(tolerances or "osculate")
    fields = ("gap_mm", "angle_deg", "curvature", "third", "fourth")
    return {"order": int(order), "preset": tolerances.name,
            "tolerances": {field: getattr(tolerances, field) for field in fields},
            "scale_mm": None, "pairs": pairs, "touch_mm": float(touch_mm),
            "corner_deg": float(corner_deg) if pairs == "tangent" else None}


class AuditColumns(NamedTuple):
    """The rows of an audit as arrays over N joins; K is the order asked for."""

    kind: numpy.ndarray              #: (N,) uint8: indices into JOIN_KINDS
    edges: numpy.ndarray             #: (N, 2) int32
    order: numpy.ndarray             #: (N,) int8
    parametric_order: numpy.ndarray  #: (N,) int8
    point: numpy.ndarray             #: (N, 3): mm
    verdicts: numpy.ndarray          #: (N, K+1) uint8: indices into VERDICTS
    residuals: numpy.ndarray         #: (N, K+1): mm, degrees, then dimensionless; infinite: none


class SkippedEdge(NamedTuple):
    """An edge whose joins an audit has to leave out."""

    edge: int          #: its number
    degenerated: bool  #: a point of a surface, as the pole of a sphere: nothing is amiss
    reason: str


class AuditReport:
    """What an audit found; made by audit(). str() is a summary with the ten worst joins."""

    def __init__(self, table, source, options, shape=None):
        self._table = table
        self._source = source
        self._options = options
        self._shape = shape

    @property
    def source(self):
        """The path of the file, or None for a shape."""
        return self._source

    @property
    def options(self):
        """What was asked for: a dict as `options` of the schema osculate.audit/1."""
        return copy.deepcopy(self._options)

    @property
    def rows(self):
        """A sequence of AuditRow, by the higher edge number; each is made when it is asked for."""
        return _Rows(self._table)

    @property
    def edge_count(self):
        """How many edges the model has."""
        return self._table.edge_count

    @property
    def skipped(self):
        """A SkippedEdge for each edge that could not be converted."""
        return tuple(SkippedEdge(*entry) for entry in self._table.skipped)

    @property
    def notes(self):
        """Sentences of the reader on a file that it could not read in full."""
        return tuple(self._table.notes)

    @property
    def is_complete(self):
        """False where `progress` stopped the audit."""
        return self._table.is_complete

    @property
    def summary(self):
        """A dict: `edges`, `joins`; how many of each of `kinds`; of `orders`, "gap", "G0", ... up
        to the order asked for; `undecided`; `corners_left_out`; `skipped`.
        """
        counts = json.loads(self._table.summary_json())
        return {"edges": self.edge_count, **counts, "corners_left_out": self._table.corners,
                "skipped": len(self._table.skipped)}

    def worst(self, n=10):
        """A list of the n worst rows, worst first: of lower order, and of the same order farther
        from the next one in units of its tolerance.
        """
        if n < 0:
            raise ValueError(f"n: must be 0 or more, got {n}")
        return self._table.worst(n)

    def columns(self):
        """All rows as arrays: AuditColumns, copies of their own."""
        return AuditColumns(*self._table.columns())

    def analyze(self, row):
        """The JoinReport of a row's join, computed again from the edges."""
        return self._table.join(row)

    def to_csv(self, path):
        """Writes a row for each join, with a header.

        Columns: file, kind, edge1, edge2, end1, end2, parameter, x, y, z, order, parametric_order;
        for each order k gk_verdict and gk_residual; the deviations; warnings (codes, separated by
        spaces). What does not exist is an empty cell; numbers keep their bits. Raises OSError where
        the file cannot be written; the old file then stays.
        """
        with replacing(path) as file:
            self._table.write_csv(file.write)

    def to_json(self, path):
        """Writes the report as JSON, schema osculate.audit/1. Errors as for to_csv."""
        with replacing(path) as file:
            self._table.write_json(file.write)

    def to_html(self, path, *, title=None, worst=12, shape=None, pictures=()):
        """Writes the report as one page: an HTML file that needs no other, light or dark as the
        reader has it, and fit for printing. It has what was audited and how, how many joins of each
        order there are, the model with its joins, and the worst rows with a close-up each.

        title: the name of what was audited; None: that of the file, or "Shape".
        worst: how many rows the table has; None: all. The first 200 have a close-up.
        shape: the audited shape, of a report of a file. Without it the edges that have no join are
            missing in the picture of the model; a report of a shape has it.
        pictures: further PNG, JPEG or SVG files to put into the page: paths, or pairs of a path and
            a caption.

        Raises TypeError and ValueError that name the argument; OSError for a picture that cannot be
        read, and where the page cannot be written; the old file then stays.
        """
        from osculate.page.audit_page import audit_page
        worst = len(self._table) if worst is None else operator.index(worst)
        if worst < 0:
            raise ValueError(f"worst: must be 0 or more, got {worst}")
        text = audit_page(self, self._checked(shape), title, worst, pictures)
        with replacing(path) as file:
            file.write(text)

    def _checked(self, shape):
        """The shape to draw; raises what is wrong with it."""
        if shape is None:
            return self._shape
        if not shapes.is_shape(shape) or shape.isNull():
            raise TypeError("shape: must be the Part.Shape that was audited, got "
                            f"{shapes.described(shape, 'a shape')}")
        if len(shape.Edges) != self.edge_count:
            raise ValueError(f"shape: has {len(shape.Edges)} edges, but the report is of a model "
                             f"of {self.edge_count}")
        return shape

    def __str__(self):
        return self._table.text(10).rstrip("\n")

    def __repr__(self):
        return f"<AuditReport of {len(self._table)} joins of {self.edge_count} edges>"


class _Rows(Sequence):
    """The rows of a table; nothing is copied before it is asked for."""

    def __init__(self, table):
        self._table = table

    def __len__(self):
        return len(self._table)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self._table.row(i) for i in range(*index.indices(len(self)))]
        count = len(self)
        if not -count <= index < count:
            raise IndexError(f"there are {count} rows, got the index {index}")
        return self._table.row(index % count)

    def __repr__(self):
        return f"<{len(self)} rows>"
