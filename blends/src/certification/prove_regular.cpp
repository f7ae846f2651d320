#include "certification/prove_regular.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "dupin/kernel/parallel.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::certification {

namespace {

using surfaces::nearly_largest_margin;

double nearly_largest_margin_of_all(const Chain& chain) {
  std::vector<double> margins(chain.pieces.size());
  for_each_in_parallel(margins.size(), [&](std::size_t i) {
    margins[i] = std::visit([&](const auto& p) { return nearly_largest_margin(p, chain.wall); },
                            chain.pieces[i]);
  });
  return std::accumulate(margins.begin(), margins.end(), 1.0,
                         [](double a, double b) { return std::min(a, b); });
}

}  // namespace

RegularClaim prove_regular(const Chain& chain, std::optional<double> margin) {
  RegularClaim claim{Verdict::proved, 1, {}, {}};
  if (!chain.pieces.empty()) {
    claim.margin = margin ? *margin : nearly_largest_margin_of_all(chain);
  }
  std::vector<surfaces::ProvedStretches> proofs(chain.pieces.size());
  for_each_in_parallel(proofs.size(), [&](std::size_t i) {
    proofs[i] = std::visit(
        [&](const auto& p) { return surfaces::prove_margin(p, chain.wall, claim.margin); },
        chain.pieces[i]);
  });
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    const auto seam = static_cast<double>(i);
    const surfaces::ProvedStretches& proof = proofs[i];
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
