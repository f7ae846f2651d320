#pragma once

#include <optional>
#include <string_view>

namespace dupin::json {

/// Of a flange, in millimetres.
struct FlangeSize {
  double inches;              ///< NPS
  double outside, thickness;  ///< the diameter, and the least thickness of the flange
};

/// The welding neck flange of ASME B16.5 of this size and class, "150" or "300"; none if it is not
/// in its table here.
[[nodiscard]] std::optional<FlangeSize> flange_of(double inches, std::string_view pressure_class);

}  // namespace dupin::json
