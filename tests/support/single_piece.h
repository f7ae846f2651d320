#pragma once

#include <variant>

#include "dupin/blends/part_surface.h"

namespace dupin::test {

/// The piece of a part that is a chain of one piece of this kind.
template <class Kind>
const Kind& single_piece(const PartSurface& surface) {
  return std::get<Kind>(std::get<Chain>(surface).pieces.at(0));
}

}  // namespace dupin::test
