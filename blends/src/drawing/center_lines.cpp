#include "drawing/center_lines.h"

#include <functional>

#include "drawing/polyline.h"
#include "dupin/blends/cyclide_piece.h"

namespace dupin::drawing {
namespace {

using Center = std::function<Vec3(double)>;

struct CenterOf {
  Center operator()(const RingedSurface& tube) const {
    return [&](double t) { return evaluate(tube.spine, t).position; };
  }
  Center operator()(const EllipticTube& tube) const {
    return [&](double t) { return evaluate(tube.spine, t).position; };
  }
  Center operator()(const RationalRingedTube& tube) const {
    return [&](double t) { return ring_at(tube.surface, t).center; };
  }
  Center operator()(const CyclidePiece& piece) const {
    return [arc = arc_of(piece)](double t) { return circle_at(arc, t).center; };
  }
};

// Halved until the middles are within the tolerance.
std::vector<Vec3> sampled(const Center& center, double tolerance) {
  constexpr int kMost = 256;
  for (int count = 1;; count *= 2) {
    std::vector<Vec3> line;
    for (int i = 0; i <= count; ++i) {
      line.push_back(center(double(i) / count));
    }
    bool is_fine = true;
    for (int i = 0; i < count; ++i) {
      for (const double part : {0.25, 0.5, 0.75}) {
        is_fine = is_fine && distance_from_segment(center((i + part) / count), line[std::size_t(i)],
                                                   line[std::size_t(i) + 1]) <= tolerance;
      }
    }
    if (is_fine || count >= kMost) {
      return line;
    }
  }
}

PartAxis axis_of(const ResolvedPart& part, double tolerance) {
  PartAxis axis{part.name, {}, {}};
  if (const auto* ball = std::get_if<Sphere>(&part.shape)) {
    axis.line = {ball->center};
    axis.diameters = {2 * ball->radius};
    return axis;
  }
  const auto& chain = std::get<Chain>(part.shape);
  for (const Piece& piece : chain.pieces) {
    const auto line = sampled(std::visit(CenterOf{}, piece), tolerance);
    axis.line.insert(axis.line.end(), line.begin() + (axis.line.empty() ? 0 : 1), line.end());
  }
  if (!chain.pieces.empty()) {
    axis.diameters = {2 * end_ring(chain, End::start).radius, 2 * end_ring(chain, End::end).radius};
  }
  return axis;
}

}  // namespace

std::vector<PartAxis> axes_of(const ResolvedAssembly& assembly, double tolerance) {
  std::vector<PartAxis> result;
  for (const ResolvedPart& part : assembly.parts) {
    PartAxis axis = axis_of(part, tolerance);
    if (!axis.line.empty()) {
      result.push_back(std::move(axis));
    }
  }
  return result;
}

}  // namespace dupin::drawing
