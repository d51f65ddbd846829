// The binary form that FreeCAD writes, written here as FreeCAD does.
#include "osculate/occt/binary_shape.h"

#include <sstream>

#include <gtest/gtest.h>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopoDS.hxx>

#include "occt/edge_samples.h"
#include "osculate/occt/occt_error.h"

namespace osculate::test {
namespace {

std::string written(const TopoDS_Shape& shape) {
  std::stringstream stream;
  BinTools_ShapeSet shapes;
  const int number = shape.IsNull() ? -1 : shapes.Add(shape);
  const int location = shape.IsNull() ? -1 : shapes.Locations().Index(shape.Location());
  const int orientation = shape.IsNull() ? -1 : static_cast<int>(shape.Orientation());
  shapes.Write(stream);
  BinTools::PutInteger(stream, number);
  BinTools::PutInteger(stream, location);
  BinTools::PutInteger(stream, orientation);
  return stream.str();
}

TopoDS_Edge sampleEdge() {
  Random random(1);
  return edgeOf(randomSpline(random, 3, {{0.0, 1.0, 2.5, 4.0}, {4, 1, 2, 4}}, true));
}

TEST(BinaryShape, KeepsCurveAndOrientationToTheBit) {
  for (const TopoDS_Shape& edge : {TopoDS_Shape(sampleEdge()), sampleEdge().Reversed()}) {
    std::istringstream stream(written(edge));
    const TopoDS_Shape back = readBinaryShape(stream);
    EXPECT_EQ(back.Orientation(), edge.Orientation());
    const BSplineData data = curveFromEdge(back).curve.data();
    EXPECT_EQ(data.poles, curveFromEdge(edge).curve.data().poles);
    EXPECT_EQ(data.weights, curveFromEdge(edge).curve.data().weights);
  }
}

TEST(BinaryShape, WritesWhatFreecadReads) {
  for (const TopoDS_Shape& shape :
       {TopoDS_Shape(sampleEdge()), sampleEdge().Reversed(), TopoDS_Shape()}) {
    std::ostringstream stream;
    writeBinaryShape(stream, shape);
    EXPECT_EQ(stream.str(), written(shape));
  }
}

TEST(BinaryShape, KeepsThePlacement) {
  gp_Trsf placement;
  placement.SetTranslation(gp_Vec(1, 2, 3));
  const TopoDS_Shape moved = sampleEdge().Located(TopLoc_Location(placement));
  std::istringstream stream(written(moved));
  EXPECT_LE(largestDistance(curveFromEdge(readBinaryShape(stream)), TopoDS::Edge(moved)), 1e-13);
}

TEST(BinaryShape, NullShapeComesBackNull) {
  std::istringstream stream(written({}));
  EXPECT_TRUE(readBinaryShape(stream).IsNull());
}

TEST(BinaryShape, RefusesWhatIsNoSuchStream) {
  const std::string good = written(sampleEdge());
  const std::string bad[] = {"", "no shape at all", good.substr(0, good.size() - 4),
                             good.substr(0, good.size() / 2),
                             good.substr(0, good.size() - 12) + std::string(12, '\x7f')};
  for (const std::string& text : bad) {
    std::istringstream stream(text);
    EXPECT_THROW(readBinaryShape(stream), OcctError) << text.size();
  }
}

}  // namespace
}  // namespace osculate::test
