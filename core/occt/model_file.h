// Models from and to files: STEP, IGES and BREP.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <TopoDS_Shape.hxx>

namespace osculate {

enum class ModelFormat : unsigned char { kStep, kIges, kBrep };
std::string_view name(ModelFormat format);

/// A model as FreeCAD's Part.read gives it: one shape, in mm, IGES without blanked entities.
struct Model {
  TopoDS_Shape shape;  ///< never null
  ModelFormat format = ModelFormat::kStep;
  std::vector<std::string> notes;  ///< what of the file the shape lacks, a sentence each
};

/// The format is told from the content, not from the name. OpenCASCADE prints nothing meanwhile.
///
/// Throws std::invalid_argument, which begins with "file: ", for a path that is no readable file,
/// for a file of another format, a cut one, and one without a shape; OcctError for what OpenCASCADE
/// throws. There are damaged files at which OpenCASCADE breaks down or never ends: where that must
/// not end the process, call this in another one (as the program `osculate` does).
Model readModel(const std::string& path);

/// The format is that of the ending: .step, .stp, .iges, .igs, .brep, .brp, in any case. Throws
/// std::invalid_argument, which begins with "output: ", for another one; OcctError where
/// OpenCASCADE cannot write.
void writeModel(const TopoDS_Shape& shape, const std::string& path);
/// Throws as writeModel does.
ModelFormat formatByName(const std::string& path);

}  // namespace osculate
