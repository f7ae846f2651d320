#include "dupin/io/system_error.h"

#include <system_error>

namespace dupin {

SystemError::SystemError(const std::string& fault, int reason, const std::string& where,
                         const std::string& remedy)
    : Error(Errc::io_failed, fault + ": " + std::generic_category().message(reason) + remedy, {},
            where),
      reason_(reason) {}

std::string SystemError::reason_text() const { return std::generic_category().message(reason_); }

}  // namespace dupin
