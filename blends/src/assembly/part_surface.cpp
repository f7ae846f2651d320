#include "dupin/blends/part_surface.h"

namespace dupin {
namespace {

const Ring* ring_of(const Sphere&, PartEnd) { return nullptr; }

const Ring* ring_of(const CyclideTube& tube, PartEnd end) {
  if (tube.wall > 0) {
    return nullptr;
  }
  return end == PartEnd::start ? &tube.start : &tube.end;
}

const Ring* ring_of(const SplinePipe& pipe, PartEnd end) {
  if (pipe.closed) {
    return nullptr;
  }
  return end == PartEnd::start ? &pipe.pieces.front().start : &pipe.pieces.back().end;
}

template <class Tube>
const Ring* ring_of(const Tube& tube, PartEnd end) {
  return end == PartEnd::start ? &tube.start : &tube.end;
}

}  // namespace

const Ring* port_ring(const PartSurface& surface, PartEnd end) {
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
