#include "dupin/blends/part_surface.h"

#include "cyclide/require_pieces.h"
#include "dupin/blends/pe_arc.h"

namespace dupin {
namespace {

const Piece& end_piece(const Chain& chain, End end) {
  cyclide::require_pieces(chain);
  return end == End::start ? chain.pieces.front() : chain.pieces.back();
}

}  // namespace

const Ring& end_ring(const Piece& piece, End end) {
  return std::visit([end](const auto& p) -> const Ring& { return end_ring(p, end); }, piece);
}

const Ring& end_ring(const Chain& chain, End end) { return end_ring(end_piece(chain, end), end); }

const Ring* port_ring(const PartSurface& surface, End end) {
  const auto* chain = std::get_if<Chain>(&surface);
  const bool has_ports =
      chain != nullptr && !chain->pieces.empty() && !chain->closed && chain->wall == 0;
  return has_ports ? &end_ring(*chain, end) : nullptr;
}

std::vector<PeArc> cyclide_pieces(const Chain& chain) {
  std::vector<PeArc> result;
  for (const Piece& piece : chain.pieces) {
    if (const auto* cyclide = std::get_if<CyclidePiece>(&piece)) {
      result.push_back(arc_of(*cyclide));
    }
  }
  return result;
}

std::vector<PeArc> cyclide_pieces(const PartSurface& surface) {
  const auto* chain = std::get_if<Chain>(&surface);
  return chain == nullptr ? std::vector<PeArc>() : cyclide_pieces(*chain);
}

}  // namespace dupin
