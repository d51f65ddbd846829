// osculate.BezierTetrahedron and osculate.BezierTriangle: the values themselves.
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "osculate/bezier/simplex_evaluator.h"
#include "osculate/python/solid_arguments.h"
#include "osculate/solid/jacobian.h"
#include "osculate/solid/net_shape.h"
#include "osculate/solid/space4.h"

namespace osculate::python {

namespace {

constexpr const char* kTetrahedronDoc =
    R"(BezierTetrahedron(degree, points, weights=None)
--

A Bézier tetrahedron in E3 (a solid) or E4, polynomial or rational: an immutable value.

points: (N, 3) or (N, 4) finite coordinates in mm, N = (n+1)(n+2)(n+3)/6, for the indices (i, j, k, l)
with the sum n in lexicographic order from (n, 0, 0, 0) to (0, 0, 0, n). weights: (N,), finite, >= 0
and not all 0, or None for a polynomial one. degree: 1 to 12. Points of the solid are given by
barycentric coordinates (u, v, w, t) with the sum 1. Raises ValueError that names the argument and the
rule, TypeError for what is no array of numbers. Arrays it returns are copies.)";

constexpr const char* kTriangleDoc = R"(BezierTriangle(degree, points, weights=None)
--

A Bézier triangle in E3 or E4: an immutable value. As BezierTetrahedron, with (n+1)(n+2)/2 points for the
indices (i, j, k) from (n, 0, 0) to (0, 0, n) and barycentric coordinates (u, v, w).)";

constexpr const char* kEvaluateDoc = R"(evaluate(self, u)
--

The points at barycentric coordinates u: a row, or an array with such rows, each with the sum 1. The
result has the coordinates of points in their place. NaN where the weight vanishes.)";

constexpr const char* kDerivativeDoc = R"(derivative(self, u, directions)
--

The mixed derivative along the directions: (r, corners) barycentric, each with the sum 0, of which at
most 12 differ. u as in evaluate. In mm per unit of each direction.)";

constexpr const char* kPartialDoc = R"(partial(self, u, orders)
--

The partial derivative of the given orders, one for each coordinate, as a function of independent
coordinates (without the condition that they sum to 1). u as in evaluate.)";

constexpr const char* kSubdividedDoc = R"(subdivided(self, at=None)
--

The parts that the point `at` (barycentric, by default the middle) makes with the faces, as a list: the
corner c of part c is replaced by the point.)";

constexpr const char* kPartDoc = R"(part(self, corners)
--

The part with these corners, each barycentric with the sum 1, as a whole of its own.)";

constexpr const char* kTransformedDoc = R"(transformed(self, matrix)
--

The image under a map in homogeneous coordinates: a square matrix of size 4 in E3, 5 in E4. Where its
last row is not (0, .., 0, 1) the map is projective and the result rational; ValueError where points
go through infinity.)";

constexpr const char* kEdgeDoc = R"(edge(self, a, b)
--

The edge from corner a to corner b as a Curve over [0, 1]; in E3.)";

/// A copy of the rows, with the last dimension of the shape replaced.
Array resultLike(const Array& rows, py::ssize_t columns) {
  std::vector<py::ssize_t> shape(rows.shape(), rows.shape() + rows.ndim());
  shape.back() = columns;
  return Array(shape);
}

/// Calls f(u, out) for every row of u.
template <int Corners, class F>
Array forRows(const BezierSimplex<Corners>& self, const py::object& u, F f) {
  const Array rows = coordinatesFrom<Corners>(u, "u");
  Array result = resultLike(rows, self.dimension());
  const double* from = rows.data();
  double* to = result.mutable_data();
  const py::ssize_t count = rows.size() / Corners;
  const py::gil_scoped_release release;
  for (py::ssize_t i = 0; i < count; ++i, from += Corners, to += self.dimension()) {
    const SpacePoint value = f(Barycentric<Corners>(Eigen::Map<const Barycentric<Corners>>(from)));
    std::copy(value.data(), value.data() + value.size(), to);
  }
  return result;
}

