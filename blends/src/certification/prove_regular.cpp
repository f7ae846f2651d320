#include "certification/prove_regular.h"

#include <algorithm>

#include "surfaces/pieces/surface_piece.h"

namespace dupin::certification {

RegularClaim prove_regular(const Chain& chain, std::optional<double> margin) {
  RegularClaim claim{Verdict::proved, 1, {}, {}};
  for (const Piece& piece : chain.pieces) {
    claim.margin = margin ? *margin
                          : std::visit(
                                [&](const auto& p) {
                                  return std::min(claim.margin,
                                                  surfaces::nearly_largest_margin(p, chain.wall));
                                },
                                piece);
  }
  for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
    const auto seam = static_cast<double>(i);
    const auto proof = std::visit(
        [&](const auto& p) { return surfaces::prove_margin(p, chain.wall, claim.margin); },
        chain.pieces[i]);
    if (proof.verdict != Verdict::proved) {
      return {proof.verdict, claim.margin, {}, {seam + proof.where.from, seam + proof.where.to}};
    }
    for (const ParameterInterval& leaf : proof.leaves) {
      claim.leaves.push_back({seam + leaf.from, seam + leaf.to});
    }
  }
  return claim;
}

}  // namespace dupin::certification
