// Audits beside what OpenCASCADE takes to read the model, and to analyse the same joins up to G2.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <IGESControl_Reader.hxx>
#include <LocalAnalysis_CurveContinuity.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "osculate/occt/audit.h"
#include "osculate/occt/model_file.h"
#include "sample_curves.h"

namespace {

using namespace osculate;

constexpr double kZero = 1e-9;  // as in join_bench.cpp

const std::string kImpeller = OSCULATE_SHARED_DIR "/data/impeller.igs";

AuditReport auditOnOneCore(const TopoDS_Shape& shape) {
  AuditOptions options;
  options.threads = 1;
  return ShapeAudit(shape, options).takeReport();
}

void readImpeller(benchmark::State& state) {
  for (auto _ : state) {
    IGESControl_Reader reader;
    reader.SetReadVisible(Standard_True);
    reader.ReadFile(kImpeller.c_str());
    reader.TransferRoots();
    benchmark::DoNotOptimize(reader.OneShape());
  }
}

void auditImpeller(benchmark::State& state) {
  const TopoDS_Shape shape = readModel(kImpeller).shape;
  std::size_t joins = 0;
  for (auto _ : state)
    joins = auditOnOneCore(shape).rows.size();
  state.SetItemsProcessed(static_cast<std::int64_t>(joins) * state.iterations());
}

/// What LocalAnalysis is given of one side of a join.
struct PointOnCurve {
  Handle(Geom_Curve) curve;
  double parameter = 0.0;
};

PointOnCurve sideOf(const AuditRow& row, std::size_t side, const TopoDS_Edge& edge) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const bool isReversed = edge.Orientation() == TopAbs_REVERSED;
  if (row.kind == JoinKind::kKnot)
    return {curve, isReversed ? first + last - row.parameter : row.parameter};
  const CurveEnd end = side == 0 ? row.ends.first : row.ends.second;
  return {curve, (end == CurveEnd::kStart) != isReversed ? first : last};
}

using JoinOfPoints = std::pair<PointOnCurve, PointOnCurve>;

void analyzeByOpenCascade(const JoinOfPoints& join) {
  const auto& [a, b] = join;
  LocalAnalysis_CurveContinuity analysis(a.curve, a.parameter, b.curve, b.parameter, GeomAbs_G2,
                                         kZero);
  benchmark::DoNotOptimize(analysis);
}

/// Not those at which it throws, for want of a tangent.
bool canAnalyze(const JoinOfPoints& join) {
  try {
    analyzeByOpenCascade(join);
    return true;
  } catch (const Standard_Failure&) {
    return false;
  }
}

std::vector<JoinOfPoints> joinsForOpenCascade(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  const auto edge = [&](int number) { return TopoDS::Edge(edges(number)); };
  std::vector<JoinOfPoints> joins;
  for (const AuditRow& row : auditOnOneCore(shape).rows)
    joins.emplace_back(sideOf(row, 0, edge(row.edges[0])), sideOf(row, 1, edge(row.edges[1])));
  std::erase_if(joins, [](const JoinOfPoints& join) { return !canAnalyze(join); });
  return joins;
}

/// Without finding the joins or fetching the curves.
void localAnalysisOfImpeller(benchmark::State& state) {
  const std::vector<JoinOfPoints> joins = joinsForOpenCascade(readModel(kImpeller).shape);
  for (auto _ : state) {
    for (const JoinOfPoints& join : joins)
      analyzeByOpenCascade(join);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(joins.size()) * state.iterations());
}

void analyzeInnerKnots(const Handle(Geom_Curve) & curve, double first, double last) {
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return;
  for (int i = spline->FirstUKnotIndex() + 1; i < spline->LastUKnotIndex(); ++i) {
    const double knot = spline->Knot(i);
    if (first < knot && knot < last) canAnalyze({{curve, knot}, {curve, knot}});
  }
}

PointOnCurve pointAt(const TopoDS_Edge& edge, const TopoDS_Vertex& vertex) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  return {curve, vertex.IsSame(TopExp::FirstVertex(edge)) ? first : last};
}

/// Every two edges at each vertex and the inner knots of every edge, as a program has to go about
/// it that has OpenCASCADE alone.
void auditImpellerByOpenCascade(benchmark::State& state) {
  const TopoDS_Shape shape = readModel(kImpeller).shape;
  for (auto _ : state) {
    TopTools_IndexedDataMapOfShapeListOfShape edgesAt;
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edgesAt);
    for (int i = 1; i <= edgesAt.Extent(); ++i) {
      std::vector<PointOnCurve> points;
      for (const TopoDS_Shape& edge : edgesAt(i))
        points.push_back(pointAt(TopoDS::Edge(edge), TopoDS::Vertex(edgesAt.FindKey(i))));
      std::erase_if(points, [](const PointOnCurve& point) { return point.curve.IsNull(); });
      for (std::size_t b = 1; b < points.size(); ++b) {
        for (std::size_t a = 0; a < b; ++a)
          canAnalyze({points[a], points[b]});
      }
    }
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      double first = 0.0;
      double last = 0.0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), first, last);
      analyzeInnerKnots(curve, first, last);
    }
  }
}

/// These need the model that may lie beside the checkout.
const bool kImpellerIsThere = [] {
  if (!std::filesystem::exists(kImpeller)) return false;
  benchmark::RegisterBenchmark("readImpeller", readImpeller)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("auditImpeller", auditImpeller)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("auditImpellerByOpenCascade", auditImpellerByOpenCascade)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("localAnalysisOfImpeller", localAnalysisOfImpeller)
      ->Unit(benchmark::kMillisecond);
  return true;
}();

/// Of /proc/self/status, in bytes.
double memory(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string name; status >> name; status.ignore(256, '\n')) {
    double kilobytes = 0.0;
    if (name == what + ":" && status >> kilobytes) return 1024.0 * kilobytes;
  }
  return 0.0;
}

/// The most memory that an audit takes at any time, its report included, for each row.
std::optional<double> bytesPerRow(const TopoDS_Shape& shape) {
  ::malloc_trim(0);
  std::ofstream reset("/proc/self/clear_refs");
  if (!(reset << "5" << std::flush)) return std::nullopt;  // the peak begins anew
  const double before = memory("VmRSS");
  const AuditReport report = auditOnOneCore(shape);
  return (memory("VmHWM") - before) / static_cast<double>(report.rows.size());
}

/// Half of the joins at vertices, half at inner knots.
void auditChain(benchmark::State& state) {
  const auto joins = state.range(0);
  const TopoDS_Shape chain = bench::chain(static_cast<int>(joins / 2));
  if (const auto bytes = bytesPerRow(chain)) state.counters["bytes_per_row"] = *bytes;
  for (auto _ : state)
    benchmark::DoNotOptimize(auditOnOneCore(chain).rows.data());
  state.SetItemsProcessed(joins * state.iterations());
}
BENCHMARK(auditChain)
    ->ArgName("joins")
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
