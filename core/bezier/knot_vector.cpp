#include "osculate/bezier/knot_vector.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "osculate/bezier/vector3.h"

namespace osculate {

std::vector<double> flatten(const KnotVector& knots) {
  std::vector<double> flat;
  for (std::size_t i = 0; i < knots.knots.size(); ++i) {
    flat.insert(flat.end(), static_cast<std::size_t>(knots.multiplicities[i]), knots.knots[i]);
  }
  return flat;
}

KnotVector compress(std::span<const double> flat) {
  KnotVector result;
  for (const double knot : flat) {
    if (!result.knots.empty() && result.knots.back() == knot) {
      ++result.multiplicities.back();
    } else {
      result.knots.push_back(knot);
      result.multiplicities.push_back(1);
    }
  }
  return result;
}

namespace {

void checkIncreasing(const std::vector<double>& knots) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]))
      throw std::invalid_argument("knots: every knot must be finite (found NaN or infinity)");
    if (i > 0 && !(knots[i] > knots[i - 1])) {
      throw std::invalid_argument(
          "knots: must increase strictly (repeat a knot by its multiplicity), but knot " +
          std::to_string(i + 1) + " is not above the one before it");
    }
  }
}

void checkMultiplicity(int multiplicity, int largest) {
  if (multiplicity < 1 || multiplicity > largest) {
    throw std::invalid_argument("multiplicities: each must be from 1 to " +
                                std::to_string(largest) + ", got " + std::to_string(multiplicity));
  }
}

}  // namespace

void checkKnots(const KnotVector& knots, int degree, int poleCount, bool periodic) {
  if (degree < 1 || degree > kMaxDegree) {
    throw std::invalid_argument("degree: must be from 1 to " + std::to_string(kMaxDegree) +
                                ", got " + std::to_string(degree));
  }
  if (knots.knots.size() < 2 || knots.knots.size() != knots.multiplicities.size()) {
    throw std::invalid_argument("multiplicities: one for each of at least 2 knots is needed, got " +
                                std::to_string(knots.multiplicities.size()) + " for " +
                                std::to_string(knots.knots.size()) + " knots");
  }
  checkIncreasing(knots.knots);
  int sum = 0;
  for (const int multiplicity : knots.multiplicities) {
    checkMultiplicity(multiplicity, periodic ? degree : degree + 1);
    sum += multiplicity;
  }
  if (periodic && knots.multiplicities.front() != knots.multiplicities.back()) {
    throw std::invalid_argument(
        "multiplicities: of a periodic curve the first and the last must be equal");
  }
  const int expected = periodic ? poleCount + knots.multiplicities.back() : poleCount + degree + 1;
  if (sum != expected) {
    throw std::invalid_argument("multiplicities: their sum must be " + std::to_string(expected) +
                                (periodic
                                     ? " (poles plus the last multiplicity of a periodic curve)"
                                     : " (poles + degree + 1)") +
                                ", got " + std::to_string(sum));
  }
  if (!periodic && poleCount < degree + 1) {
    throw std::invalid_argument("poles: a curve of degree " + std::to_string(degree) +
                                " needs at least " + std::to_string(degree + 1) + " poles, got " +
                                std::to_string(poleCount));
  }
}

}  // namespace osculate
