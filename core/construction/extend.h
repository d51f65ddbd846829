// A curve that continues another one beyond its end.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "osculate/bezier/bspline_curve.h"
#include "osculate/construction/contact_jet.h"
#include "osculate/construction/fairness.h"

namespace osculate {

/// [k-1] is the k-th of up to kMaxOrder numbers, or not given.
using GivenNumbers = std::array<std::optional<double>, kMaxOrder>;

/// What the far end of an extension meets, in the direction of travel away from the curve.
struct ExtendTargets {
  std::optional<Vector3> point{};            ///< mm
  std::optional<Vector3> direction{};        ///< of the tangent there; need not be of unit length
  std::optional<Vector3> curvatureVector{};  ///< kappa times the normal there, 1/mm
  std::optional<double> curvature{};         ///< its magnitude alone, 1/mm
  std::optional<double> lengthMm{};          ///< of the extension
};

struct ExtendOptions {
  CurveEnd end = CurveEnd::kEnd;
  int order = 4;              ///< of contact, 0 .. kMaxOrder
  int degree = 0;             ///< 0: the lowest from the order up that can
  GivenNumbers beta{};        ///< (d^k s/dt^k) / chord, both of the finished extension; see blend.h
  GivenNumbers tangential{};  ///< coordinates of the poles C_1 .. along the tangent, mm
  ExtendTargets targets{};
  /// C^order in the curve's own parameter in place of G^order.
  bool parametric = false;
  /// C^order, and of that curve over [0, 1] the part [0, parameter]; above 1 it goes on.
  std::optional<double> parameter{};
  /// What chooses the numbers that the request leaves free; nothing: there must be none.
  std::optional<Fairness> fairness = Fairness::kMinimumVariation;
};

struct Extension {
  BezierCurve curve;                    ///< begins at the end that it continues
  std::vector<double> beta{};           ///< beta_1 .. beta_order of the curve
  std::optional<double> objective{};    ///< what was minimised
  int freeNumbers = 0;                  ///< how many numbers fairness chose
  double parameterLength = 1.0;         ///< of the range over which it has the contact asked for
  std::vector<std::string> warnings{};  ///< sentences
};

/// The polynomial Bézier curve that continues `curve` as the options say.
///
/// Where neither length, point nor numbers in mm are given, its length is the curve's reach (see
/// reachFrom). Numbers that the request leaves free are chosen by fairness; the same input gives
/// the same curve. Throws std::invalid_argument for numbers outside their range, ContactError where
/// no curve can be, with what can: a degree too low, requests that contradict each other, more
/// requests than free numbers, or (without fairness) fewer.
Extension extend(const BSplineCurve& curve, const ExtendOptions& options = {});

}  // namespace osculate
