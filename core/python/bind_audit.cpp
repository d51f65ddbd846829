// Audits: the joins of a whole shape. The package `osculate` puts its AuditReport in front of
// these.
#include <fstream>
#include <memory>

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "osculate/continuity/audit_document.h"
#include "osculate/occt/audit.h"
#include "osculate/occt/binary_shape.h"
#include "osculate/occt/model_file.h"
#include "osculate/python/arguments.h"
#include "osculate/python/report_values.h"
#ifdef OSCULATE_HAS_SHAPE_PROXY
#include "osculate/python/shape_proxy.h"
#endif

namespace osculate::python {

namespace {

constexpr const char* kRowDoc = R"(One join of an audit: read-only.

`kind` is "vertex" (two edges at a vertex that both have), "knot" (an inner knot of one edge) or
"seam" (a closed edge with itself). `edges` are two numbers, from 1 as in Edge1, the lower first and
equal for knot and seam; `ends` says which ends meet, "start" or "end" each, or is None for a knot;
`parameter` is that of a knot, or None. `point` is the first edge's end. The other attributes are
those of JoinReport.)";

/// What an audit found, as a document of one file.
struct AuditTable {
  ShapeAudit audit;
  AuditDocument document;

  const AuditReport& report() const { return document.files.front().report; }
};

/// A row with what says how many of its orders were asked for.
struct RowRecord {
  AuditRow row;
  int requestedOrder;
  std::size_t index;
};

AuditOptions auditOptionsFrom(const py::object& order, const py::object& tolerances,
                              const py::object& pairs, const py::object& cornerDegrees,
                              const py::object& touchMm, const py::object& threads) {
  AuditOptions options;
  options.analysis = optionsFrom(order, tolerances);
  if (!py::isinstance<py::str>(pairs)) failType("pairs", "'all', 'wire' or 'tangent'", pairs);
  options.pairs = joinPairs(pairs.cast<std::string>());
  options.cornerDegrees = numberFrom(cornerDegrees, "corner_deg");
  options.touchMm = numberFrom(touchMm, "touch_mm");
  options.threads = threads.is_none() ? 0 : integerFrom(threads, "threads");
  checkAuditOptions(options);
  return options;
}

/// `read` gives the Model; it and the audit run without the GIL.
template <class Read>
std::shared_ptr<AuditTable> audit(Read read, const std::string& file, const AuditOptions& options,
                                  const py::object& callback) {
  const Progress progress = progressFrom(callback);
  const py::gil_scoped_release release;
  Model model = read();
  ShapeAudit audit(model.shape, options, progress);
  AuditedFile audited{file, FileStatus::kAudited, {}, std::move(model.notes), audit.takeReport()};
  AuditDocument document{options, {}};
  document.files.push_back(std::move(audited));
  return std::make_shared<AuditTable>(AuditTable{std::move(audit), std::move(document)});
}

std::shared_ptr<AuditTable> auditFile(const std::string& path, const AuditOptions& options,
                                      const py::object& progress) {
  return audit([&] { return readModel(path); }, path, options, progress);
}

std::shared_ptr<AuditTable> auditBinary(const std::string& path, const AuditOptions& options,
                                        const py::object& progress) {
  const auto read = [&] {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw std::invalid_argument("path: cannot read " + path);
    return Model{readBinaryShape(stream), ModelFormat::kBrep, {}};
  };
  return audit(read, "", options, progress);
}

#ifdef OSCULATE_HAS_SHAPE_PROXY
std::shared_ptr<AuditTable> auditProxy(const py::object& proxy, const AuditOptions& options,
                                       const py::object& progress) {
  const Model model{takeShape(proxy), ModelFormat::kBrep, {}};
  return audit([&] { return model; }, "", options, progress);
}
#endif

RowRecord recordOf(const AuditTable& table, std::size_t index) {
  return {table.report().rows.at(index), table.report().options.analysis.order, index};
}

py::list worst(const AuditTable& table, std::size_t count) {
  py::list list;
  const AuditReport& report = table.report();
  for (const std::size_t index : worstRows(report.rows, count, report.options.analysis))
    list.append(recordOf(table, index));
  return list;
}

py::list skipped(const AuditTable& table) {
  py::list list;
  for (const SkippedEdge& edge : table.report().skipped)
    list.append(py::make_tuple(edge.edge, edge.degenerated, edge.reason));
  return list;
}

std::string summaryJson(const AuditTable& table) {
  const AuditReport& report = table.report();
  return auditSummaryJson(summarize(report.rows), report.options).dump();
}

/// Arrays for tables and plots: kind, edges, order, parametric order, points, residuals.
py::tuple columns(const AuditTable& table) {
  const AuditReport& report = table.report();
  const auto count = static_cast<py::ssize_t>(report.rows.size());
  const py::ssize_t orders = report.options.analysis.order + 1;
  py::array_t<std::uint8_t> kind(count);
  py::array_t<std::int32_t> edges({count, py::ssize_t{2}});
  py::array_t<std::int8_t> order(count);
  py::array_t<std::int8_t> parametricOrder(count);
  py::array_t<double> point({count, py::ssize_t{3}});
  py::array_t<std::uint8_t> verdicts({count, orders});
  py::array_t<double> residuals({count, orders});
  for (py::ssize_t i = 0; i < count; ++i) {
    const AuditRow& row = report.rows[static_cast<std::size_t>(i)];
    kind.mutable_at(i) = static_cast<std::uint8_t>(row.kind);
    order.mutable_at(i) = row.order;
    parametricOrder.mutable_at(i) = row.parametricOrder;
    std::copy(row.edges.begin(), row.edges.end(), edges.mutable_data(i, 0));
    std::copy(row.point.begin(), row.point.end(), point.mutable_data(i, 0));
    std::copy_n(row.residuals.begin(), orders, residuals.mutable_data(i, 0));
    for (py::ssize_t k = 0; k < orders; ++k) {
      verdicts.mutable_at(i, k) =
          static_cast<std::uint8_t>(row.verdicts[static_cast<std::size_t>(k)]);
    }
  }
  return py::make_tuple(kind, edges, order, parametricOrder, point, verdicts, residuals);
}

/// A file's name need not be UTF-8.
py::str decoded(std::string_view text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
}

TextSink sinkOf(const py::function& write) {
  return [write](std::string_view piece) { write(decoded(piece)); };
}

py::object endsOf(const AuditRow& row) {
  if (row.kind == JoinKind::kKnot) return py::none();
  return py::make_tuple(name(row.ends.first), name(row.ends.second));
}

py::tuple verdictsOf(const RowRecord& self) {
  py::tuple result(self.requestedOrder + 1);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = name(self.row.verdicts[k]);
  return result;
}

template <class Map>
auto property(Map map) {
  return [map](const RowRecord& self) { return map(self.row); };
}

void bindRow(py::module_& m) {
  const auto isKnot = [](const AuditRow& row) { return row.kind == JoinKind::kKnot; };
  py::class_<RowRecord>(m, "AuditRow", kRowDoc)
      .def_readonly("index", &RowRecord::index, "Number of the row in `rows`, from 0.")
      .def_property_readonly("kind", property([](const AuditRow& row) { return name(row.kind); }))
      .def_property_readonly("edges", property([](const AuditRow& row) {
                               return py::make_tuple(row.edges[0], row.edges[1]);
                             }))
      .def_property_readonly("ends", property(endsOf))
      .def_property_readonly("parameter", property([isKnot](const AuditRow& row) -> py::object {
                               return isKnot(row) ? py::cast(row.parameter) : py::none();
                             }))
      .def_property_readonly(
          "point", property([](const AuditRow& row) { return arrayOf(row.point.data(), {3}); }))
      .def_property_readonly("order", property([](const AuditRow& row) { return int{row.order}; }))
      .def_property_readonly("parametric_order",
                             property([](const AuditRow& row) { return int{row.parametricOrder}; }))
      .def_property_readonly("verdicts", verdictsOf)
      .def_property_readonly(
          "residuals",
          [](const RowRecord& self) { return upTo(self.requestedOrder, self.row.residuals); })
      .def_property_readonly(
          "deviation", property([](const AuditRow& row) { return deviationDict(row.deviation()); }))
      .def_property_readonly("warnings", property([](const AuditRow& row) {
                               return py::tuple(py::cast(row.warnings.list()));
                             }));
}

void bindTable(py::module_& m) {
  py::class_<AuditTable, std::shared_ptr<AuditTable>>(m, "AuditTable")
      .def("__len__", [](const AuditTable& self) { return self.report().rows.size(); })
      .def("row", &recordOf)
      .def("worst", &worst)
      .def("join",
           [](const AuditTable& self, const RowRecord& row) {
             return std::make_shared<CurveJoin>(self.audit.join(row.row));
           })
      .def("summary_json", &summaryJson)
      .def("text", [](const AuditTable& self,
                      std::size_t worst) { return decoded(auditText(self.document, worst)); })
      .def("write_csv",
           [](const AuditTable& self, const py::function& write) {
             writeAuditCsv(self.document, sinkOf(write));
           })
      .def("write_json",
           [](const AuditTable& self, const py::function& write) {
             writeAuditJson(self.document, sinkOf(write));
           })
      .def("columns", &columns)
      .def_property_readonly("skipped", &skipped)
      .def_property_readonly(
          "notes", [](const AuditTable& self) { return self.document.files.front().notes; })
      .def_property_readonly("edge_count",
                             [](const AuditTable& self) { return self.report().edgeCount; })
      .def_property_readonly("corners",
                             [](const AuditTable& self) { return self.report().corners; })
      .def_property_readonly("is_complete",
                             [](const AuditTable& self) { return self.report().complete; });
}

}  // namespace

void bindAudit(py::module_& m) {
  bindRow(m);
  bindTable(m);
  py::class_<AuditOptions>(m, "AuditOptions")
      .def(py::init(&auditOptionsFrom), py::arg("order"), py::arg("tolerances"), py::arg("pairs"),
           py::arg("corner_deg"), py::arg("touch_mm"), py::arg("threads"));
  m.def("audit_file", &auditFile, py::arg("path"), py::arg("options"), py::arg("progress"));
  m.def("audit_binary", &auditBinary, py::arg("path"), py::arg("options"), py::arg("progress"));
#ifdef OSCULATE_HAS_SHAPE_PROXY
  m.def("audit_proxy", &auditProxy, py::arg("proxy"), py::arg("options"), py::arg("progress"));
#endif
}

}  // namespace osculate::python
