#include "osculate/occt/occt_error.h"

#include <Standard_Type.hxx>

namespace osculate {

std::string describe(const Standard_Failure& failure) {
  const std::string name = failure.DynamicType()->Name();
  const Standard_CString message = failure.GetMessageString();
  const bool silent = message == nullptr || *message == '\0';
  return "OpenCASCADE: " + (silent ? name : name + ": " + message);
}

}  // namespace osculate
