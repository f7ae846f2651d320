#include <cmath>
#include <optional>
#include <vector>

#include <pybind11/stl.h>

#include "binding.h"
#include "dupin/blends/build.h"
#include "dupin/blends/certify.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/document.h"
#include "dupin/io/nurbs_json.h"
#include "dupin/io/schema.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::python {
namespace {

// As the extension of `source`, its file's name, says.
Document document_named(const std::string& text, const std::string& source) {
  return document_of(text, source, document_kind(source));
}

Assembly assembly_of_text(const std::string& text, const std::string& source) {
  return document_named(text, source).assembly;
}

std::optional<Region> region_named(const std::optional<std::string>& text) {
  if (!text) {
    return std::nullopt;
  }
  for (const Region region : {Region::outer, Region::metal, Region::fluid, Region::insulation}) {
    if (*text == name(region)) {
      return region;
    }
  }
  throw Error(Errc::invalid_argument,
              "'" + *text + "' must be 'outer', 'metal', 'fluid' or 'insulation'", {}, "region");
}

std::optional<CrossCheckEngine> engine_named(const std::optional<std::string>& text) {
  if (!text) {
    return std::nullopt;
  }
  for (const CrossCheckEngine engine : {CrossCheckEngine::nef, CrossCheckEngine::corefinement}) {
    if (*text == name(engine)) {
      return engine;
    }
  }
  throw Error(Errc::invalid_argument, "'" + *text + "' must be 'nef' or 'corefinement'", {},
              "cross_check");
}

/// The solid, and all that a report says but of its file.
py::tuple built(const std::string& text, const std::string& source, std::optional<double> tolerance,
                std::optional<std::uint32_t> segments, std::optional<double> connect,
                std::size_t most_triangles, const std::string& contacts,
                const std::optional<std::string>& cross_check,
                const std::optional<std::string>& region, const py::object& progress) {
  Interruptible work(progress);
  BuildOptions options{.tolerance = tolerance,
                       .segments = segments,
                       .most_triangles = most_triangles,
                       .contacts = contact_policy(contacts),
                       .cross_check = engine_named(cross_check),
                       .progress = work.progress(),
                       .region = region_named(region)};
  BuildReport report;
  Solid solid = work.run([&] {
    Document document = document_named(text, source);
    options.connect = connect.value_or(document.assembly.tolerance);
    Built result = build(document, options);
    Solid whole = result.solid;
    report.output.contacts = whole.contacts();
    take(report, std::move(result), document, options.connect);
    return whole;
  });
  return py::make_tuple(std::move(solid), to_json(report),
                        report.gaps.findings() + report.source_findings());
}

std::string gaps(const std::string& text, const std::string& source,
                 std::optional<double> connect) {
  return unlocked([&] {
    return to_json(document_kind(source) == DocumentKind::piping
                       ? piping_gap_summary(text, source, BoreMeaning::automatic, connect)
                       : gap_summary(document_named(text, source), connect));
  });
}

std::string nurbs_of(const std::string& text, const std::string& source,
                     std::optional<double> tolerance) {
  return unlocked([&] {
    const Assembly assembly = assembly_of_text(text, source);
    return nurbs_json(named_nurbs(assembly, tolerance.value_or(assembly.tolerance)), assembly.unit);
  });
}

std::string bill_of(const std::string& text, const std::string& source,
                    std::optional<double> density) {
  if (density && !(std::isfinite(*density) && *density > 0)) {
    throw Error(Errc::invalid_argument,
                "the density must be a positive number, in kg/m3, not " + decimal(*density));
  }
  return unlocked([&] {
    BillReport report = bill_report(document_named(text, source));
    report.density = density;
    return to_json(report);
  });
}

/// The assembly that a piping file or a graph is made into.
std::string converted(const std::string& text, const std::string& source,
                      std::optional<double> radius, bool keep_going, std::optional<double> snap,
                      double bridge, std::optional<double> wall) {
  return unlocked([&] {
    SourceOptions options{.radius = radius, .snap = snap, .bridge = bridge};
    const DocumentKind kind = document_kind(source);
    options.keep_going = keep_going;
    if (kind == DocumentKind::piping) {
      options.wall = wall;
    }
    Assembly assembly = document_of(text, source, kind, options).assembly;
    assembly.wall = wall ? wall : assembly.wall;
    return document_text(assembly);
  });
}

void bind_certificate(py::module_& module) {
  py::class_<Certificate> kind(
      module, "Certificate",
      "Claims about the smooth parts of an assembly, with what is needed to check them again "
      "(docs/certificate_format.md).");
  refuse_unmade(kind);
  kind.def_property_readonly("findings", &Certificate::findings,
                             "How many claims are refuted or undecided.")
      .def_property_readonly("_summary", &certificate_summary_json)
      .def("to_json", &certificate_json, py::call_guard<py::gil_scoped_release>(),
           "The certificate as a JSON document, what `dupin certify` writes.")
      .def(
          "verify", [](const Certificate& self) { unlocked([&] { verify(self); }); },
          "Checks every claim again, by other code than the prover's; raises InvalidArgument "
          "naming the part and claim that does not follow.")
      .def("_require_about",
           [](const Certificate& self, const std::string& text, const std::string& source) {
             unlocked([&] { require_about(self, text, assembly_of_text(text, source)); });
           });
  module.def("certify", [](const std::string& text, const std::string& source,
                           std::optional<double> margin, std::optional<double> tolerance,
                           std::size_t most_triangles, const py::object& progress) {
    Interruptible work(progress);
    return work.run([&] {
      Assembly assembly = assembly_of_text(text, source);
      assembly.tolerance = tolerance.value_or(assembly.tolerance);
      Certificate certificate = certify(
          assembly,
          {.margin = margin, .most_triangles = most_triangles, .progress = work.progress()});
      certificate.document_sha256 = sha256(text);
      return certificate;
    });
  });
  module.def("parse_certificate", [](const std::string& text, const std::string& source) {
    return unlocked([&] { return parse_certificate(text, source); });
  });
}

}  // namespace

void bind_documents(py::module_& module) {
  bind_certificate(module);
  module.attr("usual_triangles") = kUsualTriangles;
  module.attr("part_keys") = [] {
    py::list keys;
    for (const KeyName& key : PartKeys::kNames) {
      keys.append(py::str(std::string(key.view())));
    }
    return py::tuple(keys);
  }();
  module.def("build", &built);
  module.def("gaps", &gaps);
  module.def("nurbs", &nurbs_of);
  module.def("bill_of_materials", &bill_of);
  module.def("converted", &converted);
  module.def("schema", [](const std::string& kind) {
    if (kind != "assembly" && kind != "certificate") {
      throw Error(Errc::invalid_argument, "'" + kind + "' must be 'assembly' or 'certificate'", {},
                  "kind");
    }
    return std::string(kind == "assembly" ? assembly_schema() : certificate_schema());
  });
  module.def("write_text", [](const std::string& path, const std::string& text) {
    unlocked([&] { write_file(path, text); });
  });
  module.def("read_text", [](const std::string& path) {
    return py::bytes(unlocked([&] { return read_file(path); }));
  });
  module.def("document_text", [](const std::string& text, const std::string& source) {
    return unlocked([&] { return document_text(parse_assembly(text, source)); });
  });
  module.def("require_valid", [](const std::string& text, const std::string& source) {
    unlocked([&] { (void)resolve(parse_assembly(text, source)); });
  });
}

}  // namespace dupin::python
