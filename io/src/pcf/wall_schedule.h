#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pcf/nominal_pipe.h"

namespace dupin::pcf {

/// "5, 10, 20, ..., STD, XS, XXS": the schedules of ASME B36.10M.
[[nodiscard]] std::string schedule_names();

/// The same of those in which pipes of this size are made.
[[nodiscard]] std::string schedule_names(const NominalPipe& pipe);

/// Whether it is one of them, in any case.
[[nodiscard]] bool is_schedule(std::string_view name);

/// The wall thickness of pipes of this size and schedule in millimetres; none if none are made.
[[nodiscard]] std::optional<double> wall_of(const NominalPipe& pipe, std::string_view schedule);

}  // namespace dupin::pcf
