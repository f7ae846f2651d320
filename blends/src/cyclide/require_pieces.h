#pragma once

#include "dupin/kernel/error.h"

namespace dupin::cyclide {

/// Throws Error{invalid_argument} for a chain, of whatever kind, without pieces.
template <class AnyChain>
void require_pieces(const AnyChain& chain) {
  if (chain.pieces.empty()) {
    throw Error(Errc::invalid_argument, "a chain needs at least one piece");
  }
}

}  // namespace dupin::cyclide
