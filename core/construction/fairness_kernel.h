// The loops over the nodes of a fairness objective, where nearly all time of a search goes; private
// to this floor. Plain loops over arrays, compiled for wide registers too and chosen when the
// program runs; each sum has its own fixed order, so that every machine gives the same digits.
#pragma once

#include "osculate/construction/attach.h"
#include "osculate/construction/fairness_table.h"

namespace osculate {

/// Coordinates x, y, z at each node.
template <int Nodes>
struct NodeVectors {
  alignas(32) double at[3][Nodes];
};

/// A polynomial Bézier curve's first three derivatives a, b, c at the nodes, and what both energies
/// need of them.
template <int Nodes>
struct NodeDerivatives {
  NodeVectors<Nodes> a, b, c;
  alignas(32) double speed[Nodes];    ///< |a|
  alignas(32) double inverse[Nodes];  ///< 1/|a|
  alignas(32) double p[Nodes];        ///< a.b
};

/// An energy's density f per parameter, with its derivatives by a, b, c.
template <int Nodes>
struct NodeDensity {
  alignas(32) double f[Nodes];
  NodeVectors<Nodes> byA, byB, byC;
};

/// What a sum of densities and speeds weighs them with at each node.
template <int Nodes>
struct NodeFactors {
  AtNodes<Nodes> density;
  AtNodes<Nodes> speed;
};

// for kCoarseNodes and kFineNodes

template <int Nodes>
void setDerivatives(const NodeTable<Nodes>& table, const BoundedPoles& poles,
                    NodeDerivatives<Nodes>& out);

/// |r_3|^2 |a|, r_3 = c/v^3 - 3 p b/v^5 - (b.b + a.c) a/v^5 + 4 p^2 a/v^7 (v = |a|): d/ds of
/// kappa n = b/v^2 - p a/v^4.
template <int Nodes>
void setVariation(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out);

/// kappa^2 |a| = b.b/v^3 - p^2/v^5.
template <int Nodes>
void setBending(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out);

/// The derivatives by the poles of sum_i factors.density_i f(a_i, b_i, c_i) + factors.speed_i
/// |a_i|; `gradient` has their shape already.
template <int Nodes>
void setGradient(const NodeTable<Nodes>& table, const NodeDerivatives<Nodes>& d,
                 const NodeDensity<Nodes>& density, const NodeFactors<Nodes>& factors,
                 BoundedPoles& gradient);

}  // namespace osculate
