#pragma once

#include <functional>

#include "dupin/blends/assembly.h"
#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// One part of an assembly whose neighbours are resolved.
struct PartContext {
  const Assembly& assembly;
  std::uint32_t index = 0;
  /// The ring of another part's port, its normal pointing out of that part.
  std::function<const Ring&(const PortReference&)> ring;
  /// How that ring moves out of that part, at unit speed.
  std::function<MovingRing(const PortReference&)> motion;
};

/// The geometry of a part that is not a cap. Throws as resolve() does.
[[nodiscard]] PartSurface geometry(const PartContext& context);

[[nodiscard]] RationalRingedTube ringed_blend_part(const PartContext& context,
                                                   const RingedBlendBetween& blend);

}  // namespace dupin::assembly
