#pragma once

#include <string>
#include <vector>

#include "dupin/io/pcf.h"
#include "pcf/nominal_pipe.h"

namespace dupin::pcf {

/// Takes the radii of a line's ports, which are halves of the file's bores in its own unit, for
/// what they mean, and notes each bore that is not its own outside diameter.
void give_meaning(PcfFile& file, BoreUnit unit, double millimetres, BoreMeaning meaning);

}  // namespace dupin::pcf
