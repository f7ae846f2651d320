#include <cstring>
#include <utility>

#include <pybind11/stl.h>

#include "binding.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/mesh_gap.h"
#include "dupin/kernel/repair.h"

namespace dupin::python {
namespace {

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[noreturn]] void refuse(const std::string& array, const std::string& what) {
  throw Error(Errc::invalid_argument, what, {}, array);
}

std::string shape_text(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

// That nothing was lost where numbers became doubles.
void refuse_inexact(const py::array& given, const py::array& doubles) {
  const char kind = given.dtype().kind();
  const bool may_be_inexact = kind == 'f' ? given.itemsize() > py::ssize_t(sizeof(double))
                                          : kind != 'b' && given.itemsize() == 8;
  if (!may_be_inexact) {
    return;
  }
  // Integers as Python's, which compare with floats exactly.
  const auto comparable = [&](const py::array& array) -> py::object {
    return kind == 'f' ? py::object(array) : array.attr("astype")("O");
  };
  const py::object here = comparable(given), there = comparable(doubles);
  const py::object same = here.attr("__eq__")(there);
  const py::object is_nan = here.attr("__ne__")(here);
  if (!same.attr("__or__")(is_nan).attr("all")().cast<bool>()) {
    refuse("points", "must be numbers that float64 holds exactly: round them first");
  }
}

py::array array_of(const py::object& object, const std::string& array, py::ssize_t columns,
                   const char* kinds) {
  py::array result = py::array::ensure(object);
  if (!result) {
    PyErr_Clear();
    refuse(array, "must be an array of numbers");
  }
  if (py::hasattr(object, "mask") && py::array(object.attr("mask")).attr("any")().cast<bool>()) {
    refuse(array, "has entries that are masked");
  }
  const bool is_empty = result.size() == 0;
  const bool has_shape =
      columns == 1 ? result.ndim() == 1 : result.ndim() == 2 && result.shape(1) == columns;
  if (!has_shape && !is_empty) {
    refuse(array, "must have the shape " + std::string(columns == 1 ? "(n,)" : "(n, 3)") +
                      ", not " + shape_text(result));
  }
  if (!is_empty && std::strchr(kinds, result.dtype().kind()) == nullptr) {
    refuse(array, "must be " + std::string(std::strchr(kinds, 'f') != nullptr ? "real" : "whole") +
                      " numbers, not " + py::str(result.dtype()).cast<std::string>());
  }
  return result;
}

std::vector<Vec3> points_of(const py::object& object) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const py::array array = array_of(object, "points", 3, "fiub");
  std::vector<Vec3> points(array.size() / 3);
  if (!points.empty()) {
    const Points numbers = Points::ensure(array);  // itself, where its memory is ours
    refuse_inexact(array, numbers);
    std::memcpy(points.front().data(), numbers.data(), points.size() * sizeof(Vec3));
  }
  return points;
}

template <class Whole>
void copy_indices_as(const py::array& array, const std::string& what, std::uint32_t* out) {
  const auto numbers = py::array_t<Whole, py::array::c_style | py::array::forcecast>::ensure(array);
  const Whole* const data = numbers.data();
  for (py::ssize_t i = 0; i < numbers.size(); ++i) {
    if (!std::in_range<std::uint32_t>(data[i])) {
      refuse(what, "must be from 0 to 4294967295, not " + std::to_string(data[i]));
    }
    out[i] = static_cast<std::uint32_t>(data[i]);
  }
}

// Copies whole numbers below 2^32 to `out`.
void copy_indices(const py::array& array, const std::string& what, std::uint32_t* out) {
  if (py::isinstance<py::array_t<std::uint32_t>>(array) &&
      (array.flags() & py::array::c_style) != 0) {
    std::memcpy(out, array.data(), array.nbytes());
    return;
  }
  array.dtype().kind() == 'u' ? copy_indices_as<std::uint64_t>(array, what, out)
                              : copy_indices_as<std::int64_t>(array, what, out);
}

std::vector<Triangle> triangles_of(const py::object& object) {
  static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
  const py::array array = array_of(object, "triangles", 3, "iu");
  std::vector<Triangle> triangles(array.size() / 3);
  if (!triangles.empty()) {
    copy_indices(array, "triangles", triangles.front().data());
  }
  return triangles;
}

std::vector<std::uint32_t> labels_of(const py::object& object) {
  if (object.is_none()) {
    return {};
  }
  const py::array array = array_of(object, "labels", 1, "iu");
  std::vector<std::uint32_t> labels(array.size());
  if (!labels.empty()) {
    copy_indices(array, "labels", labels.data());
  }
  return labels;
}

std::string mesh_text(const TriMesh& mesh) {
  return "Mesh(" + std::to_string(mesh.points.size()) + " points, " +
         std::to_string(mesh.triangles.size()) + " triangles)";
}

void bind_mesh(py::module_& module) {
  py::class_<TriMesh> mesh(module, "Mesh",
                           "Triangles as NumPy arrays, with no promise of any kind: see "
                           "`check` and `Solid`. Unpacks as `points, triangles = mesh`.");
  refuse_unmade(mesh);
  mesh.def(py::init([](const py::object& points, const py::object& triangles,
                       const py::object& labels, std::vector<std::string> names) {
             return mesh_of(points, triangles, labels, std::move(names));
           }),
           py::arg("points"), py::arg("triangles"), py::arg("labels") = py::none(),
           py::arg("names") = std::vector<std::string>(),
           "Points (n, 3), corners (m, 3) counter-clockwise seen from outside, and for each "
           "triangle an index into the names.")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const auto& points = self.cast<const TriMesh&>().points;
            return view(points.empty() ? nullptr : points.front().data(),
                        py::ssize_t(points.size()), 3, self);
          },
          "(n, 3) of float64: a view, not to be written.")
      .def_property_readonly(
          "triangles",
          [](const py::object& self) {
            const auto& triangles = self.cast<const TriMesh&>().triangles;
            return view(triangles.empty() ? nullptr : triangles.front().data(),
                        py::ssize_t(triangles.size()), 3, self);
          },
          "(m, 3) of uint32: a view, not to be written.")
      .def_property_readonly(
          "labels",
          [](const py::object& self) -> py::object {
            const auto& labels = self.cast<const TriMesh&>().labels;
            return labels.empty() ? py::object(py::none())
                                  : view(labels.data(), py::ssize_t(labels.size()), 1, self);
          },
          "(m,) of uint32, indices into names; None if nothing is labelled.")
      .def_property_readonly(
          "names", [](const TriMesh& self) { return self.names; }, "What the labels stand for.")
      .def("__iter__",
           [](const py::object& self) {
             return py::iter(py::make_tuple(self.attr("points"), self.attr("triangles")));
           })
      .def("__repr__", &mesh_text);
}

