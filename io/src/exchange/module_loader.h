#pragma once

#include "exchange/exchange_model.h"

namespace dupin::exchange {

/// The module, loaded when it is first asked for; none if it is not there. It is looked for where
/// the program's libraries are. What `why` points to says what the system says.
[[nodiscard]] const Module* find_module(std::string* why = nullptr);

/// The same. Throws Error{invalid_argument} that says what to install.
[[nodiscard]] const Module& loaded_module();

}  // namespace dupin::exchange
