#pragma once

#include <optional>
#include <string_view>

#include "assembly/part_context.h"

namespace dupin::assembly {

/// The keys under which a document has a section's numbers.
struct SectionKeys {
  std::string_view radius, first, across;
};
inline constexpr SectionKeys kSection{"radius", "semi_axes/0", "semi_axes/1"};

/// The axis of an ellipse in the planes across `normal`, from the direction under "axis", which
/// need not be so.
[[nodiscard]] Vec3 axis_across(const PartContext& context, const Vec3& normal,
                               const Vec3& direction);

/// The ring, against the direction of travel, at `from` of a part that leads straight to `to`.
[[nodiscard]] Ring start_between(const PartContext& context, const Vec3& from, const Vec3& to,
                                 double radius, const std::optional<SectionAxes>& axes,
                                 const SectionKeys& keys);

/// The ring, against the direction of travel, of a part that begins at a port or a place.
[[nodiscard]] Ring origin(const PartContext& context, const PartStart& from,
                          const SectionKeys& keys);

}  // namespace dupin::assembly
