// All joins of a shape: at its vertices, at the inner knots of its edges, at closed edges' seams.
#pragma once

#include <memory>
#include <utility>

#include <TopoDS_Shape.hxx>

#include "osculate/continuity/audit_report.h"

namespace osculate {

class EdgeGraph;

/// A shape with its joins.
class ShapeAudit {
 public:
  /// Analyses them all, each edge converted once (see curveFromEdge), in parallel; the same rows in
  /// the same order whatever the number of threads.
  ///
  /// - Edges are numbered from 1 as TopExp::MapShapes numbers them and directed as it delivers
  ///   them: FreeCAD's Edge1, Edge2, ...
  /// - Edges meet where they share a vertex (TopoDS_Shape::IsSame); whether their curves do, the
  ///   row's gap says. Edges in no wire, as the readers make them of wireframe models, also meet
  ///   where their vertices lie within the gap tolerance, or, where a vertex is alone, with another
  ///   lonely one within `touchMm`. A closed edge meets itself: both ends at one vertex, or no
  ///   vertices and ends within the gap tolerance.
  /// - An edge that cannot be converted is listed in `skipped`, and its joins are left out.
  ///
  /// `progress` is called from this thread alone, some fifty times a second at most; where it
  /// returns false, the joins of a first part of the edges are kept and `complete` is false.
  ///
  /// Throws std::invalid_argument for a null shape and bad options, OcctError for what
  /// OpenCASCADE throws outside single edges, and what `progress` throws.
  explicit ShapeAudit(const TopoDS_Shape& shape, const AuditOptions& options = {},
                      const Progress& progress = {});

  const AuditReport& report() const { return report_; }
  /// Moves the report out; joins can still be computed.
  AuditReport takeReport() { return std::move(report_); }
  /// The whole report of a row's join, computed again.
  CurveJoin join(const AuditRow& row) const;

 private:
  std::shared_ptr<const EdgeGraph> graph_;
  AnalysisOptions options_;
  AuditReport report_;
};

}  // namespace osculate
