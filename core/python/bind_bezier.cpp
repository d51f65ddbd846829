// osculate.Curve: the value itself, without what needs differential geometry or OpenCASCADE.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <pybind11/stl.h>

#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

constexpr const char* kCurveDoc =
    R"(A Bézier or B-spline curve in space, polynomial or rational: an immutable value.

Made by Curve.bezier, Curve.bspline or Curve.from_edge. Every operation returns a new curve; arrays
it returns are copies. Lengths are in mm. Two curves are equal when all their numbers are.)";

constexpr const char* kBezierDoc = R"(bezier(poles, weights=None)
--

The Bézier curve over [0, 1] with the given control points.

poles: (n+1, 3) finite coordinates in mm, n from 1 to 25, not all one point. weights: (n+1,) finite
and > 0, or None for a polynomial curve. Raises ValueError that names the argument and the rule,
TypeError for what is no array of numbers.)";

constexpr const char* kBsplineDoc =
    R"(bspline(poles, knots, multiplicities, degree, weights=None, periodic=False)
--

The B-spline curve with the given poles and knots, in the form of Part.BSplineCurve.

poles: (m, 3) finite coordinates in mm. knots: increasing finite numbers. multiplicities: one for
each knot, from 1 to degree+1, with the sum m+degree+1. A periodic curve: from 1 to degree, equal
for the first and the last knot, with the sum m without the last. degree: 1 to 25. weights: (m,)
finite and > 0, or None. Its range is [flat[degree], flat[m]] of the knots repeated by multiplicity.
Raises ValueError that names the argument and the rule, TypeError for what is no array of numbers.)";

constexpr const char* kEvaluateDoc = R"(evaluate(self, t, derivatives=0, side='right')
--

The point and the first derivatives by the parameter, in mm per parameter^k.

t: a number, or (k,) numbers, within `parameter_range`. derivatives: 0 to 25. side: 'left' or
'right', the side from which a knot is approached. Returns (derivatives+1, 3), or
(k, derivatives+1, 3) for an array of parameters; row 0 is the point. Raises ValueError outside the
range.)";

constexpr const char* kSegmentsDoc = R"(segments(self)
--

The Bézier segments of which the curve is made, in its direction, each over [0, 1].

They meet at the knots inside the range. Segments that are a single point are left out.)";

constexpr const char* kReversedDoc = R"(reversed(self)
--

The same curve travelled the other way, over the same range.)";

constexpr const char* kElevatedDoc = R"(elevated(self, times=1)
--

The same curve with the degree raised by `times`. Raises ValueError above degree 25.)";

constexpr const char* kSplitDoc = R"(split(self, t)
--

The parts before and after t, as a pair; each keeps its own part of the range. Raises ValueError
unless t is inside the range.)";

constexpr const char* kTrimmedDoc = R"(trimmed(self, first, last)
--

The part [first, last] of the curve, clamped, over that range. A periodic curve may be crossed at
its seam: last up to first + period. Raises ValueError unless first < last lie within the range.)";

constexpr int kMaxDerivatives = kMaxDegree;

BSplineCurve bezier(const py::object& poles, const py::object& weights) {
  const Poles points = polesFrom(poles, "poles");
  const std::vector<Vector3> columns(points.colwise().begin(), points.colwise().end());
  return BSplineCurve(BezierCurve(columns, weightsFrom(weights, points.cols())));
}

BSplineCurve bspline(const py::object& poles, const py::object& knots,
                     const py::object& multiplicities, const py::object& degree,
                     const py::object& weights, const py::object& periodic) {
  BSplineData data{
      .poles = polesFrom(poles, "poles"),
      .weights = {},
      .knots = {numbersFrom(knots, "knots"), integersFrom(multiplicities, "multiplicities")},
      .degree = integerFrom(degree, "degree"),
      .periodic = boolFrom(periodic, "periodic")};
  data.weights = weightsFrom(weights, data.poles.cols());
  return BSplineCurve(std::move(data));
}

