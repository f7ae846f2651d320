#include "dupin/blends/cyclide_piece.h"

namespace dupin {

CyclidePiece cyclide_piece(const PeArc& arc) {
  return {flipped(circle_at(arc, 0)), circle_at(arc, 1), arc.start(),
          arc.start_tangent(),        arc.end(),         arc.chord()};
}

PeArc arc_of(const CyclidePiece& piece) {
  return PeArc::from(piece.first, piece.tangent, piece.last);
}

}  // namespace dupin
