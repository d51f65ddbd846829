// Bézier solids: points a second beside a plain de Casteljau of the same net, meshes for display,
// the certificate of validity.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "osculate/bezier/simplex_evaluator.h"
#include "osculate/solid/jacobian.h"
#include "osculate/solid/measure.h"
#include "osculate/solid/mesh.h"
#include "osculate/solid/primitives.h"

namespace {

using namespace osculate;

constexpr int kGrid = 60;

BezierTetrahedron sample(int degree) { return randomTetrahedron(degree, 1); }

/// The recursion of the definition on points (w x, w y, w z, w), as compiled code without a
/// library.
class PlainDeCasteljau {
 public:
  explicit PlainDeCasteljau(const BezierTetrahedron& solid) : degree_(solid.degree()) {
    const SimplexNet net = solid.homogeneousWithWeights();
    points_.assign(net.data(), net.data() + net.size());
    work_ = points_;
  }

  void evaluate(double u, double v, double w, double t, double* out) {
    std::copy(points_.begin(), points_.end(), work_.begin());
    double* const x = work_.data();
    for (int n = degree_ - 1; n >= 0; --n) {
      int to = 0;
      for (int layer = 0; layer <= n; ++layer) {
        const int step = (layer + 1) * (layer + 2) / 2;
        for (int rest = 0; rest <= layer; ++rest) {
          for (int last = 0; last <= rest; ++last, ++to) {
            const int second = to + step;
            const int third = second + rest + 1;
            for (int k = 0; k < 4; ++k) {
              x[4 * to + k] = u * x[4 * to + k] + v * x[4 * second + k] + w * x[4 * third + k] +
                              t * x[4 * third + 4 + k];
            }
          }
        }
      }
    }
    for (int k = 0; k < 3; ++k)
      out[k] = x[k] / x[3];
  }

 private:
  int degree_;
  std::vector<double> points_;
  std::vector<double> work_;
};

void countPoints(benchmark::State& state, std::size_t points) {
  state.SetItemsProcessed(static_cast<std::int64_t>(points) * state.iterations());
}

void solidGrid(benchmark::State& state) {
  const TetrahedronEvaluator evaluator(sample(4));
  std::vector<double> out(3 * TetrahedronEvaluator::gridSize(kGrid));
  for (auto _ : state) {
    evaluator.grid(kGrid, out);
    benchmark::ClobberMemory();
  }
  countPoints(state, out.size() / 3);
}
BENCHMARK(solidGrid);

std::vector<double> gridCoordinates() {
  std::vector<double> coordinates;
  for (const MultiIndex<4>& i : multiIndices<4>(kGrid)) {
    for (const int count : i)
      coordinates.push_back(static_cast<double>(count) / kGrid);
  }
  return coordinates;
}

void solidPoints(benchmark::State& state) {
  const TetrahedronEvaluator evaluator(sample(4));
  const std::vector<double> coordinates = gridCoordinates();
  std::vector<double> out(coordinates.size() / 4 * 3);
  for (auto _ : state) {
    evaluator.points(coordinates, out);
    benchmark::ClobberMemory();
  }
  countPoints(state, out.size() / 3);
}
BENCHMARK(solidPoints);

void solidDeCasteljau(benchmark::State& state) {
  PlainDeCasteljau evaluator(sample(4));
  const std::vector<double> u = gridCoordinates();
  std::vector<double> out(u.size() / 4 * 3);
  for (auto _ : state) {
    for (std::size_t i = 0; i < u.size() / 4; ++i)
      evaluator.evaluate(u[4 * i], u[4 * i + 1], u[4 * i + 2], u[4 * i + 3], out.data() + 3 * i);
    benchmark::ClobberMemory();
  }
  countPoints(state, out.size() / 3);
}
BENCHMARK(solidDeCasteljau);

/// Every face of a solid of degree 4, 100 mm, to 0.01 mm.
void showSolid(benchmark::State& state, const BezierTetrahedron& solid) {
  std::size_t triangles = 0;
  for (auto _ : state) {
    const int m = divisionsFor(solid, 0.01);
    triangles = 0;
    for (int face = 0; face < 4; ++face) {
      const FaceMesh mesh = faceMesh(solid, face, m);
      benchmark::DoNotOptimize(mesh.points.data());
      triangles += mesh.triangles.size() / 3;
    }
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
void showOctant(benchmark::State& state) { showSolid(state, ballOctant(100.0)); }
BENCHMARK(showOctant)->Unit(benchmark::kMillisecond);
void showRandom(benchmark::State& state) { showSolid(state, sample(4)); }
BENCHMARK(showRandom)->Unit(benchmark::kMillisecond);

void adaptiveOctant(benchmark::State& state) {
  const BezierTetrahedron solid = ballOctant(100.0);
  std::size_t tetrahedra = 0;
  for (auto _ : state)
    tetrahedra = adaptiveMesh(solid, 0.1).tetrahedra.size() / 4;
  state.counters["tetrahedra"] = static_cast<double>(tetrahedra);
}
BENCHMARK(adaptiveOctant)->Unit(benchmark::kMillisecond);

/// 20 solids in turn: the mean is what is typical.
void certifySolid(benchmark::State& state) {
  std::vector<BezierTetrahedron> solids;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    solids.push_back(randomTetrahedron(static_cast<int>(state.range(0)), seed));
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(certify(solids[next++ % solids.size()]));
}
BENCHMARK(certifySolid)->ArgName("degree")->Arg(2)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond);

void measureSolid(benchmark::State& state) {
  const BezierTetrahedron solid = sample(3);
  for (auto _ : state)
    benchmark::DoNotOptimize(measure(solid));
}
BENCHMARK(measureSolid)->Unit(benchmark::kMillisecond);

}  // namespace
