#pragma once

#include <string>
#include <string_view>

#include "assembly/parts/part_kind.h"

namespace dupin::assembly {

/// The axis of a straight part, from its start.
struct RunAxis {
  Vec3 from = Vec3::Zero(), direction = Vec3::UnitZ();  ///< unit, towards its end
  double length = 0;
};

/// That of the part named under `key`, which the shape's kind must say that it needs. Fails for
/// parts that are not straight.
[[nodiscard]] RunAxis run_axis(const PartContext& context, const std::string& name,
                               std::string_view key);

/// The point `at` along it. Fails where that is not on the part.
[[nodiscard]] Vec3 point_on_run(const PartContext& context, const RunAxis& run, double at);

}  // namespace dupin::assembly
