"""Between Part shapes and core values: the only file that converts one into the other.

Importing it needs no FreeCAD; a shape can only be at hand once FreeCAD's module Part is loaded.

A shape reaches the core in one of two ways, both exact to the bit where the shape has no placement:

- Part.__toPythonOCC__ (about 3 µs) gives a SWIG proxy of the very same OpenCASCADE shape, whose
  content the core reads in place. It needs FreeCAD and osculate built with the same SWIG runtime.
- Where that is missing, Part.Shape.exportBinary writes the edge to a file (about 25 µs in memory).
  FreeCAD's BREP text is out of the question: it keeps 15 digits.
"""

import contextlib
import functools
import os
import sys
import tempfile

from osculate import _core


def curve_from_edge(edge):
    """The edge's own part of its curve, placed and oriented as the edge, as a Curve.

    Exact (bit for bit for B-spline and Bézier curves that are neither trimmed, placed nor reversed;
    conics as rational curves of degree 2), or fitted to rounding with the error in
    `Curve.pole_error`. The parameter range is the edge's.

    Raises TypeError for what is no edge; ValueError for an edge that is null, degenerated,
    infinite, of zero length or without geometry; OcctError (a RuntimeError) for what OpenCASCADE
    throws.
    """
    if not is_edge(edge):
        raise TypeError(f"edge: a Part.Edge is needed, got {described(edge, 'an edge')}")
    return _handed_over(edge, "curve_from_proxy", "curve_from_binary")


def audit_table(shape, options, progress):
    """The _core.AuditTable of a Part.Shape of any kind.

    Raises TypeError for what is no shape, ValueError for a null one; see osculate.audit.
    """
    if not is_shape(shape):
        raise TypeError("shape_or_path: a Part.Shape or the path of a STEP, IGES or BREP file is "
                        f"needed, got {described(shape, 'a shape')}")
    if shape.isNull():
        raise ValueError("shape_or_path: the shape is null (empty)")
    return _handed_over(shape, "audit_proxy", "audit_binary", options, progress)


def edge_from_curve(curve):
    """A Part.Edge over the whole curve with the same poles, weights and knots, bit for bit.

    Equal weights become none: FreeCAD drops them. Raises TypeError for what is no Curve, ValueError
    for a curve torn at a knot (multiplicity degree + 1) and for one that FreeCAD refuses;
    ImportError where there is no FreeCAD.
    """
    if not isinstance(curve, _core.Curve):
        raise TypeError(f"curve: an osculate.Curve is needed, got {described(curve, 'a curve')}")
    import Part
    multiplicities = curve.multiplicities.tolist()
    if max(multiplicities[1:-1], default=1) > curve.degree:
        raise ValueError("curve: is torn at a knot (multiplicity degree + 1), which no edge can be")
    spline = Part.BSplineCurve()
    weights = [] if curve.weights is None else [curve.weights.tolist()]
    try:
        spline.buildFromPolesMultsKnots([tuple(pole) for pole in curve.poles.tolist()],
                                        multiplicities, curve.knots.tolist(), curve.is_periodic,
                                        curve.degree, *weights)
        return spline.toShape()
    except Part.OCCError as error:
        raise ValueError(f"curve: FreeCAD makes no edge of it: {error}") from error


def solid_from_tetrahedron(solid):
    """A Part.Solid bounded by the exact faces of a BezierTetrahedron.

    Raises TypeError for what is none; ValueError for a solid without volume, in E4 or with a corner
    of weight 0; OcctError where the faces bound no valid solid; ImportError where there is no
    FreeCAD.
    """
    if not isinstance(solid, _core.BezierTetrahedron):
        raise TypeError("solid: an osculate.BezierTetrahedron is needed, got "
                        f"{described(solid, 'a solid')}")
    import Part
    with _temporary_file() as path:
        _core.solid_to_binary(solid, path)
        shape = Part.Shape()
        shape.importBinary(path)
    return shape.Solids[0]


def curve_from(value, name):
    """The Curve itself, or that of an edge; errors speak of the argument as `name`."""
    if isinstance(value, _core.Curve):
        return value
    if not is_edge(value):
        raise TypeError(f"{name}: a Part.Edge or an osculate.Curve is needed, got "
                        f"{described(value, 'an edge')}")
    try:
        return curve_from_edge(value)
    except ValueError as error:
        raise ValueError(str(error).replace("edge:", f"{name}:", 1)) from None