template <int Corners>
Array evaluate(const BezierSimplex<Corners>& self, const py::object& u) {
  if constexpr (Corners == 4) {
    const Array rows = coordinatesFrom<4>(u, "u");
    const std::span<const double> all(rows.data(), static_cast<std::size_t>(rows.size()));
    const bool isInside = std::all_of(all.begin(), all.end(), [](double c) { return c >= 0.0; });
    if (isInside && rows.ndim() > 1) {
      Array result = resultLike(rows, self.dimension());
      const std::span<double> out(result.mutable_data(), static_cast<std::size_t>(result.size()));
      const py::gil_scoped_release release;
      TetrahedronEvaluator(self).points(all, out);
      return result;
    }
  }
  return forRows<Corners>(self, u, [&](const auto& at) { return self.evaluate(at); });
}

template <int Corners>
Array derivative(const BezierSimplex<Corners>& self, const py::object& u,
                 const py::object& directions) {
  const Array rows = rowsFrom(directions, "directions", Corners);
  if (rows.ndim() != 2) {
    throw std::invalid_argument("directions: must have the shape (r, " + std::to_string(Corners) +
                                ")");
  }
  std::vector<Barycentric<Corners>> list;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    list.emplace_back(Eigen::Map<const Barycentric<Corners>>(rows.data() + Corners * i));
  return forRows<Corners>(self, u, [&](const auto& at) { return self.derivative(at, list); });
}

template <int Corners>
Array partial(const BezierSimplex<Corners>& self, const py::object& u, const py::object& orders) {
  const std::vector<int> numbers = integersFrom(orders, "orders");
  MultiIndex<Corners> index{};
  if (numbers.size() != index.size()) {
    throw std::invalid_argument("orders: must be " + std::to_string(Corners) + " numbers, got " +
                                std::to_string(numbers.size()));
  }
  std::copy(numbers.begin(), numbers.end(), index.begin());
  return forRows<Corners>(self, u, [&](const auto& at) { return self.partial(at, index); });
}

template <int Corners>
BezierSimplex<Corners> make(const py::object& degree, const py::object& points,
                            const py::object& weights) {
  const Array array = arrayFrom(points, "points");
  if (array.ndim() != 2) {
    throw std::invalid_argument("points: must have the shape (N, 3) or (N, 4), got " +
                                std::string(py::str(array.attr("shape"))));
  }
  const Eigen::Map<const Eigen::MatrixXd> columns(array.data(), array.shape(1), array.shape(0));
  return BezierSimplex<Corners>(
      integerFrom(degree, "degree"), columns,
      weights.is_none() ? std::vector<double>{} : numbersFrom(weights, "weights"));
}

template <int Corners>
PartCornersOf<Corners> cornersFrom(const py::object& value) {
  const Array rows = coordinatesFrom<Corners>(value, "corners");
  if (rows.ndim() != 2 || rows.shape(0) != Corners) {
    throw std::invalid_argument("corners: must be " + std::to_string(Corners) + " rows");
  }
  PartCornersOf<Corners> corners;
  for (std::size_t c = 0; c < Corners; ++c)
    corners[c] = Eigen::Map<const Barycentric<Corners>>(rows.data() + Corners * c);
  return corners;
}

template <int Corners>
BezierSimplex<Corners> transformed(const BezierSimplex<Corners>& self, const py::object& matrix) {
  const int d = self.dimension();
  const Array rows = rowsFrom(matrix, "matrix", d + 1);
  if (rows.ndim() != 2 || rows.shape(0) != d + 1) {
    throw std::invalid_argument("matrix: must have the shape (" + std::to_string(d + 1) + ", " +
                                std::to_string(d + 1) + ")");
  }
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor map = Eigen::Map<const RowMajor>(rows.data(), d + 1, d + 1);
  Eigen::RowVectorXd last = Eigen::RowVectorXd::Unit(d + 1, d);
  if (map.row(d) != last) return self.mapped(map);
  return self.transformed(map.topLeftCorner(d, d), map.topRightCorner(d, 1));
}

