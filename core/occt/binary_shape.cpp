#include "osculate/occt/binary_shape.h"

#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>

#include "osculate/occt/occt_error.h"

namespace osculate {

TopoDS_Shape readBinaryShape(std::istream& stream) {
  return translateFailures([&]() -> TopoDS_Shape {
    BinTools_ShapeSet shapes;
    shapes.Read(stream);
    Standard_Integer shape = 0;
    Standard_Integer location = 0;
    Standard_Integer orientation = 0;
    BinTools::GetInteger(stream, shape);
    BinTools::GetInteger(stream, location);
    BinTools::GetInteger(stream, orientation);
    if (!stream) throw OcctError("the stream holds no complete binary shape");
    if (shape <= 0) return {};
    TopoDS_Shape result = shapes.Shape(shape);
    result.Location(shapes.Locations().Location(location));
    result.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return result;
  });
}

void writeBinaryShape(std::ostream& stream, const TopoDS_Shape& shape) {
  translateFailures([&] {
    BinTools_ShapeSet shapes;
    const bool isNull = shape.IsNull();
    const Standard_Integer number = isNull ? -1 : shapes.Add(shape);
    const Standard_Integer location = isNull ? -1 : shapes.Locations().Index(shape.Location());
    const Standard_Integer orientation =
        isNull ? -1 : static_cast<Standard_Integer>(shape.Orientation());
    shapes.Write(stream);
    BinTools::PutInteger(stream, number);
    BinTools::PutInteger(stream, location);
    BinTools::PutInteger(stream, orientation);
  });
}

}  // namespace osculate
