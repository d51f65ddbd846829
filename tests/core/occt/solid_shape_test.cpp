#include "osculate/occt/solid_shape.h"

#include <unistd.h>

#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "osculate/bezier/tensor_patch.h"
#include "osculate/occt/occt_error.h"
#include "osculate/solid/measure.h"
#include "osculate/solid/primitives.h"
#include "support/errors.h"
#include "support/leaks.h"
#include "support/simplex_samples.h"

namespace osculate::test {
namespace {

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

void expectGoodSolid(const BezierTetrahedron& solid) {
  const TopoDS_Solid shape = solidFromTetrahedron(solid);
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  EXPECT_EQ(count(shape, TopAbs_SHELL), 1);
  EXPECT_EQ(count(shape, TopAbs_FACE), 4);
  EXPECT_EQ(count(shape, TopAbs_VERTEX), 4);
  const double expected = std::abs(measure(solid).volume);
  EXPECT_NEAR(volumeOf(shape), expected, 1e-6 * expected);
}

TEST(SolidShape, PrimitivesAreValidAndHaveTheirVolume) {
  expectGoodSolid(linearTetrahedron({0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}));
  expectGoodSolid(cone(5.0, 12.0));
  expectGoodSolid(ellipticCone(5.0, 3.0, {1.0, 2.0, 8.0}));
  expectGoodSolid(ballOctant(10.0));
  for (const BezierTetrahedron& solid :
       sphereWedge({1, 2, 3}, {11, 2, 3}, {1, 12, 3},
                   Vector3(1, 2, 3) + 10.0 * Vector3(-1, 0.2, 1).normalized()))
    expectGoodSolid(solid);
  expectGoodSolid(sphereWedgeByCircles(Vector3::Zero(), {10, 0, 0}, {0, 10, 0}, {0, 0, 10}));
  for (const BezierTetrahedron& solid : frustumWedge(8.0, 5.0, 10.0, 0.5 * std::numbers::pi))
    expectGoodSolid(solid);
}

TEST(SolidShape, RandomSolidsAndMirrorImagesAreOrientedRight) {
  for (const int degree : {2, 3, 4}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + " seed " + std::to_string(seed));
      expectGoodSolid(randomTetrahedron(degree, seed));
      expectGoodSolid(randomTetrahedron(degree, seed).relabelled({1, 0, 2, 3}));
    }
  }
}

TEST(SolidShape, TheThesisConeWithZeroWeightsIsTheCone) {
  const BezierTetrahedron good = cone(5.0, 12.0);
  std::vector<double> weights = good.weights();
  for (const MultiIndex<4>& i : {MultiIndex<4>{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}})
    weights[static_cast<std::size_t>(netIndex<4>(i))] = 0.0;
  expectGoodSolid(BezierTetrahedron(2, good.points(), weights));
}

/// The face that is a tensor patch has the numbers of the patch, bit for bit.
TEST(SolidShape, CurvedFacesAreTheExactPatches) {
  const BezierTetrahedron solid = ballOctant(10.0);
  const TensorPatch patch = tensorPatch(face(solid, 3));
  int found = 0;
  for (TopExp_Explorer faces(solidFromTetrahedron(solid), TopAbs_FACE); faces.More();
       faces.Next()) {
    const auto surface = opencascade::handle<Geom_BezierSurface>::DownCast(
        BRep_Tool::Surface(TopoDS::Face(faces.Current())));
    if (surface.IsNull()) continue;
    ++found;
    for (int m = 0; m <= 4; ++m) {
      for (int l = 0; l <= 4; ++l) {
        const Eigen::Vector4d p = patch.point(m, l);
        EXPECT_EQ(surface->Weight(m + 1, l + 1), p[3]);
        EXPECT_EQ(surface->Pole(m + 1, l + 1).X(), p[0] / p[3]);
      }
    }
  }
  EXPECT_EQ(found, 1);
}

TopoDS_Shape throughStep(const TopoDS_Shape& shape) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("osculate-solid-" + std::to_string(::getpid()) + ".stp");
  STEPControl_Writer writer;
  EXPECT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
  EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  STEPControl_Reader reader;
  EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  std::filesystem::remove(path);
  return reader.OneShape();
}

TEST(SolidShape, StepKeepsItExact) {
  const IgnoredLeaks ofTheWriter;
  const double radius = 10.0;
  const TopoDS_Shape back = throughStep(solidFromTetrahedron(ballOctant(radius)));
  EXPECT_TRUE(BRepCheck_Analyzer(back).IsValid());
  EXPECT_NEAR(volumeOf(back), std::numbers::pi * radius * radius * radius / 6.0, 1e-6);
  int spherical = 0;
  for (TopExp_Explorer faces(back, TopAbs_FACE); faces.More(); faces.Next()) {
    const auto surface = BRep_Tool::Surface(TopoDS::Face(faces.Current()));
    if (surface->IsKind(STANDARD_TYPE(Geom_Plane))) continue;
    ++spherical;
    double u0 = 0;
    double u1 = 0;
    double v0 = 0;
    double v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; j <= 10; ++j) {
        const gp_Pnt p = surface->Value(u0 + (u1 - u0) * i / 10, v0 + (v1 - v0) * j / 10);
        EXPECT_NEAR(p.XYZ().SquareModulus() / (radius * radius), 1.0, 1e-12);
      }
    }
  }
  EXPECT_EQ(spherical, 1);
}

TEST(SolidShape, RefusesWhatIsNoSolid) {
  EXPECT_ERROR(solidFromTetrahedron(randomTetrahedron(2, 1, 4)), "project it from E4 first");
  Eigen::MatrixXd points = Eigen::MatrixXd::Random(3, 4);
  EXPECT_ERROR(solidFromTetrahedron(BezierTetrahedron(1, points, {0, 1, 1, 1})),
               "corner 0 has weight 0");
  points.row(2).setZero();
  EXPECT_ERROR(solidFromTetrahedron(BezierTetrahedron(1, points)), "solid: has no volume");
}

}  // namespace
}  // namespace osculate::test
