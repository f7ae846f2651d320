#pragma once

#include <string>
#include <vector>

#include "drawing/zero_lines.h"

namespace dupin::drawing {

/// The contours of one part's surface.
struct PartContours {
  std::string part;
  std::vector<ZeroLine> curves;
};

/// Of one surface; `towards` is a unit vector. See dupin::contours.
[[nodiscard]] std::vector<ZeroLine> contours_of(const PartSurface& surface, const Vec3& towards,
                                                double tolerance);

/// Of all parts, fillets and hubs, by name. Bores have their outward
/// normals where the metal is not.
[[nodiscard]] std::vector<PartContours> contours_of(const ResolvedAssembly& assembly,
                                                    const Vec3& towards, double tolerance,
                                                    bool are_bores);

}  // namespace dupin::drawing
