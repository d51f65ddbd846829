// OpenCASCADE's exceptions leave as C++ exceptions with their message.
#include "osculate/occt/occt_error.h"

#include <functional>

#include <gtest/gtest.h>
#include <Geom_BezierCurve.hxx>
#include <Standard_ConstructionError.hxx>

namespace osculate::test {
namespace {

std::string messageOf(const std::function<void()>& statement) {
  try {
    translateFailures(statement);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(OcctError, CarriesNameAndMessage) {
  EXPECT_EQ(messageOf([] { throw Standard_ConstructionError("bad poles"); }),
            "OpenCASCADE: Standard_ConstructionError: bad poles");
  EXPECT_EQ(messageOf([] { throw Standard_ConstructionError(); }),
            "OpenCASCADE: Standard_ConstructionError");
}

TEST(OcctError, ComesFromInsideOpenCascadeToo) {
  const TColgp_Array1OfPnt onePole(1, 1);
  EXPECT_EQ(messageOf([&] { Geom_BezierCurve curve(onePole); }),
            "OpenCASCADE: Standard_ConstructionError");
}

TEST(OcctError, ResultsAndOtherExceptionsPass) {
  EXPECT_EQ(translateFailures([] { return 7; }), 7);
  EXPECT_THROW(translateFailures([] { throw std::invalid_argument("x"); }), std::invalid_argument);
}

}  // namespace
}  // namespace osculate::test
