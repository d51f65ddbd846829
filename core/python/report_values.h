// Numbers of reports as Python values; private to this floor.
#pragma once

#include <cmath>

#include <pybind11/stl.h>

#include "osculate/continuity/join_report.h"
#include "osculate/python/bindings.h"

namespace osculate::python {

/// None for what does not exist.
inline py::object finite(double value) {
  return std::isfinite(value) ? py::object(py::float_(value)) : py::none();
}

/// The numbers of the orders 0 .. order.
inline py::tuple upTo(int order, const PerOrder& values) {
  py::tuple result(order + 1);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = finite(values[k]);
  return result;
}

inline py::dict deviationDict(const Deviation& d) {
  py::dict result;
  result["gap_mm"] = d.gapMm;
  result["tangent_angle_deg"] = d.tangentAngleDegrees;
  result["curvature_vector_per_mm"] = d.curvatureVectorPerMm;
  result["curvature_relative"] = d.curvatureRelative;
  result["osculating_plane_angle_deg"] = d.osculatingPlaneAngleDegrees;
  result["torsion_per_mm"] = d.torsionPerMm;
  result["curvature_rate_per_mm2"] = d.curvatureRatePerMm2;
  result["torsion_rate_per_mm2"] = d.torsionRatePerMm2;
  result["curvature_rate2_per_mm3"] = d.curvatureRate2PerMm3;
  return result;
}

}  // namespace osculate::python
