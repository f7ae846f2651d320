#pragma once

#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"

namespace dupin {

/// What a built solid is a mesh of, in smooth surfaces: the whole; of the metal, the whole less the
/// bore; of the fluid, what the whole and the bore have in common. `kept` is taken away from the
/// bore before. Bores reach out of open ends, where they cut clean rims.
struct SmoothRegion {
  Region region = Region::outer;
  ResolvedAssembly whole, bore, kept;
};

/// That of `built`, which `build` made of the assembly.
[[nodiscard]] SmoothRegion smooth_region(const Assembly& assembly, const Built& built);

}  // namespace dupin
