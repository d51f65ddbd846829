// The neighbour of a Bézier tetrahedron over one of its faces, with C^s contact.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

struct NeighbourOptions {
  /// Where the control point of the new corner goes, in mm. Without: what the smoothest fill gives;
  /// with contact of order 0 the place that the corners of the solid send it to. Not used where the
  /// contact already forces that point (order = degree).
  std::optional<SpacePoint> apexPoint;
};

/// The points of layers 0 .. order of the neighbour, W_(r,j,k,l) = V^r_(0,j,k,l)(apex) (thesis,
/// theorem 1.5.1; r counts at corner `face`), in homogeneous coordinates; all other columns are
/// NaN. Nothing is checked; apex may be anywhere.
SimplexNet forcedLayers(const SimplexNet& net, int degree, int face, const Barycentric<4>& apex,
                        int order);

/// The tetrahedron that replaces corner `face` by a new one beyond the opposite face, and meets
/// this one there with C^order.
///
/// apex: the new corner of the domain in barycentric coordinates of the old one (sum 1, finite,
/// apex[face] < 0). order: 0 to the degree. Layers above the order are free: their weights are the
/// discrete harmonic ones, their points minimise the sum of squared second differences of the net.
/// The labels are the thesis' (corner `face` is the new one, the others stay), so that the
/// orientation is the opposite of the solid's. Throws std::invalid_argument for bad arguments,
/// ContactError where a rational solid forces a negative weight.
BezierTetrahedron neighbour(const BezierTetrahedron& solid, int face, const Barycentric<4>& apex,
                            int order, const NeighbourOptions& options = {});

/// One link of a chain: over which face of the one before, to where, with which order.
struct ChainLink {
  int face = 0;
  Barycentric<4> apex;
  int order = 0;
  NeighbourOptions options = {};
};

/// The solid, its neighbour, the neighbour's neighbour and so on; labels as those of neighbour().
std::vector<BezierTetrahedron> chain(const BezierTetrahedron& solid,
                                     std::span<const ChainLink> links);

}  // namespace osculate
