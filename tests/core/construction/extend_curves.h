// Curves that the tests of extensions continue.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "osculate/bezier/bspline_curve.h"
#include "support/random_curves.h"

namespace osculate::test {

inline BSplineCurve bezier(const std::vector<Vector3>& poles,
                           const std::vector<double>& weights = {}) {
  return BSplineCurve(BezierCurve(poles, weights));
}

inline BSplineCurve twistedCubic() {
  return bezier({{0, 0, 0}, {10, 0, 0}, {20, 10, 0}, {20, 20, 10}});
}
inline BSplineCurve planarCubic() {
  return bezier({{-40, 6, 0}, {-25, 1, 0}, {-12, 0, 0}, {0, 0, 0}});
}
inline BSplineCurve twistedQuintic() {
  return bezier({{0, 0, 0}, {9, 4, 1}, {21, -2, 5}, {30, 6, 2}, {42, 3, -4}, {50, 9, 3}});
}
/// Of radius 10 about the origin, from (10, 0, 0) to (0, 10, 0).
inline BSplineCurve quarterCircle() {
  return bezier({{10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {1.0, std::sqrt(0.5), 1.0});
}
inline BSplineCurve rationalQuartic() {
  return bezier({{0, 0, 0}, {10, 2, 1}, {20, 8, -2}, {26, 18, 3}, {28, 30, 8}},
                {1.0, 1.4, 0.8, 1.2, 0.9});
}
inline BSplineCurve line() { return bezier({{-30, -10, 5}, {0, 0, 0}}); }
/// The parabola (u, u^2/40, 0) for u = -20 (1 - t)^2: a double pole at its end that is only a
/// matter of the parameter.
inline BSplineCurve doublePole() {
  return bezier({{-20, 10, 0}, {-10, 0, 0}, {-10.0 / 3.0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
}
/// Several spans of different lengths.
inline BSplineCurve spline() {
  Random random(77);
  return BSplineCurve(randomSplineData(random, 4, {{0, 1, 2, 2.5, 7}, {5, 1, 2, 1, 5}}, false));
}

struct NamedCurve {
  std::string name;
  BSplineCurve curve;
};

/// With derivatives by arc length of every order at both ends.
inline std::vector<NamedCurve> curvesToExtend() {
  return {{"twisted cubic", twistedCubic()},
          {"planar cubic", planarCubic()},
          {"twisted quintic", twistedQuintic()},
          {"quarter circle", quarterCircle()},
          {"rational quartic", rationalQuartic()},
          {"line", line()},
          {"B-spline", spline()}};
}

}  // namespace osculate::test
