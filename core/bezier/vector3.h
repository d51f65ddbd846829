// The scalar and vector types that every floor shares.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace osculate {

/// A point or a vector of space, in mm.
using Vector3 = Eigen::Vector3d;

/// Poles of a curve as columns: 3 x (n+1), in mm.
using Poles = Eigen::Matrix3Xd;

/// Half a unit in the last place of 1: the relative error of a correctly rounded double.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// The largest degree of a curve, which is also OpenCASCADE's.
inline constexpr int kMaxDegree = 25;

}  // namespace osculate