/// Each derivative as a row.
void fillRows(double* rows, const BSplineCurve& curve, double t, int derivatives, Side side) {
  for (const Vector3& derivative : curve.derivatives(t, derivatives, side)) {
    rows = std::copy(derivative.begin(), derivative.end(), rows);
  }
}

Array evaluate(const BSplineCurve& curve, const py::object& parameters,
               const py::object& derivatives, const py::object& side) {
  const Array t = arrayFrom(parameters, "t");
  const int count = integerFrom(derivatives, "derivatives");
  if (count < 0 || count > kMaxDerivatives) {
    throw std::invalid_argument("derivatives: must be from 0 to " +
                                std::to_string(kMaxDerivatives));
  }
  if (t.ndim() > 1) throw std::invalid_argument("t: must be a number or have the shape (k,)");
  const Side from = sideFrom(side);
  for (py::ssize_t i = 0; i < t.size(); ++i)
    checkParameter(curve, t.data()[i]);
  std::vector<py::ssize_t> shape(t.shape(), t.shape() + t.ndim());
  shape.insert(shape.end(), {count + 1, 3});
  Array result(shape);
  for (py::ssize_t i = 0; i < t.size(); ++i) {
    fillRows(result.mutable_data() + 3 * (count + 1) * i, curve, t.data()[i], count, from);
  }
  return result;
}

std::vector<BSplineCurve> segments(const BSplineCurve& curve) {
  std::vector<BSplineCurve> result;
  for (int span = 0; span < curve.spanCount(); ++span) {
    if (const auto segment = asCurve(curve.segment(span))) result.push_back(*segment);
  }
  return result;
}

py::object weightsOf(const BSplineCurve& curve) {
  if (!curve.isRational()) return py::none();
  const std::vector<double>& weights = curve.data().weights;
  return arrayOf(weights.data(), {static_cast<py::ssize_t>(weights.size())});
}

Array polesOf(const BSplineCurve& curve) {
  const Poles& poles = curve.data().poles;
  return arrayOf(poles.data(), {poles.cols(), 3});
}

Array knotsOf(const BSplineCurve& curve) {
  const std::vector<double>& knots = curve.data().knots.knots;
  return arrayOf(knots.data(), {static_cast<py::ssize_t>(knots.size())});
}

bool areEqual(const BSplineCurve& a, const BSplineCurve& b) {
  const BSplineData& p = a.data();
  const BSplineData& q = b.data();
  return &p == &q ||
         (p.degree == q.degree && p.periodic == q.periodic && p.poles.cols() == q.poles.cols() &&
          p.poleError == q.poleError && p.poles == q.poles && p.weights == q.weights &&
          p.knots.knots == q.knots.knots && p.knots.multiplicities == q.knots.multiplicities);
}

std::string repr(const BSplineCurve& curve) {
  std::ostringstream text;
  text << "<osculate.Curve: " << (curve.isPeriodic() ? "periodic " : "")
       << (curve.isRational() ? "rational" : "polynomial") << ", degree " << curve.degree() << ", "
       << curve.data().poles.cols() << " poles, " << curve.spanCount()
       << (curve.spanCount() == 1 ? " segment" : " segments") << ", over [" << curve.first() << ", "
       << curve.last() << "]>";
  return text.str();
}

py::tuple pickledState(const BSplineCurve& curve) {
  return py::make_tuple(polesOf(curve), knotsOf(curve), curve.data().knots.multiplicities,
                        curve.degree(), weightsOf(curve), curve.isPeriodic(), curve.poleError());
}

BSplineCurve unpickled(const py::tuple& state) {
  return bspline(state[0], state[1], state[2], state[3], state[4], state[5])
      .withPoleError(state[6].cast<double>());
}

