#include <numbers>
#include <optional>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "binding.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/boolean_expression.h"
#include "dupin/kernel/contacts.h"
#include "dupin/kernel/placement.h"
#include "dupin/kernel/remesh.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/simplify.h"

namespace dupin::python {
namespace {

// In hexadecimal digits, of which Python reads any number; decimal ones are at most 4300.
py::object fraction(const mpq_class& number) {
  const py::object integer = py::module_::import("builtins").attr("int");
  return py::module_::import("fractions")
      .attr("Fraction")(integer(number.get_num().get_str(16), 16),
                        integer(number.get_den().get_str(16), 16));
}

py::dict contact(const Contact& contact) {
  using namespace py::literals;
  return py::dict("kind"_a = contact.kind == Contact::Kind::edge ? "edge" : "vertex",
                  "from"_a = contact.from, "to"_a = contact.to, "names"_a = contact.names);
}

// How coordinates are rounded; of no origin, about zero.
RoundingOptions rounding_options(double tolerance, double grid, const py::object& origin) {
  RoundingOptions options{.tolerance = tolerance, .output_grid = grid, .origin = {}};
  if (!origin.is_none()) {
    options.origin = {Origin::Choice::given, vector_of(origin, "origin")};
  }
  return options;
}

// Apart where it touches itself, for formats whose readers would weld it there.
Rounded rounded_for(const MeshFormat& format, const Solid& solid, const RoundingOptions& options,
                    OutputReport& report) {
  if (!format.merges_points) {
    return to_mesh(solid, format.coordinates, options);
  }
  RoundedApart apart = rounded_apart(solid, format.coordinates, options);
  if (!apart.contacts.empty()) {
    report.settled = {"separate", apart.length, std::move(apart.contacts)};
  }
  return std::move(apart.rounded);
}

std::string write_solid(const Solid& solid, const std::string& path, const std::string& format,
                        const std::string& unit, const RoundingOptions& rounding,
                        const py::object& callback) {
  Interruptible work(callback);
  return work.run([&] {
    const MeshFormat& to = format_named(format, path);
    require_unit(unit);
    const Progress progress = work.progress();
    tell(progress, "round");
    OutputReport report;
    const Rounded rounded = rounded_for(to, solid, rounding, report);
    report.file = path;
    report.format = to.name;
    report.rounding = rounded.report();
    report.contacts = rounded.contacts();
    report.verification = Verification::compare;
    report.check = check(rounded);
    write_verified(path, rounded, to, {unit, {}}, progress);
    return to_json(report);
  });
}

template <class Settle>
Solid settled(const Solid& solid, double length, const py::object& progress, const Settle& settle) {
  Interruptible work(progress);
  return work.run([&] { return settle(solid, length, work.progress()).solid; });
}

Solid moved(const Solid& solid, const Placement& placement) {
  return unlocked([&] { return placed(solid, placement); });
}

template <class Class>
void bind_measures(Class& solid) {
  solid.def_property_readonly("volume", &Solid::volume, "The double nearest to exact_volume.")
      .def_property_readonly(
          "exact_volume", [](const Solid& self) { return fraction(self.exact_volume()); },
          "As a fractions.Fraction, without any rounding.")
      .def_property_readonly("area", &Solid::area, "Of the surface; relative error below 1e-12.")
      .def_property_readonly("shells", &Solid::shells, "Connected pieces of the boundary.")
      .def_property_readonly("components", &Solid::components, "Connected pieces of the set.")
      .def_property_readonly("euler_number", &Solid::euler_number, "V - E + F of the boundary.")
      .def_property_readonly("genus", &Solid::genus, "The sum over the shells.")
      .def_property_readonly("is_empty", &Solid::empty, "Whether it is the empty set.")
      .def_property_readonly(
          "contacts",
          [](const Solid& self) {
            py::list list;
            for (const Contact& place : self.contacts()) {
              list.append(contact(place));
            }
            return list;
          },
          "Where it touches itself: dicts with kind, from, to, names.");
}

template <class Class>
void bind_arrays(Class& solid) {
  const auto rows = [](const auto& list) { return py::ssize_t(list.size()); };
  solid
      .def_property_readonly(
          "points",
          [rows](const py::object& self) {
            const auto& points = self.cast<const Solid&>().nearest_points();
            return view(points.empty() ? nullptr : points.front().data(), rows(points), 3, self);
          },
          "(n, 3) of float64, each coordinate the nearest double: for display and measuring. For "
          "a mesh that is a solid with its own numbers use `mesh`.")
      .def_property_readonly(
          "triangles",
          [rows](const py::object& self) {
            const auto& triangles = self.cast<const Solid&>().triangles();
            return view(triangles.empty() ? nullptr : triangles.front().data(), rows(triangles), 3,
                        self);
          },
          "(m, 3) of uint32: a view, not to be written.")
      .def_property_readonly(
          "labels",
          [rows](const py::object& self) -> py::object {
            const auto& labels = self.cast<const Solid&>().labels();
            return labels.empty() ? py::object(py::none())
                                  : view(labels.data(), rows(labels), 1, self);
          },
          "(m,) of uint32, indices into names; None if nothing is labelled.")
      .def_property_readonly(
          "names", [](const Solid& self) { return self.names(); }, "What the labels stand for.")
      .def_property_readonly(
          "sources",
          [rows](const py::object& self) {
            static_assert(sizeof(Source) == 2 * sizeof(std::uint32_t));
            const auto& sources = self.cast<const Solid&>().sources();
            return view(sources.empty() ? nullptr : &sources.front().operand, rows(sources), 2,
                        self);
          },
          "(m, 2) of uint32: which operand of the last operation each triangle comes from, and "
          "which of its triangles.")
      .def(
          "exact_point",
          [](const Solid& self, std::uint32_t index) {
            if (const std::size_t count = self.point_count(); index >= count) {
              throw py::index_error("there are " + std::to_string(count) + " points, from 0; not " +
                                    std::to_string(index));
            }
            const auto [x, y, z] = self.exact_point(index);
            return py::make_tuple(fraction(x), fraction(y), fraction(z));
          },
          py::arg("index"), "The very coordinates of a point, as Fractions.");
}

template <class Class>
void bind_operations(Class& solid) {
  const auto combined = [](auto operation) {
    return [operation](const Solid& a, const Solid& b) {
      Interruptible work(py::none{});
      const BooleanOptions options{ContactPolicy::report, work.progress()};
      return work.run([&] { return operation(a, b, options); });
    };
  };
  const auto united = combined([](const Solid& a, const Solid& b, const BooleanOptions& options) {
    return unite(std::array{a, b}, options);
  });
  solid.def("__add__", united, py::is_operator())
      .def("__or__", united, py::is_operator())
      .def("__sub__", combined([](const Solid& a, const Solid& b, const BooleanOptions& options) {
             return subtract(a, std::array{b}, options);
           }),
           py::is_operator())
      .def("__and__", combined([](const Solid& a, const Solid& b, const BooleanOptions& options) {
             return intersect(std::array{a, b}, options);
           }),
           py::is_operator())
      .def(
          "translate",
          [](const Solid& self, const py::object& by) {
            Placement placement;
            placement.translate(vector_of(by, "by"));
            return moved(self, placement);
          },
          py::arg("by"), "The solid moved by a vector, exactly.")
      .def(
          "rotate",
          [](const Solid& self, const py::object& axis, double degrees, const py::object& about) {
            Placement placement;
            placement.rotate(vector_of(axis, "axis"), degrees, vector_of(about, "about"));
            return moved(self, placement);
          },
          py::arg("axis"), py::arg("degrees"), py::arg("about") = py::make_tuple(0.0, 0.0, 0.0),
          "The solid turned about an axis; exactly for multiples of 90 degrees, else by an angle "
          "that differs by less than 4e-15.")
      .def(
          "scale",
          [](const Solid& self, double factor) {
            Placement placement;
            placement.scale(factor);
            return moved(self, placement);
          },
          py::arg("factor"), "The solid scaled about the origin, exactly.")
      .def(
          "separate",
          [](const Solid& self, double distance, const py::object& progress) {
            return settled(self, distance, progress, &dupin::separate);
          },
          py::arg("distance"), py::kw_only(), py::arg("progress") = py::none(),
          "Without the material around contacts: it no longer touches itself.")
      .def(
          "bridge",
          [](const Solid& self, double radius, const py::object& progress) {
            return settled(self, radius, progress, &dupin::bridge);
          },
          py::arg("radius"), py::kw_only(), py::arg("progress") = py::none(),
          "With material added around contacts.")
      .def(
          "simplify",
          [](const Solid& self, double tolerance, const py::object& progress) {
            Interruptible work(progress);
            return work.run([&] { return simplify(self, tolerance, work.progress()).mesh; });
          },
          py::arg("tolerance"), py::kw_only(), py::arg("progress") = py::none(),
          "A Mesh with fewer triangles within a distance, still a solid, labels' borders kept.");
}

template <class Class>
void bind_output(Class& solid) {
  solid
      .def(
          "mesh",
          [](const Solid& self, const std::string& coordinates, double tolerance, double grid,
             const py::object& origin) {
            if (coordinates != "binary64" && coordinates != "binary32") {
              throw Error(Errc::invalid_argument,
                          "'" + coordinates + "' must be 'binary64' or 'binary32'", {},
                          "coordinates");
            }
            const RoundingOptions rounding = rounding_options(tolerance, grid, origin);
            return unlocked([&] {
              Rounded rounded = to_mesh(
                  self, coordinates == "binary64" ? Coordinates::binary64 : Coordinates::binary32,
                  rounding);
              return std::move(rounded).mesh();
            });
          },
          py::kw_only(), py::arg("coordinates") = "binary64", py::arg("tolerance") = 0.0,
          py::arg("grid") = 0.0, py::arg("origin") = py::none(),
          "Rounded once, to numbers with which it is proved to be a solid still: a Mesh.")
      .def("_write", [](const Solid& self, const std::string& path, const std::string& format,
                        const std::string& unit, double tolerance, double grid,
                        const py::object& origin, const py::object& progress) {
        return write_solid(self, path, format, unit, rounding_options(tolerance, grid, origin),
                           progress);
      });
}

std::string solid_text(const Solid& solid) {
  return "Solid(" + std::to_string(solid.triangle_count()) + " triangles, " +
         std::to_string(solid.components()) + " components)";
}

void bind_combinations(py::module_& module) {
  module.def("combine", [](const std::string& operation, const std::vector<Solid>& solids,
                           const std::string& contacts, const py::object& progress) {
    Interruptible work(progress);
    const BooleanOptions options{contact_policy(contacts), work.progress()};
    return work.run([&] {
      if (operation == "union") {
        return unite(solids, options);
      }
      if (operation == "intersection") {
        return intersect(solids, options);
      }
      const std::span<const Solid> all(solids);
      return subtract(all.front(), all.subspan(1), options);
    });
  });
  module.def("expression_names",
             [](const std::string& expression) { return Expression::parse(expression).names(); });
  module.def(
      "evaluate", [](const std::string& expression, const std::map<std::string, Solid>& operands,
                     const std::string& contacts, const py::object& progress) {
        Interruptible work(progress);
        const BooleanOptions options{contact_policy(contacts), work.progress()};
        return work.run([&] { return evaluate(Expression::parse(expression), operands, options); });
      });
  module.def("repair", [](const TriMesh& mesh, const py::object& progress) {
    Interruptible work(progress);
    Repaired repaired = work.run([&] { return repair(mesh, work.progress()); });
    using namespace py::literals;
    const RepairReport& report = repaired.report;
    return py::make_tuple(repaired.solid, py::dict("merged_points"_a = report.merged_points,
                                                   "degenerate_faces"_a = report.degenerate_faces,
                                                   "duplicate_faces"_a = report.duplicate_faces,
                                                   "turned_faces"_a = report.turned_faces,
                                                   "united_overlaps"_a = report.united_overlaps,
                                                   "parted_contacts"_a = report.parted_contacts,
                                                   "cavities"_a = report.cavities));
  });
}

/// Angles are in degrees. The report is that of a file, which there is none of.
py::tuple remeshed(const Solid& solid, double distance, double size, double angle, double sharp,
                   std::size_t most_points, const py::object& progress) {
  constexpr double kDegree = std::numbers::pi / 180;
  Interruptible work(progress);
  const RemeshOptions options{.distance = distance,
                              .largest_edge = size,
                              .smallest_angle = angle * kDegree,
                              .feature_angle = sharp * kDegree,
                              .most_points = most_points,
                              .progress = work.progress()};
  OutputReport report;
  Solid made = work.run([&] {
    Remeshed result = remesh(solid, options);
    report.solver_mesh =
        SolverMeshReport{std::move(result.report), options.smallest_angle, options.distance, {}};
    return result.solid;
  });
  return py::make_tuple(std::move(made), to_json(report));
}

}  // namespace

ContactPolicy contact_policy(const std::string& name) {
  if (name != "report" && name != "refuse") {
    throw Error(Errc::invalid_argument, "'" + name + "' must be 'report' or 'refuse'", {},
                "contacts");
  }
  return name == "report" ? ContactPolicy::report : ContactPolicy::refuse;
}

void bind_solids(py::module_& module) {
  py::class_<Solid> solid(
      module, "Solid",
      "A solid with exact coordinates: closed, 2-manifold, free of self-intersection. Immutable; "
      "`a + b` unites, `a - b` subtracts, `a & b` intersects, all exactly.");
  refuse_unmade(solid);
  solid.def(py::init<>(), "The empty set.")
      .def_static("_from",
                  [](const TriMesh& mesh) { return unlocked([&] { return Solid::from(mesh); }); })
      .def("__repr__", &solid_text);
  bind_measures(solid);
  bind_arrays(solid);
  bind_operations(solid);
  bind_output(solid);
  bind_combinations(module);
  module.attr("has_mesh_generator") = has_mesh_generator();
  module.def("remesh", &remeshed);
}

}  // namespace dupin::python
