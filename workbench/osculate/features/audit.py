"""The document object Audit: all joins of one or more objects, kept up to date with the model."""

from typing import NamedTuple

import FreeCAD
import Part

import osculate
from osculate.audit_rows import AuditRows
from osculate.features.audit_properties import GROUPS, PAIRS, RESULT_GROUPS, STARTS
from osculate.features.audited_model import AuditedModel, whole_shape
from osculate.features.edge_link import LinkError
from osculate.features.edge_overlay import links_of, sources_from
from osculate.features.feature import Feature, make
from osculate.features.long_work import Stopped, long_work
from osculate.features.properties import HIDDEN, READ_ONLY, SHOWN, set_if_changed
from osculate.features.tolerance_choice import CUSTOM, tolerances_of
from osculate.features.tolerance_properties import (
    set_tolerance_editors, take_preset, tolerance_settings, tolerances_in)

translate = FreeCAD.Qt.translate

_MOST_WARNINGS = 20


class Audited(NamedTuple):
    """What an audit of a model found."""

    model: AuditedModel
    report: osculate.AuditReport
    rows: AuditRows


class Audit(Feature):
    """Proxy of an App::FeaturePython; documents name this class.

    A recompute that fails, or that the user stops, keeps the numbers of the last one, and says why
    in Status. `Joins` is set whenever there is a new result.
    """

    groups = GROUPS
    result_groups = RESULT_GROUPS
    starts = STARTS

    last = None          #: Audited of the last recompute that came to its end
    was_stopped = False  #: by the user, the last recompute
    _settings = None     # that `last` was made with
    _refreshes = False   # a recompute is going on
    _is_ahead = False    # a preview made `last`, and no recompute has followed
    _audits = False      # an audit is going on; while its window is open others may ask for it

    def __init__(self, obj):
        super().__init__(obj)
        take_preset(obj)

    def onChanged(self, obj, name):
        if FreeCAD.isRestoring() or not hasattr(obj, "SchemaVersion"):
            return
        if name == "Preset":
            take_preset(obj)
        elif name in ("Pairs", "OrderAsked"):
            self.set_editors(obj)

    def set_editors(self, obj):
        super().set_editors(obj)
        set_tolerance_editors(obj)
        obj.setEditorMode("CornerAngle", SHOWN if obj.Pairs == "tangent" else READ_ONLY)
        for order in range(osculate.MAX_ORDER + 1):
            obj.setEditorMode(f"G{order}", READ_ONLY if order <= obj.OrderAsked else HIDDEN)

    def refresh(self, obj):
        self._refreshes = True
        try:
            return super().refresh(obj)
        finally:
            self._refreshes = False

    def construct(self, obj):
        self.was_stopped = False
        _check_required(obj.Required, obj.OrderAsked)
        model = AuditedModel(links_of(obj), obj.Fixes, keeps_wires=obj.Pairs == "wire")
        settings = (tolerances_in(obj), obj.OrderAsked, obj.Pairs, obj.CornerAngle.Value,
                    obj.TouchDistance.Value)
        if not self._is_known(model, settings):
            self.last, self._settings = self._audit(obj.Label, model, settings), settings
        self._is_ahead = not self._refreshes
        return self.last

    def _is_known(self, model, settings):
        """Whether the last audit serves: for a preview that of the same model and options, for a
        recompute only that of a preview just before it.
        """
        return (self.last is not None and (self._is_ahead or not self._refreshes)
                and settings == self._settings and model.is_same(self.last.model))

    def _audit(self, label, model, settings):
        tolerances, order, pairs, corner_deg, touch_mm = settings
        self._audits = True
        try:
            with long_work(translate("Osculate", "Auditing {}…").format(label)) as progress:
                report = osculate.audit(model.shape, order=order, tolerances=tolerances,
                                        progress=progress, pairs=pairs, corner_deg=corner_deg,
                                        touch_mm=touch_mm)
        finally:
            self._audits = False
        if not report.is_complete:
            self.was_stopped = True
            raise Stopped(translate("Osculate", "The audit was stopped. A recompute begins it "
                                                "again."))
        return Audited(model, report, AuditRows(report, tolerances))

    def put(self, obj, result):
        obj.Joins = len(result.rows)

    def show(self, obj, result):
        rows = result.rows
        set_if_changed(obj, "OutOfTolerance", len(rows.worst(below=obj.Required)))
        set_if_changed(obj, "Gaps", rows.count(-1))
        for order in range(osculate.MAX_ORDER + 1):
            set_if_changed(obj, f"G{order}", rows.count(order))
        summary = result.report.summary
        set_if_changed(obj, "Undecided", summary["undecided"])
        set_if_changed(obj, "Corners", summary["corners_left_out"])
        set_if_changed(obj, "EdgeCount", summary["edges"])
        set_if_changed(obj, "Warnings", list(_warnings(result)))
        self._show_worst(obj, result)

    @staticmethod
    def _show_worst(obj, result):
        worst = result.report.worst(1)
        if not worst:
            obj.WorstOrder, obj.Worst, obj.WorstPosition = obj.OrderAsked, "", FreeCAD.Vector()
            return
        headline = result.report.analyze(worst[0]).headline
        set_if_changed(obj, "WorstOrder", worst[0].order)
        set_if_changed(obj, "Worst", f"{result.model.row_label(worst[0])}: {headline}")
        set_if_changed(obj, "WorstPosition", FreeCAD.Vector(*worst[0].point))

    def look_again(self):
        """The model may be another one, without a recompute: `audited` finds out."""
        self.result, self.error = None, ""

    def audited(self, obj):
        """The Audited of the object as it is now or, where it cannot be had, as it was last; of one
        that was just loaded it is made here. None if there is none.
        """
        return self.last if self._audits else self.restore(obj) or self.last


