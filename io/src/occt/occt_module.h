#pragma once

#include "exchange/exchange_model.h"

/// The module's functions, looked up by `exchange::kEntryPoint`.
extern "C" const dupin::exchange::Module* dupin_occt_module_1();
