#pragma once

#include <stdexcept>
#include <string>

#include "dupin/kernel/error.h"

namespace dupin::cli {

/// What the shell sees.
enum class ExitCode {
  ok = 0,
  findings = 1,       ///< it ran, and found faults or gaps
  usage = 2,          ///< the command line makes no sense
  input = 3,          ///< a file that cannot be read, or is not what it should be
  refused = 4,        ///< an operation that has no valid result: blend, contact, rounding
  output = 5,         ///< the result could not be written
  internal = 70,      ///< a bug of ours, or no memory
  interrupted = 130,  ///< by a signal; what was asked for is not there
};

[[nodiscard]] ExitCode exit_code(Errc code);

/// A command line that makes no sense.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An io_failed that came from writing; all others come from reading.
class OutputError : public Error {
 public:
  explicit OutputError(const Error& error) : Error(error) {}
};

/// Runs a function that writes; what the system refuses there is an output error.
template <class Function>
auto writing(const Function& function) {
  try {
    return function();
  } catch (const Error& error) {
    if (error.code() == Errc::io_failed) {
      throw OutputError(error);
    }
    throw;
  }
}

/// The same beside a file that is in its place already, which the message says.
template <class Function>
auto writing_beside(const std::string& written, const Function& function) {
  try {
    return writing(function);
  } catch (const OutputError& error) {
    throw OutputError(Error(error.code(), error.message() + "; " + written + " is written",
                            error.part(), error.where()));
  }
}

}  // namespace dupin::cli
