#include "drawing/sheet.h"

#include <memory>
#include <numbers>
#include <variant>

#include "dupin/blends/frame.h"

namespace dupin::drawing {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::uint32_t kAround = 32, kAlong = 32;

SheetPoint of_surface(const SurfacePoint& point) { return {point.position, point.normal}; }

bool is_ruled(const Spine& spine, const RadiusLaw& law) {
  return std::holds_alternative<LineSpine>(spine) && is_linear(law);
}

struct SheetOf {
  Sheet operator()(const RingedSurface& tube) const {
    const auto field = std::make_shared<FrameField>(tube.spine, reference_axis(tube.start));
    return {[&tube, field](double t, double v) {
              return of_surface(evaluate(tube, *field, t, kTurn * v));
            },
            is_ruled(tube.spine, tube.radius) ? 1 : kAlong, kAround};
  }
  Sheet operator()(const EllipticTube& tube) const {
    const auto field = std::make_shared<FrameField>(frames(tube));
    const bool is_straight =
        is_ruled(tube.spine, tube.first) && is_ruled(tube.spine, tube.second) && tube.turn == 0;
    return {[&tube, field](double t, double v) {
              return of_surface(evaluate(tube, *field, t, kTurn * v));
            },
            is_straight ? 1 : kAlong, kAround};
  }
  Sheet operator()(const CyclidePiece& piece) const {
    return {[arc = arc_of(piece)](double t, double v) { return point_at(arc, t, kTurn * v); },
            kAlong, kAround};
  }
  Sheet operator()(const RationalRingedTube& tube) const {
    return {
        [&tube](double t, double v) { return of_surface(evaluate(tube.surface, t, kTurn * v)); },
        kAlong, kAround};
  }
};

}  // namespace

Sheet sheet_of(const Piece& piece) { return std::visit(SheetOf{}, piece); }

std::vector<Sheet> sheets_of(const Chain& chain) {
  std::vector<Sheet> result;
  result.reserve(chain.pieces.size());
  for (const Piece& piece : chain.pieces) {
    result.push_back(sheet_of(piece));
  }
  return result;
}

std::vector<Sheet> sheets_of(const Fillet& fillet) {
  std::vector<Sheet> result;
  if (fillet.is_cope()) {
    return result;
  }
  result.reserve(fillet.loops.size());
  for (const CanalFillet& loop : fillet.loops) {
    result.push_back({[&loop](double t, double v) {
                        const MovingBall moving = ball(loop, kTurn * (t - 0.5));
                        const ContactArc arc = contact_arc(loop.quadrics, moving);
                        const Vec3 position = point(arc, arc.angle * v);
                        return SheetPoint{position, (moving.center - position).normalized()};
                      },
                      2 * kAlong, kAround / 4, false});
  }
  return result;
}

}  // namespace dupin::drawing
