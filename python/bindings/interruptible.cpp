#include <chrono>
#include <memory>

#include "binding.h"

namespace dupin::python {
namespace {

constexpr double kInterval = 0.05;  // seconds between looks at signals

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Interruptible::Interruptible(const py::object& callback) : callback_(callback) {}

Progress Interruptible::progress() {
  return [this](std::string_view stage, double fraction) {
    if (callback_.is_none() && now() < next_) {
      return true;
    }
    next_ = now() + kInterval;
    const py::gil_scoped_acquire locked;
    return call(stage, fraction);
  };
}

// Nothing is thrown through the library: it is kept until that has been left.
bool Interruptible::call(std::string_view stage, double fraction) {
  try {
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
    if (callback_.is_none()) {
      return true;
    }
    const py::object answer = callback_(py::str(stage.data(), stage.size()), fraction);
    if (answer.is_none()) {
      return true;
    }
    const int is_true = PyObject_IsTrue(answer.ptr());
    if (is_true < 0) {
      throw py::error_already_set();
    }
    return is_true != 0;
  } catch (const py::error_already_set& error) {
    thrown_ = [error] { throw error; };
    return false;
  }
}

void Interruptible::rethrow(const Error& error) {
  if (error.code() == Errc::cancelled && thrown_) {
    std::exchange(thrown_, {})();
  }
}

}  // namespace dupin::python
