#include "osculate/occt/solid_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include "osculate/bezier/tensor_patch.h"
#include "osculate/occt/edge_curve.h"
#include "osculate/occt/occt_error.h"
#include "osculate/solid/measure.h"

namespace osculate {

namespace {

gp_Pnt pointFrom(const Vector3& p) { return {p.x(), p.y(), p.z()}; }

/// One face with what its edges look like.
class FaceMaker {
 public:
  FaceMaker(const BezierTriangle& triangle, double size)
      : triangle_(triangle), small_(1e-12 * size) {}

  TopoDS_Face make() const {
    if (const std::optional<gp_Pln> plane = planeOfNet()) return planeFace(*plane);
    for (int corner = 0; corner < 3; ++corner) {
      if (isConeFrom(corner)) {
        return patchFace(conePatch(cornerPoint(corner), edge((corner + 1) % 3, (corner + 2) % 3)));
      }
    }
    return patchFace(positivePatch());
  }

 private:
  Vector3 cornerPoint(int corner) const {
    MultiIndex<3> index{};
    index[static_cast<std::size_t>(corner)] = triangle_.degree();
    return triangle_.point(index);
  }

  /// Calls f for the control points of positive weight.
  template <class F>
  void forPoints(F f) const {
    int position = 0;
    for (const MultiIndex<3>& index : multiIndices<3>(triangle_.degree())) {
      if (triangle_.weight(position) > 0.0) f(index, Vector3(triangle_.points().col(position)));
      ++position;
    }
  }

  std::optional<gp_Pln> planeOfNet() const {
    const Vector3 origin = cornerPoint(0);
    Vector3 normal = Vector3::Zero();
    forPoints([&](const MultiIndex<3>&, const Vector3& p) {
      forPoints([&](const MultiIndex<3>&, const Vector3& q) {
        const Vector3 cross = (p - origin).cross(q - origin);
        if (cross.norm() > normal.norm()) normal = cross;
      });
    });
    if (!(normal.norm() > small_ * small_)) return {};
    normal.normalize();
    bool isFlat = true;
    forPoints([&](const MultiIndex<3>&, const Vector3& p) {
      isFlat = isFlat && std::abs(normal.dot(p - origin)) <= small_;
    });
    if (!isFlat) return {};
    return gp_Pln(pointFrom(origin), gp_Dir(normal.x(), normal.y(), normal.z()));
  }

  /// All points but those of the opposite edge are the corner: lines from there to the edge.
  bool isConeFrom(int corner) const {
    const Vector3 apex = cornerPoint(corner);
    bool isCone = true;
    forPoints([&](const MultiIndex<3>& index, const Vector3& p) {
      if (index[static_cast<std::size_t>(corner)] > 0)
        isCone = isCone && (p - apex).norm() <= small_;
    });
    return isCone;
  }

  /// The edge; a straight one of degree 1, whatever its control points.
  BezierCurve edge(int a, int b) const {
    const BezierCurve curve = edgeCurve(triangle_, a, b);
    const Vector3 from = curve.pole(0);
    const Vector3 along = curve.pole(curve.degree()) - from;
    for (int i = 1; i < curve.degree(); ++i) {
      const Vector3 at = curve.pole(i) - from;
      const double t = at.dot(along) / along.squaredNorm();
      if (!(t >= -1e-12 && t <= 1.0 + 1e-12 && (at - t * along).norm() <= small_)) return curve;
    }
    const std::array<Vector3, 2> ends{from, Vector3(from + along)};
    return BezierCurve(ends);
  }

  TopoDS_Face planeFace(const gp_Pln& plane) const {
    BRepBuilderAPI_MakeWire wire;
    for (int a = 0; a < 3; ++a) {
      const BezierCurve curve = edge(a, (a + 1) % 3);
      const bool isPoint =
          (cornerPoint(a) - cornerPoint((a + 1) % 3)).norm() <= small_ && curve.degree() == 1;
      if (!isPoint) wire.Add(edgeFromCurve(BSplineCurve(curve)));
    }
    BRepBuilderAPI_MakeFace face(plane, wire.Wire(), Standard_True);
    if (!face.IsDone()) throw OcctError("OpenCASCADE makes no plane face of three edges");
    return face.Face();
  }

