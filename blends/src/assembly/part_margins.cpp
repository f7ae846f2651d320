#include "assembly/part_margins.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::assembly {
namespace {

// What parts of the kind have, by which they may bend less for their radius.
std::string what_would_do(std::string_view kind) {
  return kind == "elbow"            ? "; use a smaller radius or a larger bend radius"
         : kind == "two_cone_blend" ? "; smaller radii, another reach or other weights may do"
         : kind == "spline"         ? "; smaller radii or points further apart may do"
         : kind.ends_with("_blend") ? "; smaller radii or other lengths k and l may do"
                                    : "; smaller radii may do";
}

// Where the spine may stop there is no lower bound.
[[noreturn]] void refuse(const surfaces::MarginBounds& bounds, std::string_view kind) {
  if (bounds.upper && *bounds.upper <= 0) {
    throw Error(Errc::irregular_surface, "the surface folds: the margin 1 - kappa R is at most " +
                                             decimal_at_most(*bounds.upper) +
                                             " where it must be positive" + what_would_do(kind));
  }
  if (!std::isfinite(bounds.lower)) {
    throw Error(
        Errc::irregular_surface,
        "the surface may fold: its spine stops, or is not known to go on, where it may turn "
        "round on the spot; choose other ends or points");
  }
  throw Error(Errc::irregular_surface,
              "whether the surface folds is undecided: of the margin 1 - kappa R, which must be "
              "positive, is proved only that it is at least " +
                  decimal_at_least(bounds.lower) +
                  (bounds.upper ? " and at most " + decimal_at_most(*bounds.upper) : "") +
                  what_would_do(kind));
}

std::optional<double> tangency(const Chain& chain, End end) {
  const Piece& piece = end == End::start ? chain.pieces.front() : chain.pieces.back();
  return std::visit([end](const auto& p) { return surfaces::tangency(p, end); }, piece);
}

struct Margins {
  bool with_tangency;
  std::string_view kind;

  PartMargins operator()(const Sphere&) const { return {}; }

  PartMargins operator()(const Chain& chain) const {
    PartMargins result;
    for (const Piece& piece : chain.pieces) {
      const surfaces::MarginBounds here =
          std::visit([](const auto& p) { return surfaces::margin_bounds(p); }, piece);
      if (!here.regular) {
        refuse(here, kind);
      }
      const bool is_first = &piece == &chain.pieces.front();
      result.margin_lower = is_first ? here.lower : std::min(*result.margin_lower, here.lower);
      result.margin_upper = is_first ? here.upper : std::min(result.margin_upper, here.upper);
    }
    if (with_tangency && !chain.closed) {
      result.start_tangency = tangency(chain, End::start);
      result.end_tangency = tangency(chain, End::end);
    }
    return result;
  }
};

}  // namespace

PartMargins margins(const PartSurface& surface, bool with_tangency, std::string_view kind) {
  return std::visit(Margins{with_tangency, kind}, surface);
}

namespace {

// Of a torus segment that does not cross itself: what lies nearest to itself, about the axis or
// where more than half a turn comes round to where it began.
std::string what_is_near(const RingedSurface& torus) {
  const auto& arc = std::get<ArcSpine>(torus.spine);
  const double to_axis =
      (arc.start - arc.center).norm() - std::get<ConstantRadius>(torus.radius).radius;
  const double open = std::max(2 * std::numbers::pi - arc.angle, 0.0);
  const double between_ends = 2 * std::sin(std::min(open, std::numbers::pi) / 2) * to_axis;
  return between_ends < to_axis
             ? "its ends come within " + decimal_at_most(between_ends) +
                   " of each other, too near for these coordinates; use a smaller angle"
             : "it comes within " + decimal_at_most(to_axis) +
                   " of its axis, too near for these coordinates; use a larger bend radius";
}

}  // namespace

void refuse_mesh(const PartSurface& surface, const Error& reason) {
  const auto* chain = std::get_if<Chain>(&surface);
  const bool has_one_piece = chain != nullptr && chain->pieces.size() == 1;
  const auto* torus = has_one_piece ? std::get_if<RingedSurface>(&chain->pieces.front()) : nullptr;
  const bool is_of_cyclides = chain != nullptr && !chain->pieces.empty() &&
                              std::holds_alternative<CyclidePiece>(chain->pieces.front());
  // Behind the last semicolon is what would help a mesh that somebody made.
  const std::string fault = reason.message().substr(0, reason.message().rfind("; "));
  throw Error(Errc::irregular_surface,
              "the part's mesh is no solid: " + fault +
                  (torus != nullptr && surfaces::is_embedded_torus(*torus)
                       ? "; the surface does not cross itself, but " + what_is_near(*torus)
                       : "; whether the surface crosses itself, or only comes too close, is "
                         "undecided, and 'certify' may tell; choose a smaller tolerance, or " +
                             std::string(is_of_cyclides ? "other spheres or tangents"
                                                        : "other ends, end speeds or radii")));
}

}  // namespace dupin::assembly
