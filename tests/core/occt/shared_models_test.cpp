// Every edge of the real models beside a checkout: converted, it is the edge.
#include <filesystem>

#include <gtest/gtest.h>
#include <BRepTools.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "occt/edge_samples.h"
#include "support/leaks.h"

namespace osculate::test {
namespace {

namespace fs = std::filesystem;

template <typename Reader>
TopoDS_Shape transferred(const fs::path& file) {
  Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) return {};
  reader.TransferRoots();
  return reader.OneShape();
}

TopoDS_Shape readModel(const fs::path& file) {
  const IgnoredLeaks readers;  // their tables of parameters, once in a process
  if (file.extension() == ".stp") return transferred<STEPControl_Reader>(file);
  if (file.extension() == ".igs") return transferred<IGESControl_Reader>(file);
  TopoDS_Shape shape;
  BRepTools::Read(shape, file.c_str(), BRep_Builder());
  return shape;
}

class SharedModel : public testing::TestWithParam<const char*> {};

TEST_P(SharedModel, EveryEdgeConvertsToItself) {
  const fs::path file = fs::path(OSCULATE_SHARED_DIR) / "data" / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(readModel(file), TopAbs_EDGE, edges);
  ASSERT_GT(edges.Extent(), 0);
  for (int i = 1; i <= edges.Extent(); ++i) {
    SCOPED_TRACE("edge " + std::to_string(i));
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge)) {
      EXPECT_THROW(curveFromEdge(edge), std::invalid_argument);
      continue;
    }
    const EdgeCurve converted = curveFromEdge(edge);
    EXPECT_NE(converted.kind, EdgeCurveKind::kFitted);
    EXPECT_LE(largestDistance(converted, edge),
              1e-12 * largestPole(converted.curve) + converted.errorMm)
        << name(converted.kind);
  }
}

INSTANTIATE_TEST_SUITE_P(Data, SharedModel,
                         testing::Values("Fuselage_guides.brep", "Propeller.brep",
                                         "mayo_bezier_curve.brep", "NIST_MBE_PMI_4.stp",
                                         "igesio_input.igs", "impeller.igs"));

}  // namespace
}  // namespace osculate::test
