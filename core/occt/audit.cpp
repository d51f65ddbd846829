#include "osculate/occt/audit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "osculate/occt/audit_run.h"
#include "osculate/occt/edge_curve.h"
#include "osculate/occt/edge_graph.h"

namespace osculate {

ShapeAudit::ShapeAudit(const TopoDS_Shape& shape, const AuditOptions& options,
                       const Progress& progress)
    : options_(options.analysis) {
  checkAuditOptions(options);
  if (shape.IsNull()) throw std::invalid_argument("shape: is null (empty)");
  report_.options = options;
  graph_ =
      std::make_shared<const EdgeGraph>(shape, options.analysis.tolerances.gapMm, options.touchMm);
  AuditRun(*graph_, report_, progress).run();
}

CurveJoin ShapeAudit::join(const AuditRow& row) const {
  const auto curve = [&](std::size_t i) {
    return curveFromEdge(graph_->edge(row.edges[i] - 1)).curve;
  };
  switch (row.kind) {
    case JoinKind::kKnot:
      return analyzeAt(curve(0), row.parameter, options_);
    case JoinKind::kSeam:
      return analyzeClosing(curve(0), options_);
    default:
      return analyzeCurves(curve(0), curve(1), options_, row.ends);
  }
}

}  // namespace osculate
