#pragma once

#include "assembly/part_context.h"
#include "dupin/blends/part_surface.h"

namespace dupin::assembly {

/// The geometry of a chain in an assembly. Throws as resolve() does; faults of a piece are laid at
/// the sphere it leads to.
[[nodiscard]] PartSurface cyclide_chain(const PartContext& context,
                                        const CyclideChainThrough& chain);

}  // namespace dupin::assembly
