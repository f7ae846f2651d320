#pragma once

#include <string>

#include "dupin/kernel/error.h"

namespace dupin {

/// Error{io_failed} of what the operating system refused, with its reason.
class SystemError : public Error {
 public:
  /// "cannot read the file: No such file or directory", of an errno; `remedy` goes on from there,
  /// if there is any.
  SystemError(const std::string& fault, int reason, const std::string& where,
              const std::string& remedy = {});

  /// The errno.
  [[nodiscard]] int reason() const noexcept { return reason_; }
  /// Its text alone.
  [[nodiscard]] std::string reason_text() const;

 private:
  int reason_;
};

}  // namespace dupin
