// Combs of curves in arrays.
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <type_traits>

#include <pybind11/stl.h>

#include "osculate/differential/comb.h"
#include "osculate/python/arguments.h"

namespace osculate::python {

namespace {

CombOptions combOptionsFrom(const py::object& density, const py::object& tolerance,
                            const std::vector<std::string>& quantities) {
  CombOptions options{.density = integerFrom(density, "density"),
                      .tolerance = numberFrom(tolerance, "tolerance"),
                      .shown = {}};
  for (const std::string& wanted : quantities) {
    std::size_t q = 0;
    while (q < kCombQuantities && name(static_cast<CombQuantity>(q)) != wanted)
      ++q;
    if (q == kCombQuantities) {
      throw std::invalid_argument("quantities: '" + wanted + "' is none of curvature, torsion, " +
                                  "curvature_rate, curvature_rate2, torsion_rate");
    }
    options.shown[q] = true;
  }
  return options;
}

/// One number, or one vector, of every sample of all combs.
template <class Get>
Array column(const std::vector<Comb>& combs, py::ssize_t count, const Get& get) {
  constexpr bool kIsVector = std::is_same_v<decltype(get(combs[0].samples[0])), Vector3>;
  Array array(kIsVector ? std::vector<py::ssize_t>{count, 3} : std::vector<py::ssize_t>{count});
  double* next = array.mutable_data();
  for (const Comb& comb : combs) {
    for (const CombSample& sample : comb.samples) {
      if constexpr (kIsVector) {
        const Vector3 value = get(sample);
        next = std::copy(value.begin(), value.end(), next);
      } else {
        *next++ = get(sample);
      }
    }
  }
  return array;
}

py::array teeth(const std::vector<Comb>& combs, py::ssize_t count) {
  py::array_t<bool> array(count);
  bool* next = array.mutable_data();
  for (const Comb& comb : combs) {
    for (const CombSample& sample : comb.samples)
      *next++ = sample.isTooth;
  }
  return array;
}

/// (runs, 3): first sample, last sample, number of the curve.
py::array runs(const std::vector<Comb>& combs) {
  const std::size_t count =
      std::accumulate(combs.begin(), combs.end(), std::size_t{0},
                      [](std::size_t sum, const Comb& comb) { return sum + comb.runs.size(); });
  py::array_t<std::int64_t> array({static_cast<py::ssize_t>(count), py::ssize_t{3}});
  std::int64_t* next = array.mutable_data();
  std::size_t before = 0;
  for (std::size_t i = 0; i < combs.size(); ++i) {
    for (const CombRun& run : combs[i].runs) {
      *next++ = static_cast<std::int64_t>(before + run.first);
      *next++ = static_cast<std::int64_t>(before + run.last);
      *next++ = static_cast<std::int64_t>(i);
    }
    before += combs[i].samples.size();
  }
  return array;
}

/// (kind, quantity, number of the curve, sample, uncertainty) of each mark.
py::list marks(const std::vector<Comb>& combs) {
  py::list list;
  std::size_t before = 0;
  for (std::size_t i = 0; i < combs.size(); ++i) {
    for (const CombMark& mark : combs[i].marks) {
      list.append(py::make_tuple(name(mark.kind), name(mark.quantity), i, before + mark.sample,
                                 mark.uncertainty));
    }
    before += combs[i].samples.size();
  }
  return list;
}

py::tuple arraysOf(const std::vector<Comb>& combs) {
  py::ssize_t count = 0;
  Array lengths(static_cast<py::ssize_t>(combs.size()));
  for (std::size_t i = 0; i < combs.size(); ++i) {
    count += static_cast<py::ssize_t>(combs[i].samples.size());
    lengths.mutable_data()[i] = combs[i].length;
  }
  const auto vector = [&](Vector3 CombSample::*member) {
    return column(combs, count, [member](const CombSample& s) { return s.*member; });
  };
  const auto number = [&](double CombSample::*member) {
    return column(combs, count, [member](const CombSample& s) { return s.*member; });
  };
  const auto value = [&](std::size_t q) {
    return column(combs, count, [q](const CombSample& s) { return s.value[q]; });
  };
  return py::make_tuple(number(&CombSample::parameter), number(&CombSample::arcLength),
                        vector(&CombSample::point), vector(&CombSample::tangent),
                        vector(&CombSample::normal), vector(&CombSample::binormal), value(0),
                        value(1), value(2), value(3), value(4), teeth(combs, count), runs(combs),
                        lengths, marks(combs));
}

py::tuple combArrays(const std::vector<BSplineCurve>& curves, const py::object& density,
                     const py::object& tolerance, const std::vector<std::string>& quantities) {
  const CombOptions options = combOptionsFrom(density, tolerance, quantities);
  std::vector<Comb> combs;
  {
    const py::gil_scoped_release release;
    combs.reserve(curves.size());
    for (const BSplineCurve& curve : curves)
      combs.push_back(comb(curve, options));
  }
  return arraysOf(combs);
}

}  // namespace

void bindComb(py::module_& m) {
  m.def("comb_arrays", &combArrays, py::arg("curves"), py::arg("density"), py::arg("tolerance"),
        py::arg("quantities"));
}

}  // namespace osculate::python
