#pragma once

#include "exchange/exchange_model.h"

/// The module's functions, looked up by `exchange::kEntryPoint`.
extern "C" __attribute__((visibility("default"))) const dupin::exchange::Module*
dupin_occt_module_3();
