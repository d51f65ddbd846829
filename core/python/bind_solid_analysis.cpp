// What Bézier solids know of each other and of themselves: contact, validity, volume, inversion.
#include <cmath>
#include <sstream>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "osculate/python/solid_arguments.h"
#include "osculate/solid/inversion.h"
#include "osculate/solid/jacobian.h"
#include "osculate/solid/measure.h"
#include "osculate/solid/neighbour.h"
#include "osculate/solid/solid_contact.h"

namespace osculate::python {

namespace {

constexpr const char* kContactDoc =
    R"(contact(self, other, *, tolerance_mm=1e-7, order=None, apex=None)
--

Which faces of the two solids meet, and the highest C^s over them, as a ContactReport.

All pairs of faces are compared under all ways to lay one on the other. The domains have C^s contact
where the derivatives 0 .. s agree across the face, with the other's free corner at `apex` (barycentric
coordinates of this solid's domain; None finds the best). order: the highest order looked at, None for
the degree. tolerance_mm is for the displacement of the control points of layer 0; layer r allows
(sum |apex|)^r times as much.)";

constexpr const char* kJoinDoc =
    R"(join(self, apex, order, *, face=None, apex_point=None, keep_labels=False)
--

The neighbour over a face with C^order contact: its layers 0 .. order at the face are forced, the rest
are free and filled smoothly.

apex: the new corner in barycentric coordinates of this solid's domain, (4,), sum 1, negative at the
corner it takes the place of. face: the number of that corner; None takes the only negative one. order:
0 to the degree. apex_point: where the control point of the new corner goes, in mm, where it is free.
The new corner has the number of the one it replaces. The others keep theirs with keep_labels=True,
which makes a mirror image of the domain; by default two of them are exchanged, so that the neighbour
of a valid solid is valid. Raises ContactError where the contact forces a negative weight.)";

constexpr const char* kBoundsDoc = R"(jacobian_bounds(self, tolerance=1e-3)
--

(low, high, certificate): bounds that contain the Jacobian determinant everywhere, each within
tolerance * max |J| of a value that occurs, and what `validity` says, as text: "valid", "singular at
..", "inverted at ..", or "undecided near .." where the work allowed does not suffice.)";

constexpr const char* kValidityDoc = R"(validity(self)
--

Whether the solid folds over itself, as a ValidityReport: decided by the Bernstein coefficients of the
Jacobian and bisection of the domain, never by samples.)";

constexpr const char* kVolumeDoc = R"(volume(self)
--

The integral of the Jacobian in mm^3, to 12 digits: negative for a mirror image; where the solid folds,
parts that are covered inside out count negative.)";

constexpr const char* kLocateDoc = R"(locate(self, point, tolerance_mm=1e-9)
--

The barycentric coordinates at which the solid has this point, (m, 4): no row for a point outside, one
for a point inside a valid solid, more where it folds.)";

std::string repr(const SolidContact& self) {
  std::ostringstream text;
  text << "<osculate.ContactReport: ";
  if (!self.meets) {
    text << "no faces meet, the nearest are " << self.gapMm << " mm apart>";
    return text.str();
  }
  text << "face " << self.faces.first << " meets face " << self.faces.second << ", C"
       << self.cartesian.order << " (homogeneous C" << self.homogeneous.order << ")"
       << (self.overlaps ? ", on the same side" : "") << ">";
  return text.str();
}

py::object apexOf(const SolidContact& self, const ContactOrders& orders) {
  if (!self.meets) return py::none();
  return py::cast(Eigen::VectorXd(orders.apex));
}

void bindFaces(py::class_<SolidContact>& type) {
  using Report = SolidContact;
  type.def_readonly("meets", &Report::meets,
                    "True if two faces are the same to within the tolerance.")
      .def_readonly("gap_mm", &Report::gapMm,
                    "The largest distance of corresponding points of the two faces.")
      .def_property_readonly(
          "faces",
          [](const Report& self) { return py::make_tuple(self.faces.first, self.faces.second); },
          "The face of the first and of the second solid (numbers of the opposite corners) that "
          "meet, or come nearest.")
      .def_property_readonly(
          "corners", [](const Report& self) { return py::tuple(py::cast(self.faces.corners)); },
          "For each corner of the first solid the corner of the second in its place.")
      .def_readonly("overlaps", &Report::overlaps,
                    "True if both solids lie on the same side of the face.");
}