std::string written(const TriMesh& mesh, const std::string& path, const std::string& format,
                    const std::string& unit) {
  return unlocked([&] {
    const MeshFormat& to = format_named(format, path);
    require_unit(unit);
    write_mesh(path, mesh, to, {unit, {}});
    return to_json(check(to.read(read_file(path), path)));
  });
}

}  // namespace

const MeshFormat& format_named(const std::string& format, const std::string& path) {
  const MeshFormat* const chosen = find_mesh_format(format);
  if (!format.empty() && chosen == nullptr) {
    throw Error(Errc::invalid_argument, "'" + format + "' is no format of meshes", {}, "format");
  }
  return chosen != nullptr ? *chosen : format_of(path);
}

void require_unit(const std::string& unit) {
  std::string known = "um";  // which meshes may have, and documents not
  bool is_known = unit.empty() || unit == known;
  for (const Unit own : {Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch, Unit::foot}) {
    is_known = is_known || unit == symbol(own);
    known += (own == Unit::foot ? " or " : ", ") + std::string(symbol(own));
  }
  if (!is_known) {
    throw Error(Errc::invalid_argument, "must be " + known + ", not '" + unit + "'", {}, "unit");
  }
}

Vec3 vector_of(const py::object& object, const std::string& name) {
  const py::array array = array_of(object, name, 1, "fiub");
  if (array.size() != 3) {
    refuse(name, "must be three numbers, not " + std::to_string(array.size()));
  }
  const Points numbers = Points::ensure(array);
  return {numbers.data()[0], numbers.data()[1], numbers.data()[2]};
}

TriMesh mesh_of(const py::object& points, const py::object& triangles, const py::object& labels,
                std::vector<std::string> names) {
  TriMesh mesh{points_of(points), triangles_of(triangles), labels_of(labels), std::move(names)};
  if (!mesh.labels.empty() && mesh.labels.size() != mesh.triangles.size()) {
    refuse("labels", "must be one for each of the " + std::to_string(mesh.triangles.size()) +
                         " triangles, not " + std::to_string(mesh.labels.size()));
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= mesh.points.size()) {
        refuse("triangles", "has the index " + std::to_string(corner) + ", but there are only " +
                                std::to_string(mesh.points.size()) + " points");
      }
    }
  }
  return mesh;
}

void bind_meshes(py::module_& module) {
  bind_mesh(module);
  py::list formats;
  for (const MeshFormat& format : mesh_formats()) {
    formats.append(py::str(format.key.data(), format.key.size()));
  }
  module.attr("mesh_formats") = py::tuple(formats);
  module.def("read_mesh", [](const std::string& path) {
    return unlocked([&] { return read_mesh(std::filesystem::path(path)); });
  });
  module.def("mesh_unit", [](const std::string& path) {
    return unlocked([&] { return mesh_unit(read_file(path), path); });
  });
  module.def("write_mesh", &written);
  module.def("check", [](const TriMesh& mesh, std::size_t limit, bool self_intersections) {
    return unlocked([&] {
      return to_json(check(mesh, {.limit = limit, .self_intersections = self_intersections}));
    });
  });
  module.def("mesh_gaps", [](const TriMesh& a, const TriMesh& b, double connect) {
    return unlocked([&] {
      return to_json(MeshGapSummary{{}, {}, connect, measure_gaps(a, b, {.connect = connect})});
    });
  });
}

}  // namespace dupin::python