void bindData(py::class_<BSplineCurve>& curve) {
  curve.def_property_readonly("degree", &BSplineCurve::degree, "The degree, 1 to 25.")
      .def_property_readonly("poles", &polesOf, "The poles, (m, 3), in mm.")
      .def_property_readonly("weights", &weightsOf,
                             "The weights, (m,), or None for a polynomial curve.")
      .def_property_readonly("knots", &knotsOf, "The distinct knots, increasing.")
      .def_property_readonly(
          "multiplicities",
          [](const BSplineCurve& self) {
            return py::array(py::cast(self.data().knots.multiplicities));
          },
          "How often each knot is repeated, (len(knots),) integers.")
      .def_property_readonly("is_rational", &BSplineCurve::isRational,
                             "True if the curve has weights.")
      .def_property_readonly("is_periodic", &BSplineCurve::isPeriodic,
                             "True if the knots and poles repeat with the period of the range.")
      .def_property_readonly(
          "parameter_range",
          [](const BSplineCurve& self) { return py::make_tuple(self.first(), self.last()); },
          "The first and the last parameter, (float, float).")
      .def_property_readonly(
          "pole_error", &BSplineCurve::poleError,
          "Bound in mm of the error of the poles beyond rounding: of curves converted from an edge "
          "that "
          "has no exact form, else 0. It enters the uncertainties of an analysis.");
}

void bindOperations(py::class_<BSplineCurve>& curve) {
  curve
      .def("evaluate", &evaluate, py::arg("t"), py::arg("derivatives") = 0,
           py::arg("side") = "right", kEvaluateDoc)
      .def("segments", &segments, kSegmentsDoc)
      .def("reversed", &BSplineCurve::reversed, kReversedDoc)
      .def(
          "elevated",
          [](const BSplineCurve& self, const py::object& times) {
            return self.elevated(integerFrom(times, "times"));
          },
          py::arg("times") = 1, kElevatedDoc)
      .def(
          "split",
          [](const BSplineCurve& self, const py::object& t) {
            return self.split(numberFrom(t, "t"));
          },
          py::arg("t"), kSplitDoc)
      .def(
          "trimmed",
          [](const BSplineCurve& self, const py::object& first, const py::object& last) {
            return self.trimmed(numberFrom(first, "first"), numberFrom(last, "last"));
          },
          py::arg("first"), py::arg("last"), kTrimmedDoc)
      .def(
          "__eq__",
          [](const BSplineCurve& self, const BSplineCurve& other) { return areEqual(self, other); },
          py::is_operator())
      .def("__repr__", &repr)
      .def(py::pickle(&pickledState, &unpickled));
}

}  // namespace

void checkParameter(const BSplineCurve& curve, double t) {
  if (curve.first() <= t && t <= curve.last()) return;
  std::ostringstream text;
  text << "t: must be within the range [" << curve.first() << ", " << curve.last() << "], got "
       << t;
  throw std::invalid_argument(text.str());
}

std::optional<BSplineCurve> asCurve(const BezierSegment& segment) {
  const BezierCurve& bezier = segment.curve;
  bool isPoint = true;
  for (int i = 1; i <= bezier.degree(); ++i)
    isPoint = isPoint && bezier.pole(i) == bezier.pole(0);
  if (isPoint) return {};
  return BSplineCurve(bezier, 0.0, 1.0, segment.poleError);
}

void bindBezier(py::module_& m) {
  py::class_<BSplineCurve> curve(m, "Curve", kCurveDoc);
  curve.def_static("bezier", &bezier, py::arg("poles"), py::arg("weights") = py::none(), kBezierDoc)
      .def_static("bspline", &bspline, py::arg("poles"), py::arg("knots"),
                  py::arg("multiplicities"), py::arg("degree"), py::arg("weights") = py::none(),
                  py::arg("periodic") = false, kBsplineDoc);
  bindData(curve);
  bindOperations(curve);
}

}  // namespace osculate::python