template <int Corners>
std::string repr(const BezierSimplex<Corners>& self) {
  std::ostringstream text;
  text << "<osculate." << (Corners == 3 ? "BezierTriangle" : "BezierTetrahedron") << ": "
       << (self.isRational() ? "rational" : "polynomial") << ", degree " << self.degree() << ", "
       << self.size() << " points in E" << self.dimension() << ">";
  return text.str();
}

template <int Corners>
Array pointsOf(const BezierSimplex<Corners>& self) {
  return arrayOf(self.points().data(), {self.size(), self.dimension()});
}

template <int Corners>
py::object weightsOf(const BezierSimplex<Corners>& self) {
  if (!self.isRational()) return py::none();
  return arrayOf(self.weights().data(), {self.size()});
}

template <int Corners>
void bindData(py::class_<BezierSimplex<Corners>>& type) {
  using Simplex = BezierSimplex<Corners>;
  type.def(py::init(&make<Corners>), py::arg("degree"), py::arg("points"),
           py::arg("weights") = py::none())
      .def_property_readonly("degree", &Simplex::degree, "The degree, 1 to 12.")
      .def_property_readonly("dimension", &Simplex::dimension, "3 or 4: of the space it is in.")
      .def_property_readonly("points", &pointsOf<Corners>,
                             "The control points, (N, dimension), in mm.")
      .def_property_readonly("weights", &weightsOf<Corners>,
                             "The weights, (N,), or None for a polynomial one.")
      .def_property_readonly("is_rational", &Simplex::isRational, "True if it has weights.")
      .def_property_readonly(
          "indices", [](const Simplex& self) { return multiIndices<Corners>(self.degree()); },
          "The index of each control point, a list of lists in the order of the net.")
      .def_property_readonly(
          "box",
          [](const Simplex& self) {
            const auto [low, high] = self.box();
            return py::make_tuple(Eigen::VectorXd(low), Eigen::VectorXd(high));
          },
          "(lowest, highest) corner of the box of the control points, which contains it.")
      .def(
          "__eq__", [](const Simplex& self, const Simplex& other) { return self == other; },
          py::is_operator())
      .def("__repr__", &repr<Corners>)
      .def(py::pickle(
          [](const Simplex& self) {
            return py::make_tuple(self.degree(), pointsOf<Corners>(self), weightsOf<Corners>(self));
          },
          [](const py::tuple& state) { return make<Corners>(state[0], state[1], state[2]); }));
}

template <int Corners>
void bindOperations(py::class_<BezierSimplex<Corners>>& type) {
  using Simplex = BezierSimplex<Corners>;
  type.def("evaluate", &evaluate<Corners>, py::arg("u"), kEvaluateDoc)
      .def("derivative", &derivative<Corners>, py::arg("u"), py::arg("directions"), kDerivativeDoc)
      .def("partial", &partial<Corners>, py::arg("u"), py::arg("orders"), kPartialDoc)
      .def(
          "elevated",
          [](const Simplex& self, const py::object& times) {
            return self.elevated(integerFrom(times, "times"));
          },
          py::arg("times") = 1,
          "elevated(self, times=1)\n--\n\nThe same map with the degree raised; ValueError above "
          "degree 12.")
      .def("transformed", &transformed<Corners>, py::arg("matrix"), kTransformedDoc)
      .def(
          "edge",
          [](const Simplex& self, const py::object& a, const py::object& b) {
            return BSplineCurve(edgeCurve(self, integerFrom(a, "a"), integerFrom(b, "b")));
          },
          py::arg("a"), py::arg("b"), kEdgeDoc);
}

