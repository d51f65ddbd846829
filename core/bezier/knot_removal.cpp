#include "osculate/bezier/knot_removal.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <limits>

namespace osculate {

namespace {

constexpr int kMaxOld = 2 * kMaxDegree - 1;

using Insertion = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxOld, kMaxDegree>;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 4, 0, kMaxOld, 4>;

/// The knots and poles of a net in which a run of equal knots has become shorter.
class Shortened {
 public:
  Shortened(const SplineNet& net, SplineNet::Occurrence knot, int times)
      : net_(net), times_(times), firstGone_(knot.first + knot.multiplicity - times) {
    const int p = net.degree;
    // a pole changes where more copies than remain are among its knots i+1 .. i+p
    firstPole_ = knot.first - p + knot.multiplicity - times;
    oldPoles_ = 2 * times - 1 + p - knot.multiplicity;
  }

  int firstKnot() const { return firstGone_; }
  int firstPole() const { return firstPole_; }
  int oldPoles() const { return oldPoles_; }
  int newPoles() const { return oldPoles_ - times_; }
  double knot(int i) const { return net_.knot(i < firstGone_ ? i : i + times_); }
  bool isNew(int i) const { return firstPole_ <= i && i < firstPole_ + newPoles(); }
  /// One that stays.
  const Eigen::Vector4d& pole(int i) const { return net_.pole(i < firstPole_ ? i : i + times_); }

  /// The old pole `i` as a combination of the new poles `last - degree .. last`: a row of the
  /// matrix of knot insertion by the Oslo algorithm (Cohen, Lyche and Riesenfeld 1980).
  struct Row {
    int last;
    std::array<double, kMaxDegree + 1> factors;  ///< of the new poles last - degree + j
  };
  Row row(int i) const {
    const int p = net_.degree;
    Row result{spanOf(net_.knot(i), i), {}};
    result.factors[static_cast<std::size_t>(p)] = 1.0;
    for (int k = 1; k <= p; ++k) {
      const double x = net_.knot(i + k);
      for (int j = p - k + 1; j <= p; ++j) {
        const int column = result.last - p + j;
        const double low = knot(column);
        const double share = (x - low) / (knot(column + k) - low);
        double& factor = result.factors[static_cast<std::size_t>(j)];
        result.factors[static_cast<std::size_t>(j) - 1] += (1.0 - share) * factor;
        factor *= share;
      }
    }
    return result;
  }

 private:
  /// The index m with knot(m) <= t < knot(m+1), where t is the old knot i.
  int spanOf(double t, int i) const {
    int m = std::min(i, firstGone_ - 1);
    while (knot(m + 1) <= t)
      ++m;
    return m;
  }

  const SplineNet& net_;
  int times_;
  int firstGone_;
  int firstPole_ = 0;
  int oldPoles_ = 0;
};

/// A homogeneous point seen from the point c of space.
Eigen::Vector4d seenFrom(const Vector3& c, Eigen::Vector4d point) {
  point.head<3>() -= point[3] * c;
  return point;
}

/// The least-squares system: insertion * (new poles) = target, seen from one of the poles.
struct System {
  Vector3 origin;
  Insertion insertion;
  Points target;

  System(const SplineNet& net, const Shortened& after)
      : origin(project(net.pole(after.firstPole() + after.oldPoles() / 2))),
        insertion(Insertion::Zero(after.oldPoles(), after.newPoles())),
        target(after.oldPoles(), 4) {
    for (int i = 0; i < after.oldPoles(); ++i) {
      const Shortened::Row row = after.row(after.firstPole() + i);
      Eigen::Vector4d rest = seenFrom(origin, net.pole(after.firstPole() + i));
      for (int j = 0; j <= net.degree; ++j) {
        const int column = row.last - net.degree + j;
        const double factor = row.factors[static_cast<std::size_t>(j)];
        if (after.isNew(column)) {
          insertion(i, column - after.firstPole()) = factor;
        } else if (factor != 0.0) {
          rest -= factor * seenFrom(origin, after.pole(column));
        }
      }
      target.row(i) = rest;
    }
  }

