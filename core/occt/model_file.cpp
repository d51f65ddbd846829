#include "osculate/occt/model_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <XSControl_WorkSession.hxx>

#include "osculate/occt/occt_error.h"

namespace osculate {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& problem) {
  throw std::invalid_argument("file: " + path + " " + problem);
}

/// OpenCASCADE's messages go nowhere as long as this lives.
class Silence {
 public:
  Silence() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~Silence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

/// The first and the last bytes of a file: enough to know what it is and whether it is whole.
struct Excerpt {
  std::string head;
  std::string tail;
};

Excerpt excerptOf(const std::string& path) {
  constexpr std::streamoff kLength = 1 << 16;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail(path, "is a folder; give a STEP, IGES or BREP file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  const auto take = [&](std::streamoff from) {
    std::string text(kLength, '\0');
    stream.clear();
    stream.seekg(from);
    stream.read(text.data(), kLength);
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
  };
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  if (size <= 0) fail(path, "is empty");
  return {take(0), take(std::max<std::streamoff>(size - kLength, 0))};
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The letter of an IGES line's section, in column 73 (IGES 5.3, sec. 2.2.4).
char sectionOf(std::string_view line) { return line.size() >= 73 ? line[72] : '\0'; }

std::string_view lastLine(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t\x1a\0");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  const std::size_t begin = text.find_last_of("\r\n");
  return begin == std::string_view::npos ? text : text.substr(begin + 1);
}

bool isIges(std::string_view head) {
  const char section = sectionOf(head.substr(0, head.find_first_of("\r\n")));
  return section == 'S' || section == 'B' || section == 'C';
}

bool isBinaryBrep(std::string_view head) {
  return contains(head.substr(0, 1024), "Open CASCADE Topology");
}

/// The last line of a BREP text names the shape that it holds: orientation, number, location, as
/// "+1 0". OpenCASCADE can read a cut text for ever.
bool endsAsBrep(std::string_view line) {
  constexpr std::string_view kOrientations = "+-ie*";
  if (line.empty() || kOrientations.find(line.front()) == std::string_view::npos) return false;
  return line.find_first_not_of("0123456789 ", 1) == std::string_view::npos;
}

ModelFormat formatOf(const std::string& path, const Excerpt& excerpt) {
  const std::string_view head = excerpt.head;
  if (contains(head.substr(0, 256), "ISO-10303-21")) {
    if (!contains(excerpt.tail, "END-ISO-10303-21"))
      fail(path, "is cut off: a STEP file ends with END-ISO-10303-21");
    return ModelFormat::kStep;
  }
  if (contains(head.substr(0, 1024), "CASCADE Topology")) {
    if (!isBinaryBrep(head) && !endsAsBrep(lastLine(excerpt.tail)))
      fail(path, "is cut off: a BREP file ends with the number of its shape");
    return ModelFormat::kBrep;
  }
  if (!isIges(head)) fail(path, "is no STEP, IGES or BREP file");
  if (sectionOf(lastLine(excerpt.tail)) != 'T')
    fail(path, "is cut off: an IGES file ends with a line of its section T");
  return ModelFormat::kIges;
}

/// Entities whose content the reader could not make sense of.
void noteDamage(const Handle(Interface_InterfaceModel) & model, std::vector<std::string>& notes) {
  int damaged = 0;
  for (int i = 1; i <= model->NbEntities(); ++i)
    damaged += model->IsErrorEntity(i) || model->IsRedefinedContent(i) ? 1 : 0;
  if (damaged > 0)
    notes.push_back(std::to_string(damaged) +
                    (damaged == 1 ? " entity of the file is damaged and was not read"
                                  : " entities of the file are damaged and were not read"));
}

void transferRoots(XSControl_Reader& reader, std::vector<std::string>& notes) {
  const int roots = reader.NbRootsForTransfer();
  const int transferred = reader.TransferRoots();
  if (transferred > 0 && transferred < roots) {
    notes.push_back(std::to_string(roots - transferred) + " of " + std::to_string(roots) +
                    " parts of the file gave no shape");
  }
}

void load(XSControl_Reader& reader, const std::string& path, Model& model) {
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    fail(path, "cannot be read: OpenCASCADE finds its content damaged");
  noteDamage(reader.WS()->Model(), model.notes);
}

void readStep(const std::string& path, Model& model) {
  STEPControl_Reader reader;
  load(reader, path, model);
  transferRoots(reader, model.notes);
  model.shape = reader.OneShape();
}

void readIges(const std::string& path, Model& model) {
  IGESControl_Reader reader;
  reader.SetReadVisible(Standard_True);  // as FreeCAD does: blanked entities are construction
  load(reader, path, model);
  transferRoots(reader, model.notes);
  if (reader.NbShapes() == 0) {
    reader.SetReadVisible(Standard_False);
    transferRoots(reader, model.notes);
    if (reader.NbShapes() > 0) model.notes.emplace_back("all of its entities are blanked");
  }
  model.shape = reader.OneShape();
}

void readBrep(const std::string& path, const Excerpt& excerpt, Model& model) {
  const bool done = isBinaryBrep(excerpt.head)
                        ? BinTools::Read(model.shape, path.c_str())
                        : BRepTools::Read(model.shape, path.c_str(), BRep_Builder());
  if (!done || model.shape.IsNull())
    fail(path, "cannot be read: OpenCASCADE finds its content damaged");
}

}  // namespace

std::string_view name(ModelFormat format) {
  static constexpr std::array<std::string_view, 3> kNames{"STEP", "IGES", "BREP"};
  return kNames[static_cast<std::size_t>(format)];
}

Model readModel(const std::string& path) {
  const Excerpt excerpt = excerptOf(path);
  Model model;
  model.format = formatOf(path, excerpt);
  translateFailures([&] {
    const Silence silence;
    switch (model.format) {
      case ModelFormat::kStep:
        return readStep(path, model);
      case ModelFormat::kIges:
        return readIges(path, model);
      case ModelFormat::kBrep:
        return readBrep(path, excerpt, model);
    }
  });
  if (model.shape.IsNull()) fail(path, "holds no shape");
  return model;
}

ModelFormat formatByName(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".step" || ending == ".stp") return ModelFormat::kStep;
  if (ending == ".iges" || ending == ".igs") return ModelFormat::kIges;
  if (ending == ".brep" || ending == ".brp") return ModelFormat::kBrep;
  throw std::invalid_argument(
      "output: must end with .step, .stp, .iges, .igs, .brep or .brp, got " + path);
}

void writeModel(const TopoDS_Shape& shape, const std::string& path) {
  const auto write = [&]() -> bool {
    const Silence silence;
    switch (formatByName(path)) {
      case ModelFormat::kStep: {
        STEPControl_Writer writer;
        return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
               writer.Write(path.c_str()) == IFSelect_RetDone;
      }
      case ModelFormat::kIges: {
        IGESControl_Writer writer("MM", 0);
        if (!writer.AddShape(shape)) return false;
        writer.ComputeModel();
        return writer.Write(path.c_str());
      }
      default:
        return BRepTools::Write(shape, path.c_str());
    }
  };
  if (!translateFailures(write)) throw OcctError("OpenCASCADE cannot write " + path);
}

}  // namespace osculate
