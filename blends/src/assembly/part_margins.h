#pragma once

#include <optional>
#include <string_view>

#include "dupin/blends/part_surface.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {

/// What is proven of a part's smooth surface; see PartReport.
struct PartMargins {
  std::optional<double> margin_lower, margin_upper;
  std::optional<double> start_tangency, end_tangency;
};

/// The least margin of all pieces and, of open chains that are asked to be tangent to their
/// neighbours, how far they are from it. Throws Error{irregular_surface} for a surface that is not
/// proven to be free of folds, with what parts of this kind (ResolvedPart::kind) can do about it.
[[nodiscard]] PartMargins margins(const PartSurface& surface, bool with_tangency,
                                  std::string_view kind);

/// Throws Error{irregular_surface} for a part whose mesh is no solid, for the reason given: what
/// that says of the surface.
[[noreturn]] void refuse_mesh(const PartSurface& surface, const Error& reason);

}  // namespace dupin::assembly
