#include "assembly/part_margins.h"

#include <algorithm>
#include <cmath>

#include "dupin/blends/regularity.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/tangency.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

[[noreturn]] void refuse(double margin) {
  throw Error(Errc::irregular_surface,
              std::isfinite(margin)
                  ? "the surface folds: the margin 1 - kappa R is " + decimal(margin) +
                        " where it must be positive; use a smaller radius or a larger bend radius"
                  : "the surface folds: its spine stops and turns round on the spot; choose other "
                    "ends or points");
}

class Claims {
 public:
  explicit Claims(bool is_blend) : is_blend_(is_blend) {}

  PartMargins operator()(const Sphere&) const { return {}; }

  PartMargins operator()(const RingedSurface& surface) const {
    const Regularity margin = regularity(surface);
    if (!(margin.lower > 0)) {
      refuse(margin.upper);
    }
    PartMargins result{margin.lower, margin.upper, {}, {}};
    if (is_blend_) {
      result.start_tangency = tangency_at_end(surface, SurfaceEnd::start).deviation.upper;
      result.end_tangency = tangency_at_end(surface, SurfaceEnd::end).deviation.upper;
    }
    return result;
  }

  PartMargins operator()(const EllipticTube& tube) const {
    PartMargins result{certified_margin(tube), {}, {}, {}};
    if (!(*result.margin_lower > 0)) {
      refuse(*result.margin_lower);
    }
    if (is_blend_) {
      result.start_tangency = tangency_bound(tube, SurfaceEnd::start);
      result.end_tangency = tangency_bound(tube, SurfaceEnd::end);
    }
    return result;
  }

  // PeArc proved regularity when it was made, exactly.
  PartMargins operator()(const CyclideTube& tube) const {
    const Enclosure bounds = margin(tube);
    PartMargins result{bounds.lower, bounds.upper, {}, {}};
    if (is_blend_) {
      result.start_tangency = tangency_bound(tube, SurfaceEnd::start);
      result.end_tangency = tangency_bound(tube, SurfaceEnd::end);
    }
    return result;
  }

  PartMargins operator()(const KneecapChain& chain) const {
    const Enclosure bounds = margin(chain);
    return {bounds.lower, bounds.upper, {}, {}};
  }

  PartMargins operator()(const RationalRingedTube& tube) const {
    return {certified_margin(tube.surface), {}, {}, {}};
  }

  PartMargins operator()(const SplinePipe& pipe) const {
    PartMargins result;
    for (const RingedSurface& piece : pipe.pieces) {
      const PartMargins here = (*this)(piece);
      const auto least = [](const std::optional<double>& a, const std::optional<double>& b) {
        return a ? std::min(a, b) : b;
      };
      result.margin_lower = least(result.margin_lower, here.margin_lower);
      result.margin_upper = least(result.margin_upper, here.margin_upper);
    }
    if (!pipe.closed) {
      result.start_tangency =
          tangency_at_end(pipe.pieces.front(), SurfaceEnd::start).deviation.upper;
      result.end_tangency = tangency_at_end(pipe.pieces.back(), SurfaceEnd::end).deviation.upper;
    }
    return result;
  }

 private:
  bool is_blend_;
};

}  // namespace

PartMargins margins(const ResolvedPart& part) {
  return std::visit(Claims(part.is_blend), part.shape);
}

}  // namespace dupin::assembly