void bindOrders(py::class_<SolidContact>& type) {
  using Report = SolidContact;
  type.def_property_readonly(
          "order", [](const Report& self) { return self.cartesian.order; },
          "The highest s with C^s contact of the maps into space; -1 if no faces meet.")
      .def_property_readonly(
          "homogeneous_order", [](const Report& self) { return self.homogeneous.order; },
          "The same for the homogeneous maps up to a constant factor: sufficient, not necessary.")
      .def_property_readonly(
          "residuals_mm",
          [](const Report& self) { return py::tuple(py::cast(self.cartesian.residualsMm)); },
          "For each order the largest difference, as a displacement of control points.")
      .def_property_readonly(
          "homogeneous_residuals_mm",
          [](const Report& self) { return py::tuple(py::cast(self.homogeneous.residualsMm)); },
          "The same for the homogeneous maps.")
      .def_property_readonly(
          "apex", [](const Report& self) { return apexOf(self, self.cartesian); },
          "The second solid's free corner in barycentric coordinates of the first, or None.")
      .def_readonly("degree", &Report::degree, "The degree at which they were compared.");
}

void bindContact(py::module_& m) {
  py::class_<SolidContact> report(m, "ContactReport",
                                  "The contact of two Bézier solids over a face.");
  bindFaces(report);
  bindOrders(report);
  report.def("__repr__", &repr);
}

SolidContact contactOf(const BezierTetrahedron& self, const BezierTetrahedron& other,
                       const py::object& toleranceMm, const py::object& order,
                       const py::object& apex) {
  SolidContactOptions options;
  options.toleranceMm = numberFrom(toleranceMm, "tolerance_mm");
  if (!order.is_none()) options.maxOrder = integerFrom(order, "order");
  if (!apex.is_none()) options.apex = coordinateFrom<4>(apex, "apex");
  const py::gil_scoped_release release;
  return contact(self, other, options);
}

int faceOf(const Barycentric<4>& apex, const py::object& face) {
  if (!face.is_none()) return integerFrom(face, "face");
  if ((apex.array() < 0.0).count() != 1) {
    throw std::invalid_argument(
        "apex: the face is that of the only negative coordinate, and there is not just one; give "
        "face");
  }
  Eigen::Index corner = 0;
  apex.minCoeff(&corner);
  return static_cast<int>(corner);
}

BezierTetrahedron join(const BezierTetrahedron& self, const py::object& apex,
                       const py::object& order, const py::object& face, const py::object& apexPoint,
                       const py::object& keepLabels) {
  const Barycentric<4> at = coordinateFrom<4>(apex, "apex");
  const int corner = faceOf(at, face);
  NeighbourOptions options;
  if (!apexPoint.is_none())
    options.apexPoint = vectorFrom(apexPoint, "apex_point", self.dimension());
  BezierTetrahedron next = neighbour(self, corner, at, integerFrom(order, "order"), options);
  if (boolFrom(keepLabels, "keep_labels")) return next;
  MultiIndex<4> exchanged{0, 1, 2, 3};
  std::swap(exchanged[static_cast<std::size_t>((corner + 1) % 4)],
            exchanged[static_cast<std::size_t>((corner + 2) % 4)]);
  return next.relabelled(exchanged);
}

py::list placesOf(const ValidityCertificate& self) {
  py::list result;
  for (const SingularPlace& place : self.places) {
    py::list corners;
    for (const Barycentric<4>& corner : place.corners)
      corners.append(Eigen::VectorXd(corner));
    result.append(py::make_tuple(py::tuple(py::cast(place.between)), corners));
  }
  return result;
}

