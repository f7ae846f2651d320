#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dupin/blends/junction.h"

namespace dupin::junction {

/// An end on its way to the hub.
struct Approach {
  Ring end;
  PeVector sphere, tangent;  ///< of the cone along the end
};

[[nodiscard]] std::vector<Approach> approaches_of(std::span<const Ring> ends);

/// The point nearest to the ends' axes; where these are parallel, level with the ends' middle.
[[nodiscard]] Vec3 nearest_to_axes(std::span<const Approach> ends);

/// The arms to a hub, each beginning after the given way along its cone. Throws Error as
/// PeArc::from does.
[[nodiscard]] Junction arms_to(const Sphere& hub, std::span<const Approach> ends,
                               std::span<const double> ways);

/// Hubs about this centre.
[[nodiscard]] JunctionSearch search_hub(std::span<const Approach> ends, const Vec3& center,
                                        const JunctionOptions& options);

/// The same, without telling why there is none.
[[nodiscard]] std::optional<Junction> find_hub(std::span<const Approach> ends, const Vec3& center,
                                               const JunctionOptions& options);

}  // namespace dupin::junction
