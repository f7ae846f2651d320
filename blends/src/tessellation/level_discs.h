#pragma once

#include <span>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/ring.h"

namespace dupin::tessellation {

struct SampledRing {
  Ring ring;
  RingSampling sampling;
  std::string name = {};  ///< of what lies within, for the caller
};

/// Of circles about one centre in one plane, ascending: the disc's own, and those within it, from
/// the largest, with the disc's normal. Those that come too near to the next one's polygon are left
/// out.
[[nodiscard]] std::vector<SampledRing> nested_rings(const SampledRing& disc,
                                                    std::span<const SampledRing> within);

/// Appends the annulus between two of them, the same bitwise where both are flipped.
void append_annulus(TriMesh& mesh, const SampledRing& inner, const SampledRing& outer);

}  // namespace dupin::tessellation
