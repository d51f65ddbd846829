#include "osculate/occt/near_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>

namespace osculate {

namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t number : cell)
      hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(hash ^ hash >> 32U);
  }
};

/// Points in cubes as wide as the tolerance, so that near ones are in the same or in neighbouring
/// cubes.
class PointGrid {
 public:
  PointGrid(const std::vector<Vector3>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {}

  void add(int point) { cells_[cellOf(points_[static_cast<std::size_t>(point)])].push_back(point); }

  /// Calls visit(other, distance) for the points added within the tolerance.
  template <class Visit>
  void visitNear(int point, Visit visit) const {
    const Vector3& here = points_[static_cast<std::size_t>(point)];
    const Cell centre = cellOf(here);
    for (int i = 0; i < 27; ++i) {
      const auto found =
          cells_.find({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
      if (found == cells_.end()) continue;
      for (const int other : found->second) {
        const double distance = (points_[static_cast<std::size_t>(other)] - here).norm();
        if (distance <= tolerance_) visit(other, distance);
      }
    }
  }

 private:
  /// Where coordinates are too large for the numbers of cells, many share one.
  Cell cellOf(const Vector3& point) const {
    constexpr double kLargest = 4e18;
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double number = std::floor(point[static_cast<Eigen::Index>(axis)] / tolerance_);
      cell[axis] = static_cast<std::int64_t>(std::clamp(number, -kLargest, kLargest));
    }
    return cell;
  }

  const std::vector<Vector3>& points_;
  double tolerance_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

}  // namespace

std::vector<int> mergePoints(const std::vector<Vector3>& points, double tolerance) {
  PointGrid grid(points, tolerance);
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int own = static_cast<int>(i);
    first[i] = own;
    if (!points[i].allFinite()) continue;
    grid.visitNear(own, [&](int other, double) { first[i] = std::min(first[i], other); });
    if (first[i] == own) grid.add(own);
  }
  return first;
}

std::vector<std::pair<int, int>> matchPoints(const std::vector<Vector3>& points, double tolerance) {
  PointGrid grid(points, tolerance);
  std::vector<std::tuple<double, int, int>> candidates;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    const int own = static_cast<int>(i);
    grid.visitNear(
        own, [&](int other, double distance) { candidates.emplace_back(distance, other, own); });
    grid.add(own);
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<bool> taken(points.size(), false);
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [distance, a, b] : candidates) {
    if (taken[static_cast<std::size_t>(a)] || taken[static_cast<std::size_t>(b)]) continue;
    taken[static_cast<std::size_t>(a)] = taken[static_cast<std::size_t>(b)] = true;
    pairs.emplace_back(a, b);
  }
  return pairs;
}

}  // namespace osculate
