#include "cyclide/require_pieces.h"
#include "dupin/blends/part_surface.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin {

MovingRing leaving(const PartSurface& surface, End end) {
  const Chain& chain = std::get<Chain>(surface);
  cyclide::require_pieces(chain);
  const Piece& piece = end == End::start ? chain.pieces.front() : chain.pieces.back();
  return std::visit([end](const auto& p) { return surfaces::leaving(p, end); }, piece);
}

}  // namespace dupin
