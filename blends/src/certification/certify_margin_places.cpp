#include <cmath>
#include <limits>
#include <optional>

#include "dupin/blends/certify.h"
#include "dupin/blends/resolve.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin {
namespace {

constexpr int kStretches = 32;

// The least margin seen so far, and where.
struct Least {
  double margin = std::numeric_limits<double>::infinity();
  MarginPlace place;
};

void include(const Piece& piece, std::size_t index, Least& least) {
  const surfaces::PieceDiscs discs =
      std::visit([](const auto& p) { return surfaces::discs(p); }, piece);
  for (int i = 0; i < kStretches; ++i) {
    const double from = double(i) / kStretches, to = double(i + 1) / kStretches;
    const auto pace = discs.pace({from, to});
    const bool is_known = pace && pace->advance > 0;  // a disc may rest at an end
    const double margin = is_known ? surfaces::margin_of(pace) : least.margin;
    if (margin < least.margin) {
      const double middle = (from + to) / 2;
      const surfaces::DiscHull disc = discs.hull({middle, middle});
      least.margin = margin;
      least.place.parameter = double(index) + middle;
      least.place.center = disc.middle();
      least.place.radius = disc.radius.upper;
    }
  }
}

std::optional<MarginPlace> margin_place(const ResolvedPart& part) {
  const auto* const chain = std::get_if<Chain>(&part.shape);
  if (chain == nullptr || part.ends_in_hub) {
    return std::nullopt;
  }
  Least least;
  for (std::size_t i = 0; i < chain->pieces.size(); ++i) {
    include(chain->pieces[i], i, least);
  }
  least.place.part = part.name;
  return std::isfinite(least.margin) ? std::optional(least.place) : std::nullopt;
}

}  // namespace

std::vector<MarginPlace> margin_places(const Assembly& assembly) {
  std::vector<MarginPlace> result;
  for (const ResolvedPart& part : resolve(assembly).parts) {
    if (auto place = margin_place(part)) {
      result.push_back(std::move(*place));
    }
  }
  return result;
}

}  // namespace dupin
