#include "osculate/occt/edge_curve.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include "osculate/occt/occt_error.h"
#include "osculate/occt/space_curve.h"
#include "osculate/occt/spline_arrays.h"
#include "osculate/occt/surface_curve.h"

namespace osculate {

namespace {

const TopoDS_Edge& checkedEdge(const TopoDS_Shape& shape) {
  static constexpr std::array kNames{"compound", "compsolid", "solid",  "shell", "face",
                                     "wire",     "edge",      "vertex", "shape"};
  if (shape.IsNull()) throw std::invalid_argument("edge: the shape is null (empty)");
  if (shape.ShapeType() != TopAbs_EDGE) {
    throw std::invalid_argument(std::string("edge: an edge is needed, got a ") +
                                kNames[static_cast<std::size_t>(shape.ShapeType())]);
  }
  const TopoDS_Edge& edge = TopoDS::Edge(shape);
  if (BRep_Tool::Degenerated(edge)) {
    throw std::invalid_argument("edge: is degenerated (a point of a surface), it has no curve");
  }
  return edge;
}

void checkRange(double first, double last) {
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) {
    throw std::invalid_argument("edge: is infinite; trim it to a finite range");
  }
  if (!(first < last)) throw std::invalid_argument("edge: its parameter range is empty");
}

/// The curve without placement and orientation, and the placement that BRep_Tool leaves to the
/// caller.
EdgeCurve unplacedCurve(const TopoDS_Edge& edge, TopLoc_Location& location) {
  double first = 0.0;
  double last = 0.0;
  if (const opencascade::handle<Geom_Curve>& curve =
          BRep_Tool::Curve(edge, location, first, last)) {
    checkRange(first, last);
    return convertCurve(curve, first, last);
  }
  Handle(Geom2d_Curve) pcurve;
  Handle(Geom_Surface) surface;
  BRep_Tool::CurveOnSurface(edge, pcurve, surface, location, first, last);
  if (pcurve.IsNull() || surface.IsNull()) {
    throw std::invalid_argument("edge: has no geometry (neither a curve nor a curve on a surface)");
  }
  checkRange(first, last);
  return convertSurfaceCurve(pcurve, surface, first, last);
}

/// The curve moved by a placement. The rounding of the product, three units for each of the four
/// terms of a coordinate, enters the pole error: it is large where placement and poles cancel.
BSplineCurve placed(const BSplineCurve& curve, const gp_Trsf& placement) {
  Eigen::Affine3d map;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column)
      map(row, column) = placement.Value(row + 1, column + 1);
  }
  map.makeAffine();
  const double scale = std::abs(placement.ScaleFactor());
  const double largest = curve.data().poles.colwise().norm().maxCoeff();
  const double rounding = 6.0 * kUnitRoundoff * (scale * largest + map.translation().norm());
  return curve.transformed(map).withPoleError(scale * curve.poleError() + rounding);
}

}  // namespace

std::string_view name(EdgeCurveKind kind) {
  static constexpr std::array<std::string_view, 8> kNames{
      "bspline", "bezier", "line", "circle", "ellipse", "hyperbola", "parabola", "fitted"};
  return kNames[static_cast<std::size_t>(kind)];
}

EdgeCurve curveFromEdge(const TopoDS_Shape& edge) {
  return translateFailures([&] {
    TopLoc_Location location;
    EdgeCurve result = unplacedCurve(checkedEdge(edge), location);
    if (!location.IsIdentity()) {
      const gp_Trsf& placement = location.Transformation();
      result.curve = placed(result.curve, placement);
      result.errorMm *= std::abs(placement.ScaleFactor());
    }
    if (edge.Orientation() == TopAbs_REVERSED) result.curve = result.curve.reversed();
    return result;
  });
}

TopoDS_Edge edgeFromCurve(const BSplineCurve& curve) {
  return translateFailures([&]() -> TopoDS_Edge {
    BRepBuilderAPI_MakeEdge maker(geomFrom(curve.data()));
    if (!maker.IsDone()) {
      throw OcctError("OpenCASCADE makes no edge of this curve (BRepBuilderAPI_MakeEdge error " +
                      std::to_string(maker.Error()) + ")");
    }
    return maker.Edge();
  });
}

}  // namespace osculate
