// The decision on the sign of the Jacobian.
#include <algorithm>
#include <array>
#include <cstdio>

#include "osculate/solid/domain_part.h"
#include "osculate/solid/jacobian.h"

namespace osculate {

namespace {

/// The faces of a simplex as sets of corners: bit c for corner c.
using CornerSet = unsigned;
constexpr CornerSet kAllCorners = 15;

/// For each set of corners, whether all coefficients that belong to it alone vanish.
class VanishingFaces {
 public:
  VanishingFaces(const DomainPart& part, int degree) {
    vanishes_.fill(true);
    Eigen::Index position = 0;
    for (const MultiIndex<4>& i : multiIndices<4>(degree)) {
      CornerSet support = 0;
      for (unsigned c = 0; c < 4; ++c)
        support |= i[c] > 0 ? 1U << c : 0U;
      if (part.value(position) > part.error(position)) {
        for (CornerSet set = 1; set < 16; ++set)
          vanishes_[set] = vanishes_[set] && (support & ~set) != 0U;
      }
      ++position;
    }
  }

  /// Those that are not within a larger one.
  std::vector<CornerSet> maximal() const {
    std::vector<CornerSet> result;
    for (CornerSet set = 1; set < 16; ++set) {
      if (vanishes_[set] && !inLarger(set)) result.push_back(set);
    }
    return result;
  }

 private:
  bool inLarger(CornerSet set) const {
    for (CornerSet other = 1; other < 16; ++other) {
      if (other != set && (other & set) == set && vanishes_[other]) return true;
    }
    return false;
  }

  std::array<bool, 16> vanishes_{};
};

class Certifier {
 public:
  Certifier(const JacobianNumerator& numerator, const CertificateOptions& options)
      : degree_(numerator.degree), options_(options) {
    stack_.emplace_back(numerator.coefficients, numerator.errors, degree_);
  }

  ValidityCertificate run() {
    while (!stack_.empty() && result_.parts < options_.maxParts && !isFolded()) {
      DomainPart part = std::move(stack_.back());
      stack_.pop_back();
      ++result_.parts;
      if (look(part)) continue;
      stack_.push_back(part.bisect());
      stack_.push_back(std::move(part));
    }
    conclude();
    return std::move(result_);
  }

 private:
  /// Nothing more can change: J has both signs.
  bool isFolded() const { return result_.witness && anyPositive_; }

  /// Whether the part is decided; otherwise it is to be bisected.
  bool look(const DomainPart& part) {
    for (int c = 0; c < 4; ++c) {
      const double value = part.cornerValue(c);
      const double error = part.cornerError(c);
      anyPositive_ = anyPositive_ || value > error;
      if (value < -error && value < worst_) {
        worst_ = value;
        result_.witness = part.corner(c);
      }
    }
    if (part.allBelowErrors()) {
      if (part.hasNegative()) negativeWithin(part);
      if (!part.hasNegative()) addPlace(part, kAllCorners);
      return true;
    }
    if (part.allAboveMinusErrors()) {
      anyPositive_ = true;
      for (const CornerSet set : VanishingFaces(part, degree_).maximal())
        addPlace(part, set);
      return true;
    }
    pending_ = part.corner(0);
    return false;
  }

  /// J <= 0 on the part, and < 0 in its interior: its middle is a witness where no corner is one.
  void negativeWithin(const DomainPart& part) {
    if (result_.witness) return;
    result_.witness = 0.25 * (part.corner(0) + part.corner(1) + part.corner(2) + part.corner(3));
  }

  void addPlace(const DomainPart& part, CornerSet set) {
    SingularPlace place;
    Barycentric<4> sum = Barycentric<4>::Zero();
    for (int c = 0; c < 4; ++c) {
      if ((set >> static_cast<unsigned>(c) & 1U) == 0U) continue;
      place.corners.push_back(part.corner(c));
      sum += part.corner(c);
    }
    for (int c = 0; c < 4; ++c) {
      if (sum[c] > 0.0) place.between.push_back(c);
    }
    result_.places.push_back(place);
  }

