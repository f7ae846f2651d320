#include "binding.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The bindings; use the package dupin.";
  module.attr("__version__") = DUPIN_VERSION;
  dupin::python::bind_errors(module);
  dupin::python::bind_meshes(module);
  dupin::python::bind_solids(module);
  dupin::python::bind_documents(module);
}
