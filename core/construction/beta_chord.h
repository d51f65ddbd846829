// The chord of a curve whose free numbers are all given without dimension; private to this floor.
#pragma once

#include <vector>

#include "osculate/construction/extend.h"

namespace osculate {

/// The chords c > 0 in mm for which s(t) = c sum beta_k t^k / k! gives a curve Q of this degree (at
/// most the order of contact, with all beta up to it given) with |Q(1) - Q(0)| = c, in ascending
/// order, between a thousandth and a thousand times `unit`; where every c does (on a straight
/// line), that which gives the length `unit`.
std::vector<double> chordsOfBeta(const ContactJet& contact, const GivenNumbers& beta, int degree,
                                 double unit);

}  // namespace osculate