  void conclude() {
    const bool finished = stack_.empty();  // every part decided
    result_.mirrored = result_.witness && !anyPositive_ && finished;
    if (result_.witness) {
      result_.validity = Validity::kInverted;
    } else if (!finished) {
      result_.validity = Validity::kUndecided;
      result_.witness = pending_;
    } else if (anyPositive_ && result_.places.empty()) {
      result_.validity = Validity::kValid;
    } else {
      result_.validity = Validity::kSingular;
      if (!anyPositive_) result_.places = {everywhere()};
    }
    mergePlaces();
  }

  static SingularPlace everywhere() {
    const auto corners = unitCorners<4>();
    return {{corners.begin(), corners.end()}, {0, 1, 2, 3}};
  }

  /// Bisection meets the same corner, edge or face of the solid in many parts: each is told once,
  /// and pieces of a place that has been told whole are left out.
  void mergePlaces() {
    std::vector<SingularPlace> merged;
    for (const SingularPlace& place : result_.places) {
      const bool known = std::any_of(merged.begin(), merged.end(), [&](const SingularPlace& other) {
        return other.between == place.between && other.corners.size() >= place.corners.size() &&
               place.between.size() < 4;
      });
      if (!known) merged.push_back(place);
    }
    std::erase_if(merged, [&](const SingularPlace& place) {
      return std::any_of(merged.begin(), merged.end(), [&](const SingularPlace& other) {
        return other.between.size() > place.between.size() &&
               other.corners.size() == other.between.size() &&
               std::includes(other.between.begin(), other.between.end(), place.between.begin(),
                             place.between.end());
      });
    });
    std::sort(merged.begin(), merged.end(), [](const SingularPlace& a, const SingularPlace& b) {
      return std::pair(a.corners.size(), a.between) < std::pair(b.corners.size(), b.between);
    });
    result_.places = std::move(merged);
  }

  int degree_;
  CertificateOptions options_;
  std::vector<DomainPart> stack_;
  ValidityCertificate result_;
  Barycentric<4> pending_ = Barycentric<4>::Zero();
  double worst_ = 0.0;
  bool anyPositive_ = false;
};

std::string text(const Barycentric<4>& u) {
  std::array<char, 128> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%.6g, %.6g, %.6g, %.6g)", u[0], u[1], u[2], u[3]);
  return buffer.data();
}

std::string text(const SingularPlace& place) {
  const std::size_t between = place.between.size();
  if (place.corners.size() == 4) return "every point";
  if (place.corners.size() < between || between == 4)
    return "a place about " + text(place.corners.front());
  if (between == 1) return "corner " + std::to_string(place.between[0]);
  if (between == 2)
    return "edge " + std::to_string(place.between[0]) + "-" + std::to_string(place.between[1]);
  return "face " + std::to_string(6 - place.between[0] - place.between[1] - place.between[2]);
}

}  // namespace

std::string_view name(Validity validity) {
  static constexpr std::array<std::string_view, 4> kNames{"valid", "singular", "inverted",
                                                          "undecided"};
  return kNames[static_cast<std::size_t>(validity)];
}

ValidityCertificate certify(const BezierTetrahedron& solid, const CertificateOptions& options) {
  return Certifier(jacobianNumerator(solid), options).run();
}

std::string describe(const ValidityCertificate& certificate) {
  std::string result(name(certificate.validity));
  switch (certificate.validity) {
    case Validity::kValid:
      return result;
    case Validity::kUndecided:
      return result + " near " + text(*certificate.witness);
    case Validity::kInverted:
      return result + (certificate.mirrored ? " everywhere (a mirror image), as at " : " at ") +
             text(*certificate.witness);
    case Validity::kSingular:
      break;
  }
  const char* joint = " at ";
  for (const SingularPlace& place : certificate.places) {
    result += joint + text(place);
    joint = ", ";
  }
  return result;
}

}  // namespace osculate
