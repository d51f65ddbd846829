// Knots with multiplicities, and the flat sequence that the B-spline algorithms read.
#pragma once

#include <span>
#include <vector>

namespace osculate {

/// Distinct increasing knots and how often each is repeated.
struct KnotVector {
  std::vector<double> knots;
  std::vector<int> multiplicities;
};

/// Every knot as often as its multiplicity says.
std::vector<double> flatten(const KnotVector& knots);
/// The inverse of flatten: equal neighbours become one knot with a multiplicity.
KnotVector compress(std::span<const double> flat);

/// Throws std::invalid_argument that names the rule: increasing finite knots, multiplicities from
/// 1 to degree+1 (periodic: to degree, equal at both ends), and their sum poles+degree+1 (periodic:
/// the sum without the last is the number of poles).
void checkKnots(const KnotVector& knots, int degree, int poleCount, bool periodic);

}  // namespace osculate
