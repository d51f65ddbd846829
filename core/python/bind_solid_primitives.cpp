// The primitives that osculate.solids offers.
#include <pybind11/stl.h>

#include "osculate/python/solid_arguments.h"
#include "osculate/solid/primitives.h"

namespace osculate::python {

namespace {

Vector3 pointFrom(const py::object& value, const char* argument) {
  return vectorFrom(value, argument, 3);
}

BezierTetrahedron tetrahedron(const py::object& a, const py::object& b, const py::object& c,
                              const py::object& d) {
  return linearTetrahedron(pointFrom(a, "a"), pointFrom(b, "b"), pointFrom(c, "c"),
                           pointFrom(d, "d"));
}

std::vector<BezierTetrahedron> wedge(const py::object& centre, const py::object& a,
                                     const py::object& b, const py::object& c) {
  return sphereWedge(pointFrom(centre, "centre"), pointFrom(a, "a"), pointFrom(b, "b"),
                     pointFrom(c, "c"));
}

BezierTetrahedron wedgeByCircles(const py::object& centre, const py::object& a, const py::object& b,
                                 const py::object& c) {
  return sphereWedgeByCircles(pointFrom(centre, "centre"), pointFrom(a, "a"), pointFrom(b, "b"),
                              pointFrom(c, "c"));
}

BezierTetrahedron random(const py::object& degree, const py::object& seed,
                         const py::object& dimension) {
  const int number = integerFrom(seed, "seed");
  if (number < 0) throw std::invalid_argument("seed: must be >= 0, got " + std::to_string(number));
  return randomTetrahedron(integerFrom(degree, "degree"), static_cast<std::uint64_t>(number),
                           integerFrom(dimension, "dimension"));
}

}  // namespace

void bindSolidPrimitives(py::module_& m) {
  m.def("solid_tetrahedron", &tetrahedron);
  m.def("solid_cone", [](const py::object& radius, const py::object& height) {
    return cone(numberFrom(radius, "radius"), numberFrom(height, "height"));
  });
  m.def("solid_elliptic_cone",
        [](const py::object& radiusX, const py::object& radiusY, const py::object& apex) {
          return ellipticCone(numberFrom(radiusX, "radius_x"), numberFrom(radiusY, "radius_y"),
                              pointFrom(apex, "apex"));
        });
  m.def("solid_ball_octant",
        [](const py::object& radius) { return ballOctant(numberFrom(radius, "radius")); });
  m.def("solid_sphere_wedge", &wedge);
  m.def("solid_sphere_wedge_by_circles", &wedgeByCircles);
  m.def("solid_frustum_wedge", [](const py::object& lower, const py::object& upper,
                                  const py::object& height, const py::object& angle) {
    return frustumWedge(numberFrom(lower, "lower_radius"), numberFrom(upper, "upper_radius"),
                        numberFrom(height, "height"), numberFrom(angle, "angle"));
  });
  m.def("solid_random", &random);
}

}  // namespace osculate::python
