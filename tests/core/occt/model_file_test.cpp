#include "osculate/occt/model_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include <unistd.h>

#include <BinTools.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>

#include "occt/audit_shapes.h"
#include "osculate/occt/occt_error.h"
#include "support/errors.h"
#include "support/leaks.h"

namespace osculate::test {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = fs::path(OSCULATE_TEST_DATA_DIR) / "models";

/// A folder that vanishes with the test.
class ModelFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  static std::string content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static Model read(const std::string& file) {
    const IgnoredLeaks readers;  // their tables of parameters, once in a process
    return readModel(file);
  }

 private:
  fs::path folder_ =
      fs::temp_directory_path() / ("osculate-" + std::to_string(::getpid()) + "-" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ModelFile, ReadsTheThreeFormats) {
  const std::pair<const char*, ModelFormat> samples[] = {{"wire.step", ModelFormat::kStep},
                                                         {"wire.igs", ModelFormat::kIges},
                                                         {"wire.brep", ModelFormat::kBrep}};
  for (const auto& [name, format] : samples) {
    const Model model = read((kModels / name).string());
    EXPECT_EQ(model.format, format);
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(edgesOf(model.shape).size(), 4U);
    // as another program would have told it by its name alone
    fs::copy_file(kModels / name, path("other.txt"), fs::copy_options::overwrite_existing);
    EXPECT_EQ(read(path("other.txt")).format, format);
  }
}

TEST_F(ModelFile, ReadsWhatItWrote) {
  const IgnoredLeaks ofTheWriter;
  const TopoDS_Shape chain = chainOf(3);
  for (const char* name : {"a.step", "a.STP", "a.igs", "a.iges", "a.brep", "a.Brp"}) {
    writeModel(chain, path(name));
    const Model model = read(path(name));
    EXPECT_EQ(model.format, formatByName(name));
    const std::vector<TopoDS_Edge> edges = edgesOf(model.shape);
    ASSERT_EQ(edges.size(), 3U) << name;
    for (std::size_t i = 0; i < 3; ++i) {
      const BSplineData own = curveFromEdge(edgesOf(chain)[i]).curve.data();
      const BSplineData back = curveFromEdge(edges[i]).curve.data();
      EXPECT_TRUE(back.poles.isApprox(own.poles, 1e-12)) << name;
    }
  }
}

TEST_F(ModelFile, ReadsBinaryBrep) {
  const TopoDS_Shape chain = chainOf(2);
  BinTools::Write(chain, path("b.brep").c_str());
  const Model model = read(path("b.brep"));
  EXPECT_EQ(model.format, ModelFormat::kBrep);
  EXPECT_EQ(edgesOf(model.shape).size(), 2U);
}

TEST_F(ModelFile, SaysWhatIsWrong) {
  EXPECT_ERROR(readModel(path("none.step")), "none.step cannot be read: No such file or directory");
  EXPECT_ERROR(readModel(path("")), "is a folder; give a STEP, IGES or BREP file");
  EXPECT_ERROR(readModel(write("a.step", "")), "a.step is empty");
  EXPECT_ERROR(readModel(write("a.step", "solid cube")), "a.step is no STEP, IGES or BREP file");
  const std::string step = content(kModels / "wire.step");
  EXPECT_ERROR(readModel(write("a.step", step.substr(0, step.size() / 2))),
               "is cut off: a STEP file ends with END-ISO-10303-21");
  const std::string iges = content(kModels / "wire.igs");
  EXPECT_ERROR(readModel(write("a.igs", iges.substr(0, iges.size() / 2))),
               "is cut off: an IGES file ends with a line of its section T");
}

TEST_F(ModelFile, ReportsCutBrepFiles) {
  const std::string brep = content(kModels / "smooth.brep");
  for (const double share : {0.1, 0.4, 0.7, 0.9}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(brep.size()));
    EXPECT_ANY_THROW(read(write("a.brep", brep.substr(0, length)))) << share;
  }
}

TEST_F(ModelFile, NotesWhatWasNotRead) {
  std::string step = content(kModels / "smooth.step");
  const std::size_t at = step.find("CIRCLE(");
  ASSERT_NE(at, std::string::npos);
  step.replace(at, 7, "CIRCLX(");
  const Model model = read(write("a.step", step));
  EXPECT_FALSE(model.notes.empty());
  EXPECT_EQ(edgesOf(model.shape).size(), 2U);
}

TEST_F(ModelFile, LeavesTheMessengerAsItWas) {
  const int before = Message::DefaultMessenger()->Printers().Length();
  EXPECT_GT(before, 0);
  testing::internal::CaptureStdout();
  read((kModels / "wire.igs").string());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_ANY_THROW(readModel(path("none")));
  EXPECT_EQ(Message::DefaultMessenger()->Printers().Length(), before);
}

TEST_F(ModelFile, FormatsByName) {
  EXPECT_EQ(formatByName("a/b.STEP"), ModelFormat::kStep);
  for (const char* name : {"a.stl", "a", "step", "a.step/b"})
    EXPECT_ERROR(formatByName(name), "output: must end with .step");
  EXPECT_EQ(name(ModelFormat::kIges), "IGES");
}

TEST_F(ModelFile, CannotWriteEverywhere) {
  const IgnoredLeaks ofTheWriter;
  for (const char* name : {"none/a.step", "none/a.igs", "none/a.brep"})
    EXPECT_THROW(writeModel(chainOf(1), path(name)), OcctError) << name;
}

}  // namespace
}  // namespace osculate::test