template <int Corners>
void bindParts(py::class_<BezierSimplex<Corners>>& type) {
  using Simplex = BezierSimplex<Corners>;
  type.def(
          "subdivided",
          [](const Simplex& self, const py::object& at) {
            return self.subdivided(
                at.is_none() ? Barycentric<Corners>(Barycentric<Corners>::Constant(1.0 / Corners))
                             : coordinateFrom<Corners>(at, "at"));
          },
          py::arg("at") = py::none(), kSubdividedDoc)
      .def("refined", &Simplex::refined,
           "refined(self)\n--\n\nThe 8 tetrahedra (4 triangles) with the middles of the edges as "
           "new corners, a list.")
      .def(
          "bisected",
          [](const Simplex& self, const py::object& a, const py::object& b) {
            return self.bisected(integerFrom(a, "a"), integerFrom(b, "b"));
          },
          py::arg("a"), py::arg("b"),
          "bisected(self, a, b)\n--\n\nThe halves cut at the middle of the edge from corner a to "
          "b, a pair; the first keeps corner a.")
      .def(
          "part",
          [](const Simplex& self, const py::object& corners) {
            return self.part(cornersFrom<Corners>(corners));
          },
          py::arg("corners"), kPartDoc);
}

Array jacobians(const BezierTetrahedron& self, const py::object& u) {
  const Array rows = coordinatesFrom<4>(u, "u");
  std::vector<py::ssize_t> shape(rows.shape(), rows.shape() + rows.ndim() - 1);
  Array result(shape);
  for (py::ssize_t i = 0; i < rows.size() / 4; ++i)
    result.mutable_data()[i] =
        jacobian(self, Eigen::Map<const Barycentric<4>>(rows.data() + 4 * i));
  return result;
}

void bindSurfaces(py::class_<BezierTetrahedron>& type) {
  type.def(
          "face",
          [](const BezierTetrahedron& self, const py::object& i) {
            return face(self, integerFrom(i, "i"));
          },
          py::arg("i"), "face(self, i)\n--\n\nThe face opposite to corner i, a BezierTriangle.")
      .def(
          "iso_surface",
          [](const BezierTetrahedron& self, const py::object& coordinate, const py::object& value) {
            return isoSurface(self, integerFrom(coordinate, "coordinate"),
                              numberFrom(value, "value"));
          },
          py::arg("coordinate"), py::arg("value"),
          "iso_surface(self, coordinate, value)\n--\n\nThe surface where barycentric coordinate 0 "
          "to 3 has the value, 0 <= value < 1, exactly, as a BezierTriangle.")
      .def(
          "relabelled",
          [](const BezierTetrahedron& self, const py::object& order) {
            return self.relabelled(permutationFrom(order, "order"));
          },
          py::arg("order"),
          "relabelled(self, order)\n--\n\nThe same solid; corner c of the result is corner "
          "order[c] of this one.");
}

void bindMap(py::class_<BezierTetrahedron>& type) {
  type.def_property_readonly(
          "warnings", &netWarnings,
          "Sentences on what is legal but no whole solid: flat and collapsed nets, collapsed faces "
          "and edges, corners of weight 0.")
      .def("jacobian", &jacobians, py::arg("u"),
           "jacobian(self, u)\n--\n\nThe Jacobian determinant of the map at u (as in evaluate), in "
           "mm^3: positive where corners 1, 2, 3 turn left seen from corner 0's opposite side.")
      .def(
          "normal",
          [](const BezierTetrahedron& self, const py::object& u) {
            return forRows<4>(self, u, [&](const auto& at) {
              return SpacePoint(tangentHyperplaneNormal(self, at));
            });
          },
          py::arg("u"),
          "normal(self, u)\n--\n\nIn E4: the unit normal of the tangent hyperplane at u; zero "
          "where the map is singular.");
}

}  // namespace

void bindSolid(py::module_& m) {
  py::class_<BezierTriangle> triangle(m, "BezierTriangle", kTriangleDoc);
  bindData<3>(triangle);
  bindOperations<3>(triangle);
  bindParts<3>(triangle);
  py::class_<BezierTetrahedron> tetrahedron(m, "BezierTetrahedron", kTetrahedronDoc);
  bindData<4>(tetrahedron);
  bindOperations<4>(tetrahedron);
  bindParts<4>(tetrahedron);
  bindSurfaces(tetrahedron);
  bindMap(tetrahedron);
}

}  // namespace osculate::python