def curves_from(values, name):
    """The Curves of edges or Curves in an iterable, or of a wire from its beginning to its end."""
    part = sys.modules.get("Part")
    if part is not None and isinstance(values, part.Wire):
        values = edges_in_order(values)
    is_one = isinstance(values, _core.Curve) or is_edge(values)
    if is_one or isinstance(values, str) or not hasattr(values, "__iter__"):
        raise TypeError(f"{name}: a list of Part.Edge or osculate.Curve, or a Part.Wire, is "
                        f"needed, got {described(values, 'a list')}")
    return [curve_from(value, f"{name}[{i}]") for i, value in enumerate(values)]


def are_same(a, b):
    """Whether two edges or Curves are one and the same curve in space."""
    if a is b:
        return True
    if isinstance(a, _core.Curve) or isinstance(b, _core.Curve):
        return a == b
    return a.isSame(b)


def edges_in_order(wire):
    """The edges of a Part.Wire from its beginning to its end, each oriented along the wire.

    Degenerated edges (the poles of a sphere) are left out. Raises TypeError for what is no wire,
    ValueError for a wire whose edges do not hang together in one chain by shared vertices.
    """
    part = sys.modules.get("Part")
    if part is None or not isinstance(wire, part.Wire):
        raise TypeError(f"wire: a Part.Wire is needed, got {described(wire, 'a wire')}")
    if wire.isNull():
        raise ValueError("wire: the shape is null (empty)")
    edges = wire.OrderedEdges
    missing = len(wire.Edges) - len(edges)
    if missing > 0:
        raise ValueError(f"wire: its edges are no chain; {missing} of {len(wire.Edges)} do not "
                         "follow from the first ones through shared vertices")
    return [edge for edge in edges if not edge.Degenerated]


def alias_of(shape):
    """The same shape in an object of its own: what is done to the other object, as moving it, is
    not done to this one.
    """
    import Part
    return Part.Compound([shape])


def is_shape(value):
    """Whether the value is a Part.Shape."""
    part = sys.modules.get("Part")
    return part is not None and isinstance(value, part.Shape)


def is_edge(value):
    """Whether the value is a Part.Edge, or a Part.Shape that holds an edge."""
    if not is_shape(value):
        return False
    return (isinstance(value, sys.modules["Part"].Edge)
            or (not value.isNull() and value.ShapeType == "Edge"))


def described(value, wanted):
    """What a person calls the value, with advice where it is a shape that has edges."""
    part = sys.modules.get("Part")
    if part is None or not isinstance(value, part.Shape):
        return f"{type(value).__module__}.{type(value).__name__}".replace("builtins.", "")
    if value.isNull():
        return "a null shape"
    advice = " (take one of its Edges)" if wanted == "an edge" and value.Edges else ""
    return f"a {value.ShapeType.lower()} instead of {wanted}{advice}"


@functools.cache
def _proxy_maker():
    """Part.__toPythonOCC__ where osculate was built with SWIG, else None."""
    if not hasattr(_core, "register_shape_type"):
        return None
    _core.register_shape_type()
    return getattr(sys.modules["Part"], "__toPythonOCC__", None)


def _handed_over(shape, by_proxy, by_file, *arguments):
    """What the function of _core of the one name makes of the shape's proxy or, where this FreeCAD
    was built without SWIG or with another runtime of it, that of the other name of a file.
    """
    to_proxy = _proxy_maker()
    if to_proxy is not None:
        try:
            proxy = to_proxy(shape)
        except sys.modules["Part"].OCCError:
            pass
        else:
            return getattr(_core, by_proxy)(proxy, *arguments)
    with _temporary_file() as path:
        shape.exportBinary(path)
        return getattr(_core, by_file)(path, *arguments)


@contextlib.contextmanager
def _temporary_file():
    """The path of a file that is removed again."""
    handle, path = tempfile.mkstemp(suffix=".bin", dir=_fast_folder())
    os.close(handle)
    try:
        yield path
    finally:
        os.remove(path)


@functools.cache
def _fast_folder():
    """A folder in memory where the system has one (ten times as fast as a disk), else None."""
    return "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
