// No generated SWIG module: the runtime's own header (`swig -python -external-runtime`) is enough
// to register one type, in this module instead of a second one.
#include "osculate/python/shape_proxy.h"

#include <memory>

#include <swigpyrun.h>

namespace osculate::python {

namespace {

constexpr const char* kTypeName = "TopoDS_Shape *";

// The tables that SWIG would generate for a module with one type. The runtime links them into its
// list of modules, which lives as long as the process. The members of a cast differ between
// versions of the runtime; all zero but the type is the cast of a type to itself in each.
swig_type_info shapeType{"_p_TopoDS_Shape", kTypeName, nullptr, nullptr, nullptr, 0};
swig_cast_info shapeCast{};
swig_type_info* types[] = {&shapeType, nullptr};
swig_cast_info* casts[] = {&shapeCast, nullptr};
swig_module_info moduleInfo{types, 1, &moduleInfo, types, casts, nullptr};

}  // namespace

void registerShapeType() {
  swig_module_info* const known = SWIG_GetModule(nullptr);
  if (known != nullptr && SWIG_TypeQueryModule(known, known, kTypeName) != nullptr) return;
  shapeCast.type = &shapeType;
  shapeType.cast = &shapeCast;
  if (known == nullptr) {
    SWIG_SetModule(nullptr, &moduleInfo);
  } else {
    moduleInfo.next = known->next;
    known->next = &moduleInfo;
  }
}

TopoDS_Shape takeShape(const py::object& proxy) {
  static swig_type_info* const type = SWIG_TypeQuery(kTypeName);
  void* pointer = nullptr;
  int owned = 0;
  // DISOWN: the proxy would have no destructor to call, the shape is deleted here
  const int result =
      SWIG_ConvertPtrAndOwn(proxy.ptr(), &pointer, type, SWIG_POINTER_DISOWN, &owned);
  if (!SWIG_IsOK(result) || owned == 0) {
    throw py::type_error("proxy: must be what Part.__toPythonOCC__ returns, used once");
  }
  const std::unique_ptr<TopoDS_Shape> shape(static_cast<TopoDS_Shape*>(pointer));
  return *shape;
}

}  // namespace osculate::python