  Points solution(bool rational) const {
    if (insertion.cols() == 0) return Points(0, 4);
    Points poles = insertion.colPivHouseholderQr().solve(target);
    if (!rational) poles.col(3).setOnes();
    return poles;
  }
};

/// What has influence where poles change.
struct Surroundings {
  double lightest;  ///< weight of the new curve
  double farthest;  ///< pole of the old curve from the origin, mm
};

Surroundings surroundings(const SplineNet& net, const Shortened& after, const System& system,
                          const Points& solution) {
  Surroundings result{std::numeric_limits<double>::infinity(), 0.0};
  if (solution.rows() > 0) result.lightest = solution.col(3).minCoeff();
  const int lastChanged = after.firstPole() + after.oldPoles() - 1;
  for (int i = after.firstPole() - net.degree; i <= lastChanged + net.degree; ++i) {
    if (!net.isPeriodic() && (i < 0 || i >= net.poleCount())) continue;
    const Eigen::Vector4d seen = seenFrom(system.origin, net.pole(i));
    result.farthest = std::max(result.farthest, seen.head<3>().norm() / seen[3]);
    const bool stays = i < after.firstPole() || i > lastChanged;
    if (stays) result.lightest = std::min(result.lightest, seen[3]);
  }
  return result;
}

/// The difference of the curves is sum N_i r_i, the residuals r_i over the old basis functions,
/// which are >= 0 and have at most the sum 1. Of a rational curve C = A/w, with the residuals (E,
/// e) of (A, w), it is sum N_i (E_i - e_i C) / w_new, and C lies in the hull of its poles.
double deviation(const SplineNet& net, const Shortened& after, const System& system,
                 const Points& solution) {
  Points residual = -system.target;
  if (solution.rows() > 0) residual += system.insertion * solution;
  const double distance = residual.leftCols<3>().rowwise().norm().maxCoeff();
  if (!net.rational) return distance;
  const Surroundings around = surroundings(net, after, system, solution);
  if (!(around.lightest > 0.0)) return std::numeric_limits<double>::infinity();
  const double weight = residual.col(3).cwiseAbs().maxCoeff();
  return (distance + around.farthest * weight) / around.lightest;
}

/// The poles of one period; those that change may reach across its beginning.
std::vector<Eigen::Vector4d> periodicPoles(const KnotRemoval& removal, const SplineNet& net) {
  const int count = net.poleCount() - removal.times;
  std::vector<Eigen::Vector4d> poles(static_cast<std::size_t>(count));
  const int changed = static_cast<int>(removal.poles.size());
  for (int i = 0; i < count; ++i) {
    const int k = removal.firstPole + i;
    poles[static_cast<std::size_t>((k % count + count) % count)] =
        i < changed ? removal.poles[static_cast<std::size_t>(i)] : net.pole(k + removal.times);
  }
  return poles;
}

}  // namespace

int removableTimes(const SplineNet& net, SplineNet::Occurrence knot, int least) {
  const int wanted = std::max(0, knot.multiplicity - least);
  if (!net.isPeriodic()) return wanted;
  // 2 times - 1 + degree - multiplicity poles change, and one more must be there
  return std::clamp((net.poleCount() - net.degree + knot.multiplicity) / 2, 0, wanted);
}

KnotRemoval proposeRemoval(const SplineNet& net, SplineNet::Occurrence knot, int times) {
  const Shortened after(net, knot, times);
  const System system(net, after);
  const Points solution = system.solution(net.rational);
  KnotRemoval removal{.firstKnot = after.firstKnot(),
                      .times = times,
                      .firstPole = after.firstPole(),
                      .oldPoles = after.oldPoles(),
                      .poles = {},
                      .deviationMm = deviation(net, after, system, solution)};
  for (Eigen::Index i = 0; i < solution.rows(); ++i)
    removal.poles.push_back(seenFrom(-system.origin, solution.row(i).transpose()));
  return removal;
}

void apply(const KnotRemoval& removal, SplineNet& net) {
  if (net.isPeriodic()) {
    net.poles = periodicPoles(removal, net);
  } else {
    const auto pole = net.poles.begin() + removal.firstPole;
    std::copy(removal.poles.begin(), removal.poles.end(), pole);
    net.poles.erase(pole + static_cast<std::ptrdiff_t>(removal.poles.size()),
                    pole + removal.oldPoles);
  }
  const auto knot = net.flat.begin() + removal.firstKnot;
  net.flat.erase(knot, knot + removal.times);
}

}  // namespace osculate
