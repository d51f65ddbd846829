// The Bernstein polynomials at the nodes of a fixed quadrature; private to this floor.
#pragma once

#include <Eigen/Core>
#include <array>

namespace osculate {

constexpr int kCoarseNodes = 40;  ///< 2 panels of 20 Gauss-Legendre nodes over [0, 1]
constexpr int kFineNodes = 160;   ///< 8 panels

/// A number at each node.
template <int Nodes>
using AtNodes = Eigen::Array<double, Nodes, 1>;

/// Derivatives 1..3 of the Bernstein polynomials of a degree at the nodes.
template <int Nodes>
struct NodeTable {
  std::array<Eigen::Matrix<double, Nodes, Eigen::Dynamic>, 3> basis;  ///< (nodes) x (degree+1)
  AtNodes<Nodes> weights;
};

/// Made at the first use of a degree, 0 .. kMaxDegree, and shared by all threads. For kCoarseNodes
/// and kFineNodes.
template <int Nodes>
const NodeTable<Nodes>& nodeTable(int degree);

}  // namespace osculate
