#include "binding.h"
#include "dupin/io/system_error.h"
#include "dupin/kernel/error.h"

namespace dupin::python {
namespace {

// Names of files need not be UTF-8: as os.fsdecode has them.
py::object text(std::string_view bytes) {
  PyObject* const decoded =
      PyUnicode_DecodeUTF8(bytes.data(), py::ssize_t(bytes.size()), "surrogateescape");
  if (decoded == nullptr) {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::object>(decoded);
}

void translate(const Error& error) {
  const auto* const refused = dynamic_cast<const SystemError*>(&error);
  const py::object reason =
      refused != nullptr
          ? py::object(py::make_tuple(refused->reason(), text(refused->reason_text())))
          : py::object(py::none());
  const py::object make = py::module_::import("dupin.errors").attr("error_of");
  const py::object value = make(text(name(error.code())), text(error.message()), text(error.part()),
                                text(error.where()), text(error.what()), reason);
  PyErr_SetObject(py::type::of(value).ptr(), value.ptr());
}

}  // namespace

void bind_errors(py::module_& module) {
  py::list codes;
  for (int code = 0; code <= static_cast<int>(Errc::internal); ++code) {
    const std::string_view text = name(static_cast<Errc>(code));
    codes.append(py::str(text.data(), text.size()));
  }
  module.attr("error_codes") = py::tuple(codes);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const Error& error) {
      try {
        translate(error);
      } catch (py::error_already_set& failure) {
        failure.restore();
      }
    }
  });
}

}  // namespace dupin::python
