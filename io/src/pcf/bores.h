#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dupin/io/pcf.h"
#include "pcf/nominal_pipe.h"

namespace dupin::pcf {

/// Takes the radii of a line's ports, which are halves of the file's bores in its own unit, for
/// what they mean, and notes each bore that is not its own outside diameter. Components with radii
/// of their own, one for each component, do not use theirs.
void give_meaning(PcfFile& file, BoreUnit unit, double millimetres, BoreMeaning meaning,
                  std::span<const std::optional<double>> own_radii = {});

}  // namespace dupin::pcf
