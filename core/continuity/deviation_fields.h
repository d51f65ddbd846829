// The deviations of a join by their names in files; private to this floor.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "osculate/continuity/join_report.h"

namespace osculate {

struct DeviationField {
  std::string_view name;
  std::optional<double> Deviation::*member;
};

/// All but the gap, which always exists: "gap_mm".
inline constexpr std::array<DeviationField, 8> kDeviationFields{{
    {"tangent_angle_deg", &Deviation::tangentAngleDegrees},
    {"curvature_vector_per_mm", &Deviation::curvatureVectorPerMm},
    {"curvature_relative", &Deviation::curvatureRelative},
    {"osculating_plane_angle_deg", &Deviation::osculatingPlaneAngleDegrees},
    {"torsion_per_mm", &Deviation::torsionPerMm},
    {"curvature_rate_per_mm2", &Deviation::curvatureRatePerMm2},
    {"torsion_rate_per_mm2", &Deviation::torsionRatePerMm2},
    {"curvature_rate2_per_mm3", &Deviation::curvatureRate2PerMm3},
}};

}  // namespace osculate
