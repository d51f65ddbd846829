// The report of a join: every number of the analysis, as plain values without allocation.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "osculate/bezier/bezier_curve.h"
#include "osculate/continuity/definitions.h"
#include "osculate/continuity/tolerances.h"
#include "osculate/continuity/warnings.h"
#include "osculate/differential/frenet.h"

namespace osculate {

/// One number for each order 0 .. kMaxOrder; those above the order asked for are not set.
using PerOrder = std::array<double, kMaxOrder + 1>;

/// One side of the join, in the direction of travel.
struct SideReport {
  CurveEnd end = CurveEnd::kEnd;    ///< which end of its curve lies at the join
  Vector3 point = Vector3::Zero();  ///< mm
  FrenetFrame frame;                ///< tangent, and normal and binormal where they exist
  Invariants invariants;            ///< curvature, torsion and their rates by arc length
  int linearity = 0;                ///< legs of the control polygon on the tangent, from the join
  int multiplicity = 1;             ///< 1 regular; m > 1: the first m-1 derivatives are zero
  int smoothness = kMaxOrder;       ///< arc-length derivatives that exist, at most kMaxOrder
};

/// Physical deviations between the sides; empty where a side has no such number.
struct Deviation {
  double gapMm = 0.0;
  std::optional<double> tangentAngleDegrees;          ///< 0 .. 180
  std::optional<double> curvatureVectorPerMm;         ///< |k1 N1 - k2 N2|
  std::optional<double> curvatureRelative;            ///< |k1 - k2| / max(k1, k2)
  std::optional<double> osculatingPlaneAngleDegrees;  ///< 0 .. 180, between the binormals
  std::optional<double> torsionPerMm;
  std::optional<double> curvatureRatePerMm2;
  std::optional<double> torsionRatePerMm2;
  std::optional<double> curvatureRate2PerMm3;
};

/// Order of contact and by how much each order misses.
struct JoinDecision {
  int order = -1;            ///< highest m with orders 0..m all passing; -1: a gap
  int parametricOrder = -1;  ///< the same for C^m in the curves' own parameters
  std::array<Verdict, kMaxOrder + 1> verdicts{};
  PerOrder residuals{};      ///< mm, degrees, then dimensionless; infinite where a side has no such
                             ///< derivative
  PerOrder uncertainties{};  ///< bounds of the error of the residuals that doubles carry
  /// mm, then dimensionless (order 1 against the angle in radians); up to parametricOrder + 1
  PerOrder parametricResiduals{};
};

struct JoinReport : JoinDecision {
  int requestedOrder = 4;
  PerOrder tolerances{};
  std::string_view preset;                            ///< name of the tolerances
  CurvatureMetric metric = CurvatureMetric::kVector;  ///< of the preset
  double scaleMm = 0.0;                  ///< L, the length the residuals of order >= 2 refer to
  std::array<double, kMaxOrder> beta{};  ///< beta[k-1] = beta_k, for k <= betaCount
  int betaCount = 0;
  Deviation deviation;
  std::array<SideReport, 2> sides;  ///< arriving, leaving
  FrenetFrame frame;                ///< at the join, of the first curve; always complete
  FrameKind frameKind = FrameKind::kFrenet;
  /// Derivatives 0..4 of each segment by its own parameter [0, 1] in the direction of travel, in
  /// the frame (tangent, normal, binormal); row 0 is the end's position from the first curve's end.
  std::array<Eigen::Matrix<double, 5, 3>, 2> derivativesInFrame;
  DefinitionResults definitions;
  WarningSet warnings;
};

}  // namespace osculate