  TensorPatch positivePatch() const {
    BezierTriangle raised = triangle_;
    for (;;) {
      TensorPatch patch = tensorPatch(raised);
      if ((patch.net.row(3).array() > 0.0).all()) return patch;
      if (raised.degree() == kMaxSimplexDegree) {
        throw std::invalid_argument(
            "solid: a face has a corner of weight 0, no surface goes through it");
      }
      raised = raised.elevated();
    }
  }

  static TopoDS_Face patchFace(const TensorPatch& patch) {
    TColgp_Array2OfPnt poles(1, patch.degreeX + 1, 1, patch.degreeY + 1);
    TColStd_Array2OfReal weights(1, patch.degreeX + 1, 1, patch.degreeY + 1);
    for (int m = 0; m <= patch.degreeX; ++m) {
      for (int l = 0; l <= patch.degreeY; ++l) {
        const Eigen::Vector4d point = patch.point(m, l);
        poles.SetValue(m + 1, l + 1, pointFrom(point.head<3>() / point[3]));
        weights.SetValue(m + 1, l + 1, point[3]);
      }
    }
    const opencascade::handle<Geom_BezierSurface> surface = new Geom_BezierSurface(poles, weights);
    BRepBuilderAPI_MakeFace face(surface, Precision::Confusion());
    if (!face.IsDone()) throw OcctError("OpenCASCADE makes no face of a patch");
    return face.Face();
  }

  const BezierTriangle& triangle_;
  double small_;
};

TopoDS_Shell sewn(const std::array<TopoDS_Face, 4>& faces, double size) {
  BRepBuilderAPI_Sewing sewing(std::max(10.0 * Precision::Confusion(), 1e-9 * size));
  for (const TopoDS_Face& face : faces)
    sewing.Add(face);
  sewing.Perform();
  const TopoDS_Shape& result = sewing.SewedShape();
  if (result.IsNull() || result.ShapeType() != TopAbs_SHELL || sewing.NbFreeEdges() > 0) {
    throw OcctError(
        "the four faces do not close to one shell (does the solid fold? see its validity)");
  }
  return TopoDS::Shell(result);
}

}  // namespace

TopoDS_Solid solidFromTetrahedron(const BezierTetrahedron& solid) {
  if (solid.dimension() != 3)
    throw std::invalid_argument("solid: must be in E3; project it from E4 first");
  for (int corner = 0; corner < 4; ++corner) {
    MultiIndex<4> index{};
    index[static_cast<std::size_t>(corner)] = solid.degree();
    if (solid.weight(index) == 0.0) {
      throw std::invalid_argument("solid: corner " + std::to_string(corner) +
                                  " has weight 0, there is no point for a vertex");
    }
  }
  const auto [low, high] = solid.box();
  const double size = (high - low).norm();
  if (!(std::abs(measure(solid, 1e-6).volume) > 1e-12 * size * size * size)) {
    throw std::invalid_argument("solid: has no volume");
  }
  return translateFailures([&] {
    std::array<TopoDS_Face, 4> faces;
    for (int corner = 0; corner < 4; ++corner)
      faces[static_cast<std::size_t>(corner)] = FaceMaker(face(solid, corner), size).make();
    TopoDS_Solid result = BRepBuilderAPI_MakeSolid(sewn(faces, size)).Solid();
    if (!BRepLib::OrientClosedSolid(result) || !BRepCheck_Analyzer(result).IsValid()) {
      throw OcctError(
          "the faces bound no valid solid (does it fold over itself? see its validity)");
    }
    return result;
  });
}

}  // namespace osculate
