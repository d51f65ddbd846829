// Knots inserted into a net one at a time (Boehm 1980): the inverse that removals are tested with.
#pragma once

#include "osculate/bezier/spline_net.h"

namespace osculate::test {

/// The same curve with the knot u once more; u inside the range, where its multiplicity is below
/// the degree. Clamped and periodic nets.
inline SplineNet inserted(const SplineNet& net, double u) {
  const int p = net.degree;
  int span = 0;  // knot(span) <= u < knot(span + 1)
  while (net.knot(span + 1) <= u)
    ++span;
  const auto insertedPole = [&](int i) -> Eigen::Vector4d {
    if (i <= span - p) return net.pole(i);
    if (i > span) return net.pole(i - 1);
    const double alpha = (u - net.knot(i)) / (net.knot(i + p) - net.knot(i));
    return (1.0 - alpha) * net.pole(i - 1) + alpha * net.pole(i);
  };
  SplineNet result = net;
  result.flat.clear();
  result.poles.clear();
  const auto add = [&](int i) { result.poles.push_back(insertedPole(i)); };
  if (!net.isPeriodic()) {
    result.flat = net.flat;
    result.flat.insert(result.flat.begin() + span + 1, u);
    for (int i = 0; i <= net.poleCount(); ++i)
      add(i);
    return result;
  }
  // one period from the first pole that changes
  const int begin = span - p + 1;
  SplineNet turned = result;
  for (int i = begin; i <= begin + net.poleCount(); ++i) {
    turned.flat.push_back(i <= span ? net.knot(i) : i == span + 1 ? u : net.knot(i - 1));
    turned.poles.push_back(insertedPole(i));
  }
  int first = 0;
  while (turned.knot(first - 1) >= net.flat.front())
    --first;
  while (turned.knot(first) < net.flat.front())
    ++first;
  for (int i = first; i < first + turned.poleCount(); ++i) {
    result.flat.push_back(turned.knot(i));
    result.poles.push_back(turned.pole(i));
  }
  return result;
}

inline SplineNet inserted(SplineNet net, double u, int times) {
  for (int i = 0; i < times; ++i)
    net = inserted(net, u);
  return net;
}

}  // namespace osculate::test
