// OpenCASCADE's exceptions as C++ exceptions: Standard_Failure is no std::exception.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <Standard_Failure.hxx>

namespace osculate {

/// What OpenCASCADE threw or refused to do.
class OcctError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The name of OpenCASCADE's exception and its message.
std::string describe(const Standard_Failure& failure);

/// Returns what `function` returns; a Standard_Failure from inside leaves as OcctError.
template <typename Function>
decltype(auto) translateFailures(Function&& function) {
  try {
    return std::forward<Function>(function)();
  } catch (const Standard_Failure& failure) {
    throw OcctError(describe(failure));
  }
}

}  // namespace osculate