void bindValidity(py::module_& m) {
  using Report = ValidityCertificate;
  py::class_<Report>(m, "ValidityReport",
                     "Whether a Bézier solid folds over itself; str() says it in words.")
      .def_property_readonly(
          "verdict", [](const Report& self) { return std::string(name(self.validity)); },
          "'valid': the Jacobian is > 0 everywhere. 'singular': it is >= 0 and vanishes at "
          "`places`. 'inverted': it is < 0 at `witness`. 'undecided': the work allowed did not "
          "suffice; it is small near `witness`.")
      .def_property_readonly(
          "witness",
          [](const Report& self) {
            return self.witness ? py::cast(Eigen::VectorXd(*self.witness)) : py::object(py::none());
          },
          "Barycentric coordinates (4,) or None.")
      .def_property_readonly(
          "places", &placesOf,
          "A list of (corners of the solid between which the place lies, corners of the place in "
          "barycentric coordinates): one corner for a point, two for a segment, three for a "
          "triangle.")
      .def_readonly(
          "is_mirrored", &Report::mirrored,
          "True if the Jacobian is <= 0 everywhere: exchanging two corners makes the solid right.")
      .def_readonly("parts", &Report::parts, "How many parts of the domain were looked at.")
      .def("__str__", &describe)
      .def("__repr__",
           [](const Report& self) { return "<osculate.ValidityReport: " + describe(self) + ">"; });
}

ValidityCertificate certified(const BezierTetrahedron& self) {
  const py::gil_scoped_release release;
  return certify(self);
}

py::tuple bounds(const BezierTetrahedron& self, const py::object& tolerance) {
  const double allowed = numberFrom(tolerance, "tolerance");
  JacobianBounds found;
  ValidityCertificate certificate;
  {
    const py::gil_scoped_release release;
    found = jacobianBounds(self, allowed);
    certificate = certify(self);
  }
  return py::make_tuple(found.low, found.high, describe(certificate));
}

py::array located(const BezierTetrahedron& self, const py::object& point,
                  const py::object& toleranceMm) {
  const Vector3 at = vectorFrom(point, "point", 3);
  const auto found = locate(self, at, {.toleranceMm = numberFrom(toleranceMm, "tolerance_mm")});
  std::vector<double> numbers;
  for (const Barycentric<4>& u : found)
    numbers.insert(numbers.end(), u.data(), u.data() + 4);
  return rowsOf(numbers, 4);
}

}  // namespace

void bindSolidAnalysis(py::module_& m) {
  bindContact(m);
  bindValidity(m);
  static_cast<py::class_<BezierTetrahedron>>(m.attr("BezierTetrahedron"))
      .def("contact", &contactOf, py::arg("other"), py::kw_only(), py::arg("tolerance_mm") = 1e-7,
           py::arg("order") = py::none(), py::arg("apex") = py::none(), kContactDoc)
      .def("join", &join, py::arg("apex"), py::arg("order"), py::kw_only(),
           py::arg("face") = py::none(), py::arg("apex_point") = py::none(),
           py::arg("keep_labels") = false, kJoinDoc)
      .def("validity", &certified, kValidityDoc)
      .def("jacobian_bounds", &bounds, py::arg("tolerance") = 1e-3, kBoundsDoc)
      .def(
          "volume", [](const BezierTetrahedron& self) { return measure(self).volume; }, kVolumeDoc)
      .def(
          "centroid", [](const BezierTetrahedron& self) { return measure(self).centroid; },
          "centroid(self)\n--\n\nThe centre of mass, (3,), in mm; NaN where the volume is 0.")
      .def(
          "volume_and_error",
          [](const BezierTetrahedron& self) {
            const SolidMeasure found = measure(self);
            return py::make_tuple(found.volume, found.volumeError);
          },
          "volume_and_error(self)\n--\n\n(volume, bound of its error) in mm^3.")
      .def("locate", &located, py::arg("point"), py::arg("tolerance_mm") = 1e-9, kLocateDoc);
}

}  // namespace osculate::python
