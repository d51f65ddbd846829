#include "osculate/construction/beta_chord.h"

#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "osculate/bezier/index.h"
#include "osculate/construction/attach.h"
#include "osculate/differential/arc_jet.h"

namespace osculate {

namespace {

/// (Q(1) - Q(0)) / c as a polynomial in c: coefficient j-1 is A_j r_j/j!, where A_j is the sum of
/// the coefficients of t^1 .. t^n of (sum beta_k t^k / k!)^j.
class ChordPolynomial {
 public:
  ChordPolynomial(const ContactJet& contact, const GivenNumbers& beta, int degree)
      : order_(contact.order) {
    ArcLengthSeries perChord{};
    for (int k = 1; k <= order_; ++k)
      perChord[index(k - 1)] = *beta[index(k - 1)] / detail::kFactorials[index(k)];
    for (int j = 1; j <= order_; ++j) {
      // the powers of the series are those of a jet along a line
      ContactJet power;
      power.order = order_;
      power.r.fill(Vector3::Zero());
      power.r[index(j)] = Vector3(detail::kFactorials[index(j)], 0.0, 0.0);
      const BoundedPoles taylor = attachedTaylor(power, perChord);
      const double sum = taylor.row(0).segment(1, degree).sum();
      coefficients_[index(j - 1)] = sum / detail::kFactorials[index(j)] * contact.r[index(j)];
    }
  }

  /// |Q(1) - Q(0)| / c - 1.
  double excess(double c) const {
    Vector3 sum = Vector3::Zero();
    for (int j = order_; j >= 1; --j)
      sum = c * sum + coefficients_[index(j - 1)];
    return sum.norm() - 1.0;
  }
  bool isConstant(double c) const {
    double power = 1.0;
    for (int j = 2; j <= order_; ++j) {
      power *= c;
      if (power * coefficients_[index(j - 1)].norm() > 1e-12) return false;
    }
    return true;
  }

 private:
  int order_;
  std::array<Vector3, kMaxOrder> coefficients_;
};

double lengthOnLine(const GivenNumbers& beta, int order) {
  double sum = 0.0;
  for (int k = 1; k <= order; ++k)
    sum += *beta[index(k - 1)] / detail::kFactorials[index(k)];
  return sum;
}

}  // namespace

std::vector<double> chordsOfBeta(const ContactJet& contact, const GivenNumbers& beta, int degree,
                                 double unit) {
  constexpr int kSteps = 400;
  constexpr double kRange = 1e3;
  constexpr double kSame = 1e-9;
  const ChordPolynomial chord(contact, beta, degree);
  if (chord.isConstant(unit)) {
    if (std::abs(lengthOnLine(beta, contact.order) - 1.0) > kSame) return {};
    return {unit};
  }
  std::vector<double> roots;
  const auto excess = [&](double c) { return chord.excess(c); };
  double low = unit / kRange;
  double atLow = excess(low);
  const double factor = std::pow(kRange * kRange, 1.0 / kSteps);
  for (int i = 0; i < kSteps; ++i) {
    const double high = low * factor;
    const double atHigh = excess(high);
    if (atLow * atHigh < 0.0) {
      std::uintmax_t evaluations = 60;
      const auto root = boost::math::tools::toms748_solve(
          excess, low, high, atLow, atHigh, boost::math::tools::eps_tolerance<double>(),
          evaluations);
      roots.push_back(0.5 * (root.first + root.second));
    }
    low = high;
    atLow = atHigh;
  }
  return roots;
}

}  // namespace osculate
