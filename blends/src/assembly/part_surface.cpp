#include "dupin/blends/part_surface.h"

namespace dupin {
namespace {

const Ring* ring_of(const Sphere&, End) { return nullptr; }

const Ring* ring_of(const CyclideTube& tube, End end) {
  if (tube.wall > 0) {
    return nullptr;
  }
  return end == End::start ? &tube.start : &tube.end;
}

const Ring* ring_of(const SplinePipe& pipe, End end) {
  if (pipe.closed) {
    return nullptr;
  }
  return end == End::start ? &pipe.pieces.front().start : &pipe.pieces.back().end;
}

template <class Tube>
const Ring* ring_of(const Tube& tube, End end) {
  return end == End::start ? &tube.start : &tube.end;
}

}  // namespace

const Ring* port_ring(const PartSurface& surface, End end) {
  return std::visit([end](const auto& shape) { return ring_of(shape, end); }, surface);
}

std::vector<PeArc> cyclide_pieces(const PartSurface& surface) {
  if (const auto* tube = std::get_if<CyclideTube>(&surface)) {
    return tube->chain.pieces;
  }
  const auto* chain = std::get_if<KneecapChain>(&surface);
  return chain == nullptr ? std::vector<PeArc>() : chain->pieces;
}

}  // namespace dupin
