#include "osculate/construction/knot_contact.h"

#include <gtest/gtest.h>

#include "support/random_curves.h"

namespace osculate::test {
namespace {

TEST(KnotContact, OfSimpleKnotsIsThatOfTheMultiplicity) {
  Random random(350);
  const BSplineCurve curve(randomSplineData(random, 4, {{0, 1, 2, 3}, {5, 1, 1, 5}}, true));
  const auto contacts = knotContacts(curve);
  ASSERT_EQ(contacts.size(), 2U);
  for (const KnotContact& contact : contacts) {
    EXPECT_EQ(contact.multiplicity, 1);
    EXPECT_EQ(contact.order, 3);
  }
}

TEST(KnotContact, OfMultipleKnotsIsWhatTheCurveHas) {
  Random random(351);
  // corners; knots inserted into a smooth curve; and knots that two pieces of one curve share
  const BSplineCurve corner(randomSplineData(random, 3, {{0, 1, 2}, {4, 3, 4}}, false));
  EXPECT_EQ(knotContacts(corner)[0].order, 0);
  const BSplineCurve tangent(randomSplineData(random, 3, {{0, 1, 2}, {4, 2, 4}}, false));
  EXPECT_EQ(knotContacts(tangent)[0].order, 1);
  const BSplineCurve raised =
      BSplineCurve(randomSplineData(random, 3, {{0, 1, 2}, {4, 1, 4}}, true)).elevated(2);
  EXPECT_EQ(knotContacts(raised)[0].multiplicity, 3);
  EXPECT_EQ(knotContacts(raised)[0].order, 2);
}

TEST(KnotContact, HasTheNumbersOfTheReparametrisation) {
  Random random(352);
  const auto [left, right] = randomBezier(random, 4, false).split(0.4);
  BSplineData data{.poles = Poles(3, 9),
                   .weights = {},
                   .knots = {{0, 1, 2}, {5, 4, 5}},
                   .degree = 4,
                   .periodic = false,
                   .poleError = 0.0};
  for (int i = 0; i <= 4; ++i) {
    data.poles.col(i) = left.pole(i);
    data.poles.col(4 + i) = right.pole(i);
  }
  const KnotContact contact = knotContacts(BSplineCurve(data))[0];
  EXPECT_EQ(contact.order, 3);  // as a simple knot
  EXPECT_NEAR(contact.beta[0], 0.6 / 0.4, 1e-12);
  EXPECT_NEAR(contact.beta[1], 0.0, 1e-10);
  EXPECT_NEAR(contact.beta[2], 0.0, 1e-8);
}

TEST(KnotContact, OfATornKnotIsNone) {
  Random random(353);
  BSplineData data = randomSplineData(random, 2, {{0, 1, 2}, {3, 3, 3}}, false);
  EXPECT_EQ(knotContacts(BSplineCurve(data))[0].order, -1);
  data.poles.col(3) = data.poles.col(2);
  EXPECT_EQ(knotContacts(BSplineCurve(data))[0].order, 0);
}

}  // namespace
}  // namespace osculate::test
