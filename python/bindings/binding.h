#pragma once

#include <functional>
#include <string>
#include <typeinfo>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "dupin/io/mesh_format.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"

/// The extension module dupin._core. The package around it (python/dupin) makes of files, dicts and
/// other libraries' meshes what these functions take, and of JSON what users see.
namespace dupin::python {

namespace py = pybind11;

// Each adds what its name says to the module.
void bind_errors(py::module_& module);
void bind_meshes(py::module_& module);
void bind_solids(py::module_& module);
void bind_documents(py::module_& module);

/// Points (n, 3) of any real numbers and triangles (m, 3) of any whole numbers; arrays that lie in
/// memory as ours do are not converted, only copied. Throws Error{invalid_argument} naming the
/// array that has another shape or kind.
[[nodiscard]] TriMesh mesh_of(const py::object& points, const py::object& triangles,
                              const py::object& labels, std::vector<std::string> names);

/// Three real numbers. Throws Error{invalid_argument} naming the argument for others.
[[nodiscard]] Vec3 vector_of(const py::object& object, const std::string& name);

/// "report" or "refuse". Throws Error{invalid_argument} for others.
[[nodiscard]] ContactPolicy contact_policy(const std::string& name);

/// The format that is named or, if none is, that of the path's extension. Throws
/// Error{invalid_argument} for others.
[[nodiscard]] const MeshFormat& format_named(const std::string& format, const std::string& path);

/// Throws Error{invalid_argument} for what is no unit, unless nothing.
void require_unit(const std::string& unit);

/// A view of memory that `owner` keeps alive, not to be written.
template <class Number>
[[nodiscard]] py::array view(const Number* data, py::ssize_t rows, py::ssize_t columns,
                             const py::object& owner) {
  py::array_t<Number> array = columns == 1 ? py::array_t<Number>({rows}, data, owner)
                                           : py::array_t<Number>({rows, columns}, data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// An object that __new__ has made, and no __init__, holds nothing: its use is a TypeError.
/// pybind11 would give it memory in which nobody made a value. For this no argument may be a
/// holder.
template <class Value>
void refuse_unmade(const py::class_<Value>& kind) {
  static const std::string name = kind.attr("__name__").template cast<std::string>();
  py::detail::get_type_info(typeid(Value))->operator_new = [](std::size_t) -> void* {
    throw py::type_error("this " + name + " holds nothing: its __init__ was not called");
  };
}

/// Lets other threads run while a long operation does, and lets Ctrl-C and the caller's own
/// callback, `progress(stage, fraction)` or None, end it.
class Interruptible {
 public:
  explicit Interruptible(const py::object& callback);

  /// What the operation is to be given.
  [[nodiscard]] Progress progress();

  /// Runs it without Python's lock. What the callback has thrown comes out.
  template <class Operation>
  auto run(const Operation& operation) {
    try {
      const py::gil_scoped_release unlocked;
      return operation();
    } catch (const Error& error) {
      rethrow(error);
      throw;
    }
  }

 private:
  bool call(std::string_view stage, double fraction);
  void rethrow(const Error& error);

  py::object callback_;
  std::function<void()> thrown_;
  double next_ = 0;
};

/// For what has no progress to tell.
template <class Operation>
auto unlocked(const Operation& operation) {
  const py::gil_scoped_release release;
  return operation();
}

}  // namespace dupin::python