def make_audit(doc, sources, *, pairs="tangent", corner_deg=15.0, touch_mm=0.01, required=1,
               order=4, preset="osculate", values=None, name="Audit"):
    """Adds an Audit to a document and recomputes it.

    doc:      the App.Document
    sources:  objects of it, whole; an object in an App::Part by (part, "Sketch."). An App::Part
              counts as all that is seen in it.
    pairs, corner_deg, touch_mm, order: as for osculate.audit; here corners are left out unless
              `pairs` says otherwise
    required: the order that joins must have, 0 to 8
    preset:   name of a tolerance preset, or "custom" with `values` (ToleranceValues)

    Raises ValueError before anything is changed. An object without edges is no error here: the
    audit says so in its Status.
    """
    _check(pairs, corner_deg, touch_mm, required, order, preset, values)
    own = tolerance_settings(values) if preset == CUSTOM else {}
    return make_object(
        doc, name=name, Sources=sources_from(sources), Pairs=pairs, CornerAngle=corner_deg,
        TouchDistance=touch_mm, Required=required, OrderAsked=order, Preset=preset, **own)


def make_object(doc, *, name="Audit", **settings):
    """Adds an Audit with some of its properties set, and recomputes it."""
    return make(doc, Audit, name, **settings)


def add_fix(obj, fix):
    """Lets the curve of a MatchedCurve stand for the edge that it changes. The document must be
    recomputed then.
    """
    obj.Fixes = [*obj.Fixes, fix]


def why_not_matched(link):
    """Why no other curve can stand for an edge; an empty text if one can. Raises LinkError."""
    shape = whole_shape(link)
    if not shape.countElement("Face"):
        link.resolve()
        return ""
    try:
        faces = shape.ancestorsOfType(shape.getElement(link.sub.rpartition(".")[2]), Part.Face)
    except Part.OCCError as error:
        raise LinkError(link.missing(link.owner())) from error
    if faces:
        return translate("Osculate", "{} bounds a face of {}: the curve that the face was made "
                                     "from has to change.").format(link.label(),
                                                                   link.owner().Label)
    return ""


def _warnings(result):
    amiss = [entry for entry in result.report.skipped if not entry.degenerated]
    for entry in amiss[:_MOST_WARNINGS]:
        yield translate("Osculate", "{} was left out: {}").format(
            result.model.edge_label(entry.edge), entry.reason)
    if len(amiss) > _MOST_WARNINGS:
        yield translate("Osculate", "{} more edges were left out.").format(
            len(amiss) - _MOST_WARNINGS)


def _check(pairs, corner_deg, touch_mm, required, order, preset, values):
    if pairs not in PAIRS:
        raise ValueError(f"pairs: must be one of {', '.join(PAIRS)}, not {pairs!r}")
    if not 0.0 <= corner_deg <= 180.0:
        raise ValueError(f"corner_deg: must be from 0 to 180, not {corner_deg}")
    if not 0.0 <= touch_mm < float("inf"):
        raise ValueError(f"touch_mm: must be finite and 0 or more, not {touch_mm}")
    for argument, value in (("required", required), ("order", order)):
        if not 0 <= value <= osculate.MAX_ORDER:
            raise ValueError(f"{argument}: must be 0 to {osculate.MAX_ORDER}, not {value}")
    _check_required(required, order)
    if preset == CUSTOM and values is None:
        raise ValueError('values: are needed with the preset "custom"')
    tolerances_of(preset, values)


def _check_required(required, order):
    if required > order:
        raise ValueError(translate(
            "Osculate", "Joins are analysed up to G{} only, which does not tell whether they have "
                        "G{}.").format(order, required))
