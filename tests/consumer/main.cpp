// Cuts a cubic in two, doubles a leg of the second part, and lets the library say what is left.
#include <cstdio>
#include <vector>

#include "osculate/continuity/curve_joins.h"
#include "osculate/continuity/report_text.h"

namespace {

int orderOf(const osculate::BezierCurve& arriving, const osculate::BezierCurve& leaving) {
  const osculate::CurveJoin join =
      osculate::analyzeCurves(osculate::BSplineCurve(arriving), osculate::BSplineCurve(leaving));
  std::puts(osculate::headline(join.report).c_str());
  return join.report.order;
}

osculate::BezierCurve withFirstLegDoubled(const osculate::BezierCurve& curve) {
  std::vector<osculate::Vector3> poles;
  for (int i = 0; i <= curve.degree(); ++i)
    poles.emplace_back(curve.pole(i));
  poles[1] = 2.0 * poles[1] - poles[0];
  return osculate::BezierCurve(poles);
}

}  // namespace

int main() {
  const std::vector<osculate::Vector3> poles{{0, 0, 0}, {10, 0, 0}, {20, 10, 0}, {30, 10, 10}};
  const auto [arriving, leaving] = osculate::BezierCurve(poles).split(0.5);
  const bool right =
      orderOf(arriving, leaving) == 4 && orderOf(arriving, withFirstLegDoubled(leaving)) == 1;
  return right ? 0 : 1;
}
