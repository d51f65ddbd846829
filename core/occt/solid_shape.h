// Bézier solids as B-Rep solids.
#pragma once

#include <TopoDS_Solid.hxx>

#include "osculate/bezier/bezier_tetrahedron.h"

namespace osculate {

/// The closed, oriented TopoDS_Solid that the four faces bound, exactly:
///
/// - a face in a plane is a part of that plane within its edges;
/// - a face that joins a point with a curve by straight lines (the side of a cone) is a ruled
/// patch;
/// - every other face is a tensor-product patch with one edge collapsed to a corner (mathematics
///   C5), the degree raised where a weight would be 0 (C6).
///
/// Straight edges are of degree 1. The faces are sewn and checked with BRepCheck, which does not
/// look for faces that pass through each other: of a solid that folds over itself (see certify) the
/// result can be invalid unnoticed. Throws std::invalid_argument in E4, for a corner of weight 0
/// and for a solid without volume; OcctError where the faces do not close or BRepCheck objects.
TopoDS_Solid solidFromTetrahedron(const BezierTetrahedron& solid);

}  // namespace osculate
