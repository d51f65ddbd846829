// Blends beside the simplest competitor with OpenCASCADE, and the match of a long B-spline.
#include <benchmark/benchmark.h>

#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <cmath>
#include <math_Gauss.hxx>
#include <math_Matrix.hxx>
#include <math_Vector.hxx>

#include "construction/blend_cases.h"
#include "osculate/bezier/bernstein.h"
#include "osculate/construction/blend.h"
#include "osculate/construction/match_curves.h"
#include "sample_curves.h"

namespace {

using namespace osculate;

constexpr int kOrder = 4;
constexpr int kDegree = 2 * kOrder + 1;

Blend blendOf(const test::BlendCase& task, const BlendOptions& options) {
  return blend(contactJet(task.first, {.end = CurveEnd::kEnd}, options.order[0]),
               contactJet(task.second, {.end = CurveEnd::kStart}, options.order[1]), options);
}

/// All the freedoms given: beta_1 = 1 and 0 for the others.
void givenBlend(benchmark::State& state) {
  const test::BlendCase task = test::blendCases().front();
  BlendOptions options{.order = {kOrder, kOrder}};
  for (auto& end : options.beta) {
    end.fill(0.0);
    end[0] = 1.0;
  }
  for (auto _ : state)
    benchmark::DoNotOptimize(blendOf(task, options));
}
BENCHMARK(givenBlend);

void fairBlend(benchmark::State& state) {
  const test::BlendCase task = test::blendCases()[static_cast<std::size_t>(state.range(0))];
  const BlendOptions options{.order = {kOrder, kOrder}};
  for (auto _ : state)
    benchmark::DoNotOptimize(blendOf(task, options));
}
BENCHMARK(fairBlend)->ArgName("case")->DenseRange(0, 31)->MinTime(0.05);

/// A quintic of simple knots along +x, 2 mm beside the end of the first case's first curve.
BSplineCurve longSpline(int spans) {
  const Vector3 from = test::blendCases().front().first.endPoint(CurveEnd::kEnd);
  BSplineData data{.poles = Poles(3, spans + 5),
                   .weights = {},
                   .knots = {},
                   .degree = 5,
                   .periodic = false,
                   .poleError = 0.0};
  for (int i = 0; i < spans + 5; ++i) {
    data.poles.col(i) =
        from + Vector3(10.0 * i + 2.0, 3.0 * std::sin(0.4 * i), 2.0 * std::cos(0.7 * i));
  }
  for (int i = 0; i <= spans; ++i) {
    data.knots.knots.push_back(i);
    data.knots.multiplicities.push_back(i == 0 || i == spans ? 6 : 1);
  }
  return BSplineCurve(std::move(data));
}

/// The whole call: the change, its displacement bound and the proof of the join.
void matchOfLongSpline(benchmark::State& state) {
  const BSplineCurve first = test::blendCases().front().first;
  const BSplineCurve second = longSpline(static_cast<int>(state.range(0)));
  const MatchOptions options{.order = static_cast<int>(state.range(1))};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        matchCurves(first, {.end = CurveEnd::kEnd}, second, CurveEnd::kStart, options));
  }
}
BENCHMARK(matchOfLongSpline)->ArgNames({"spans", "order"})->ArgsProduct({{20, 1000}, {2, 3, 4}});

/// The row of a Hermite system: the derivative of this order of each Bernstein polynomial at an
/// end.
void setHermiteRow(math_Matrix& system, int row, int order, bool atEnd) {
  double factor = 1.0;
  for (int r = 0; r < order; ++r)
    factor *= kDegree - r;
  for (int j = 0; j <= kDegree; ++j)
    system(row, j + 1) = 0.0;
  for (int k = 0; k <= order; ++k) {
    const double sign = (order - k) % 2 == 0 ? 1.0 : -1.0;
    system(row, (atEnd ? kDegree - order + k : k) + 1) = sign * factor * binomial(order, k);
  }
}

/// C4 at both ends with the curves' own derivatives: the Hermite system, solved anew as a tool of
/// a few lines does.
Handle(Geom_BezierCurve)
    hermiteCurve(const Geom_Curve& first, double from, const Geom_Curve& second, double to) {
  math_Matrix system(1, kDegree + 1, 1, kDegree + 1);
  math_Vector right[3]{{1, kDegree + 1}, {1, kDegree + 1}, {1, kDegree + 1}};
  for (int order = 0; order <= kOrder; ++order) {
    for (const bool atEnd : {false, true}) {
      const int row = 2 * order + (atEnd ? 2 : 1);
      const Geom_Curve& curve = atEnd ? second : first;
      const double t = atEnd ? to : from;
      setHermiteRow(system, row, order, atEnd);
      const gp_XYZ value = order == 0 ? curve.Value(t).XYZ() : curve.DN(t, order).XYZ();
      for (int axis = 0; axis < 3; ++axis)
        right[axis](row) = value.Coord(axis + 1);
    }
  }
  const math_Gauss gauss(system);
  for (math_Vector& side : right)
    gauss.Solve(side);
  TColgp_Array1OfPnt poles(1, kDegree + 1);
  for (int i = 1; i <= kDegree + 1; ++i)
    poles(i) = gp_Pnt(right[0](i), right[1](i), right[2](i));
  return new Geom_BezierCurve(poles);
}

void hermiteByOcct(benchmark::State& state) {
  const test::BlendCase task = test::blendCases().front();
  const auto first = bench::geom(task.first);
  const auto second = bench::geom(task.second);
  for (auto _ : state)
    benchmark::DoNotOptimize(hermiteCurve(*first, 1.0, *second, 0.0));
}
BENCHMARK(hermiteByOcct);

}  // namespace
