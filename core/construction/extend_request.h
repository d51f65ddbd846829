// What a call of extend asks for, checked, and the task that it means at each degree; private to
// this floor.
#pragma once

#include "osculate/construction/extend_problem.h"

namespace osculate {

/// A checked request with what it needs of the curve.
class ExtendRequest {
 public:
  /// Throws as extend does for numbers outside their range and for requests that contradict each
  /// other.
  ExtendRequest(const BSplineCurve& curve, const ExtendOptions& options);

  const ExtendOptions& options() const { return options_; }
  int order() const { return options_.order; }
  const ContactJet& contact() const { return contact_; }
  /// The lowest degree that is tried where none is asked for.
  int lowestDegree() const { return options_.order < 1 ? 1 : options_.order; }
  /// Where the given beta are all that the contact has, so that they fix the chord.
  bool isFixedByBeta(int degree) const;
  /// The curve's own tangential series.
  const ArcLengthSeries& ownSeries() const { return ownSeries_; }
  /// False where a parametric request has derivatives above the degree.
  bool canBeParametric(int degree) const;

  /// With a length, if need be the one that is taken where none is given.
  ExtendTask task(int degree) const;
  /// "it has 4 numbers for 5 conditions: to_point (3), to_direction (2)".
  std::string count(int degree) const;
  bool isOverdetermined(int degree) const;

 private:
  bool isParametric() const { return options_.parametric || options_.parameter.has_value(); }
  void setOwnSeries(const BSplineCurve& curve);
  void checkTargets() const;
  double defaultLength(const ExtendTask& task) const;
  int numbers(int degree) const;
  struct Condition {
    std::string name;
    int count;
  };
  std::vector<Condition> conditions(int degree) const;

  ExtendOptions options_;
  ContactJet contact_;
  GraphJet jet_;
  double reach_;
  ArcLengthSeries ownSeries_{};
  int ownDegree_ = kMaxOrder;  ///< the last of its own derivatives that does not vanish
};

}  // namespace osculate
