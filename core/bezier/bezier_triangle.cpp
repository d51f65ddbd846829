#include "osculate/bezier/bezier_triangle.h"

#include "osculate/bezier/bernstein.h"
#include "osculate/bezier/simplex_edge.h"

namespace osculate {

BezierCurve edgeCurve(const BezierTriangle& triangle, int a, int b) {
  return curveFromEdgeNet(triangle.edgeNet(a, b), triangle.dimension(), triangle.isRational());
}

}  // namespace osculate
