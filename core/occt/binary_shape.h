// Shapes from OpenCASCADE's binary form with a head, as FreeCAD's Part.Shape.exportBinary writes
// it.
#pragma once

#include <istream>
#include <ostream>

#include <TopoDS_Shape.hxx>

namespace osculate {

/// Reads a BinTools_ShapeSet and the three integers that pick its shape: number of the shape,
/// number of its location, orientation. (BinTools::Write ends in another form.) A null shape where
/// the head says so. Throws OcctError for what is no such stream.
TopoDS_Shape readBinaryShape(std::istream& stream);

/// Writes that form, for FreeCAD's Part.Shape.importBinary.
void writeBinaryShape(std::ostream& stream, const TopoDS_Shape& shape);

}  // namespace osculate
