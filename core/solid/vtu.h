// Bézier solids as VTK's unstructured grids, for ParaView.
#pragma once

#include <ostream>
#include <span>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// The place in VTK's order of the points of a Bézier tetrahedron (vtkHigherOrderTetra): corners,
/// edges, faces, then the same of the net inside. vtk[i] is the position in our net of VTK's point
/// i.
std::vector<int> vtkOrder(int degree);

/// A .vtu document (XML with decimal numbers that read back as the same doubles) of cells
/// VTK_BEZIER_TETRAHEDRON with their RationalWeights and HigherOrderDegrees, which VTK 9 evaluates
/// exactly. Throws std::invalid_argument for no solids, in E4, and where a weight is 0, which VTK
/// divides by; raise the degree first.
void writeVtu(std::ostream& stream, std::span<const BezierTetrahedron> solids);

}  // namespace osculate
