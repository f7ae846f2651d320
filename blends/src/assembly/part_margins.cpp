#include "assembly/part_margins.h"

#include <algorithm>
#include <cmath>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/surface_piece.h"

namespace dupin::assembly {
namespace {

// Where the spine may stop there is no lower bound.
[[noreturn]] void refuse(const surfaces::MarginBounds& bounds) {
  const double margin = bounds.upper && *bounds.upper <= 0 ? *bounds.upper : bounds.lower;
  throw Error(Errc::irregular_surface,
              std::isfinite(margin)
                  ? "the surface folds: the margin 1 - kappa R is " + decimal(margin) +
                        " where it must be positive; use a smaller radius or a larger bend radius"
                  : "the surface folds: its spine stops and turns round on the spot; choose other "
                    "ends or points");
}

std::optional<double> tangency(const Chain& chain, End end) {
  const Piece& piece = end == End::start ? chain.pieces.front() : chain.pieces.back();
  return std::visit([end](const auto& p) { return surfaces::tangency(p, end); }, piece);
}

struct Margins {
  bool with_tangency;

  PartMargins operator()(const Sphere&) const { return {}; }

  PartMargins operator()(const Chain& chain) const {
    PartMargins result;
    for (const Piece& piece : chain.pieces) {
      const surfaces::MarginBounds here =
          std::visit([](const auto& p) { return surfaces::margin_bounds(p); }, piece);
      if (!here.regular) {
        refuse(here);
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

PartMargins margins(const PartSurface& surface, bool with_tangency) {
  return std::visit(Margins{with_tangency}, surface);
}

}  // namespace dupin::assembly
