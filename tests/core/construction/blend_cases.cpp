#include "construction/blend_cases.h"

#include <cmath>
#include <numbers>

namespace osculate::test {

namespace {

/// A quintic that ends at a point in a direction.
struct Arm {
  double length;  ///< mm
  double bend;    ///< how far it bends to the left, as a share of the length
  double twist;   ///< how far out of its plane
  double weight;  ///< of the two middle poles; 1: polynomial
};

Vector3 direction(double azimuthDegrees, double elevationDegrees) {
  const double a = azimuthDegrees * std::numbers::pi / 180.0;
  const double e = elevationDegrees * std::numbers::pi / 180.0;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

/// Poles from the far end to `point`; the last leg has direction `tangent`.
BezierCurve arm(const Vector3& point, const Vector3& tangent, const Arm& shape) {
  const Vector3 left = Vector3::UnitZ().cross(tangent).normalized();
  const Vector3 up = tangent.cross(left);
  std::vector<Vector3> poles;
  for (int i = 0; i <= 5; ++i) {
    const double back = (5 - i) / 5.0;
    poles.push_back(point +
                    shape.length * (-back * tangent + shape.bend * back * (back - 0.2) * left +
                                    shape.twist * back * (back - 0.2) * (back - 0.4) * up));
  }
  if (shape.weight == 1.0) return BezierCurve(poles);
  const std::vector<double> weights{1.0, 1.0, shape.weight, shape.weight, 1.0, 1.0};
  return BezierCurve(poles, weights);
}

struct Task {
  const char* name;
  Vector3 to;         ///< from the origin, mm
  double azimuth[2];  ///< in which the blend leaves the origin and arrives, degrees
  double elevation[2];
  Arm first, second;
};

const std::vector<Task>& tasks() {
  static const Arm kStraight{40, 0, 0, 1};
  static const Arm kLeft{40, 0.5, 0, 1};
  static const Arm kRight{40, -0.5, 0, 1};
  static const Arm kTight{40, 1.5, 0, 1};
  static const Arm kSpace{40, 0.5, 0.8, 1};
  static const Arm kSpaceRight{40, -0.4, -0.8, 1};
  static const Arm kRational{40, 0.6, 0, 2.0};
  static const Arm kRationalSpace{40, 0.5, 0.6, 0.5};
  static const Arm kShort{8, 0.4, 0, 1};
  static const Arm kLong{300, 0.3, 0, 1};
  static const std::vector<Task> kTasks{
      {"quarter turn, straight arms", {50, 50, 0}, {0, 90}, {0, 0}, kStraight, kStraight},
      {"quarter turn, bent arms", {50, 50, 0}, {0, 90}, {0, 0}, kLeft, kLeft},
      {"quarter turn, opposite bends", {50, 50, 0}, {0, 90}, {0, 0}, kLeft, kRight},
      {"quarter turn, unequal legs", {80, 30, 0}, {0, 90}, {0, 0}, kStraight, kLeft},
      {"S, straight arms", {60, 40, 0}, {0, 0}, {0, 0}, kStraight, kStraight},
      {"S, bent arms", {60, 40, 0}, {0, 0}, {0, 0}, kLeft, kRight},
      {"S, steep", {20, 60, 0}, {0, 0}, {0, 0}, kStraight, kStraight},
      {"S, rational", {60, 40, 0}, {0, 0}, {0, 0}, kRational, kRight},
      {"U-turn, straight arms", {0, 50, 0}, {0, 180}, {0, 0}, kStraight, kStraight},
      {"U-turn, bent arms", {0, 50, 0}, {0, 180}, {0, 0}, kLeft, kLeft},
      {"U-turn, offset ends", {20, 50, 0}, {0, 180}, {0, 0}, kStraight, kLeft},
      {"U-turn, set back", {-30, 40, 0}, {0, 180}, {0, 0}, kStraight, kStraight},
      {"U-turn, rational", {0, 50, 0}, {0, 180}, {0, 0}, kRational, kRational},
      {"near-straight", {60, 2, 0}, {0, 3}, {0, 0}, kStraight, kStraight},
      {"near-straight, bent arms", {60, 1, 0}, {0, -2}, {0, 0}, kLeft, kLeft},
      {"near-straight, opposite bends", {60, 0, 0}, {0, 0}, {0, 0}, kLeft, kRight},
      {"tight, equal sides", {30, 10, 0}, {0, 40}, {0, 0}, kTight, kTight},
      {"tight, against the bend", {30, -10, 0}, {0, -40}, {0, 0}, kTight, kTight},
      {"tight, small gap", {5, 1, 0}, {0, 20}, {0, 0}, kTight, kLeft},
      {"unequal lengths", {40, 20, 0}, {0, 60}, {0, 0}, kShort, kLong},
      {"unequal lengths, wide gap", {200, 50, 0}, {10, 50}, {0, 0}, kShort, kLong},
      {"unequal lengths, S", {60, 30, 0}, {20, 10}, {0, 0}, kLong, kShort},
      {"space, straight arms", {50, 30, 20}, {0, 60}, {0, 30}, kStraight, kStraight},
      {"space, bent arms", {50, 30, 20}, {0, 60}, {0, 30}, kSpace, kSpace},
      {"space, opposite twists", {50, 30, 20}, {0, 60}, {0, 30}, kSpace, kSpaceRight},
      {"space, skew lines", {40, 0, 40}, {0, 90}, {0, 0}, kStraight, kStraight},
      {"space, U-turn that climbs", {0, 40, 30}, {0, 180}, {0, 0}, kLeft, kSpace},
      {"space, S", {60, 30, -20}, {0, 10}, {10, -10}, kSpace, kSpaceRight},
      {"space, rational", {50, 40, 20}, {0, 80}, {0, 20}, kRationalSpace, kSpace},
      {"space, both rational", {60, 20, 30}, {-20, 50}, {10, 20}, kRationalSpace, kRationalSpace},
      {"space, steep", {20, 20, 60}, {0, 90}, {70, 60}, kSpace, kSpace},
      {"three-quarter turn", {-30, -30, 0}, {0, 270}, {0, 0}, kStraight, kLeft},
  };
  return kTasks;
}

}  // namespace

std::vector<BlendCase> blendCases() {
  std::vector<BlendCase> cases;
  for (const Task& task : tasks()) {
    const Vector3 leaving = direction(task.azimuth[0], task.elevation[0]);
    const Vector3 arriving = direction(task.azimuth[1], task.elevation[1]);
    cases.push_back({task.name, BSplineCurve(arm(Vector3::Zero(), leaving, task.first)),
                     BSplineCurve(arm(task.to, -arriving, task.second).reversed())});
  }
  return cases;
}

}  // namespace osculate::test
