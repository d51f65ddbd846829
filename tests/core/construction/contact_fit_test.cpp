#include "osculate/construction/contact_fit.h"

#include <gtest/gtest.h>

#include "osculate/bezier/bernstein.h"
#include "support/random_curves.h"

namespace osculate::test {
namespace {

/// A target, and the first poles of a Bézier curve of degree 7 with some positive cost.
struct Sample {
  ContactJet target;
  FirstPoles first;
};

Sample sampleOf(Random& random, int order) {
  Sample sample;
  sample.target.order = order;
  sample.target.r[0] = random.vector(5.0);
  sample.target.r[1] = random.direction();
  for (std::size_t k = 2; k <= static_cast<std::size_t>(order); ++k)
    sample.target.r[k] = random.vector(0.1);
  const int count = order + 1;
  sample.first.old.resize(3, count);
  sample.first.byTaylor.resize(count, count);
  Eigen::MatrixXd root(count, count);
  for (int i = 0; i < count; ++i) {
    sample.first.old.col(i) =
        sample.target.r[0] + 3.0 * i * sample.target.r[1] + random.vector(2.0);
    for (int k = 0; k < count; ++k) {
      sample.first.byTaylor(i, k) = k <= i ? binomial(i, k) / binomial(7, k) : 0.0;
      root(i, k) = random.uniform(-1.0, 1.0) + (i == k ? 2.0 : 0.0);
    }
  }
  sample.first.cost = root.transpose() * root;
  return sample;
}

double costOf(const Sample& sample, const ArcLengthSeries& sigma) {
  const Eigen::MatrixXd moved = attach(sample.target, sigma, 7) - sample.first.old;
  return (moved * sample.first.cost * moved.transpose()).trace();
}

TEST(ContactFit, HasThePolesAndCostOfItsNumbers) {
  Random random(370);
  for (int order = 0; order <= kMaxOrder - 1; ++order) {
    const Sample sample = sampleOf(random, order);
    const ContactFit fit = fitContact(sample.target, sample.first, {.start = {20.0}});
    EXPECT_LE((fit.poles - attach(sample.target, fit.sigma, 7)).norm(), 1e-10) << order;
    EXPECT_NEAR(fit.cost, costOf(sample, fit.sigma), 1e-9 * fit.cost) << order;
  }
}

TEST(ContactFit, IsAStationaryMinimum) {
  Random random(371);
  for (int trial = 0; trial < 20; ++trial) {
    for (int order = 1; order <= 4; ++order) {
      const Sample sample = sampleOf(random, order);
      const ContactFit fit = fitContact(sample.target, sample.first, {.start = {20.0}});
      for (std::size_t k = 0; k < static_cast<std::size_t>(order); ++k) {
        for (const double step : {-1e-3, 1e-3, -1e-2, 1e-2}) {
          if (k == 0 && step < 0.0 && fit.sigma[0] == 0.0) continue;  // at its bound
          ArcLengthSeries beside = fit.sigma;
          beside[k] += step;
          EXPECT_GE(costOf(sample, beside), fit.cost * (1.0 - 1e-12))
              << order << ", sigma_" << k + 1 << " at " << fit.sigma[k] << ", step " << step;
        }
      }
    }
  }
}

TEST(ContactFit, KeepsGivenNumbersAndTheSpeedAboveItsBound) {
  Random random(372);
  const Sample sample = sampleOf(random, 3);
  FitOptions options{.start = {20.0}};
  options.given[1] = 4.5;
  EXPECT_EQ(fitContact(sample.target, sample.first, options).sigma[1], 4.5);
  const double free = fitContact(sample.target, sample.first, {.start = {20.0}}).sigma[0];
  options = {.start = {20.0}, .lowestSpeed = free + 5.0};
  const ContactFit bounded = fitContact(sample.target, sample.first, options);
  EXPECT_EQ(bounded.sigma[0], free + 5.0);
  options.lowestSpeed = free - 0.1;
  EXPECT_NEAR(fitContact(sample.target, sample.first, options).sigma[0], free, 1e-6);
}

TEST(ContactFit, FindsNumbersThatCostNothing) {
  Random random(373);
  for (int order = 1; order <= 6; ++order) {
    Sample sample = sampleOf(random, order);
    ArcLengthSeries sigma{15.0, 2.0, -1.0, 0.5, 0.2, -0.1};
    sample.first.old = attach(sample.target, sigma, 7);
    const ContactFit fit = fitContact(sample.target, sample.first, {.start = {20.0}});
    EXPECT_LE(fit.cost, 1e-18) << order;
    for (std::size_t k = 0; k < static_cast<std::size_t>(order); ++k)
      EXPECT_NEAR(fit.sigma[k], sigma[k], 1e-7) << order;
  }
}

}  // namespace
}  // namespace osculate::test
