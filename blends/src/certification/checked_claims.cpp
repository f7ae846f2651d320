#include "certification/checked_claims.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "dupin/kernel/error.h"
#include "verification/hub_claims.h"

namespace dupin::certification {

// What it refuses costs the certificate nothing, for it is not claimed; but it took time.
template <class Check>
bool CheckedClaims::holds(std::uint64_t allowance, const Check& check) {
  constexpr std::uint64_t kMostRefused = 8 * CertificateLimits::kWork;
  if (allowance > 0 && refused_work_ > kMostRefused) {
    return false;
  }
  const std::uint64_t before = limit_.left();
  limit_.set_left(before + allowance);
  try {
    if (check()) {
      return true;
    }
  } catch (const Error& error) {
    if (error.code() != Errc::limit_exceeded) {
      throw;
    }
    lacks_work_ = true;
  }
  refused_work_ += before + allowance - limit_.left();
  limit_.set_left(before);
  return false;
}

void CheckedClaims::read(const CertifiedPart& part) {
  limit_.set_left(limit_.left() + verification::work_for(part, {}));
  solids_.emplace_back(part);
  names_.push_back(part.name);
}

void CheckedClaims::reserve_for(const std::vector<CertifiedJunction>& junctions) {
  std::uint64_t units = 0;
  for (const CertifiedJunction& junction : junctions) {
    units += verification::kWorkOfCaps * junction.arms.size() * (junction.arms.size() - 1) / 2;
  }
  if (units > limit_.left()) {
    throw Error(Errc::limit_exceeded,
                "to check its junctions takes more work than a certificate may; choose junctions "
                "of fewer arms, or several documents");
  }
  limit_.set_left(limit_.left() - units);
}

LoopClaims CheckedClaims::agreed(const CanalFillet& loop, LoopClaims claims) {
  limit_.set_left(limit_.left() + verification::work_for_loop());
  loops_.push_back({&loop, {}});
  std::optional<std::vector<verification::ArcCell>> cells;
  const auto lacks = [&](std::uint64_t allowance, const auto& check) {
    return !holds(allowance, check);
  };
  if (lacks(0, [&] { return verification::follows(loop, claims.contact); })) {
    throw Error(Errc::limit_exceeded,
                "to check its fillets takes more work than a certificate may; choose several "
                "documents with fewer");
  }
  if (lacks(verification::work_for_arcs(claims.regular), [&] {
        cells = verification::regular_cells(loop, claims.regular);
        return cells.has_value();
      })) {
    return {{Verdict::undecided, claims.regular.margin, {}, {}}, {}, claims.contact, {}};
  }
  if (lacks(verification::work_for(claims.embedded.leaves),
            [&] { return verification::follows(loop, *cells, claims.embedded); })) {
    claims.embedded = {};
  }
  if (claims.mesh && lacks(verification::work_for(*claims.mesh),
                           [&] { return verification::follows(*cells, *claims.mesh); })) {
    claims.mesh.reset();
  }
  loops_.back().cells = std::move(*cells);
  return claims;
}

RegularClaim CheckedClaims::agreed(RegularClaim claim) {
  if (claim.verdict != Verdict::undecided && !holds(verification::work_for(claim), [&] {
        return verification::follows(solids_.back(), claim);
      })) {
    claim = {Verdict::undecided, claim.margin, {}, {}};
  }
  if (!verification::has_form(solids_.back(), claim)) {
    claim.where = {};
  }
  return claim;
}

EmbeddedClaim CheckedClaims::agreed(EmbeddedClaim claim, const RegularClaim& regular) {
  lacks_work_ = false;
  if (claim.verdict != Verdict::undecided && !holds(verification::work_for(claim.leaves), [&] {
        return verification::follows(solids_.back(), claim, regular);
      })) {
    return {};
  }
  return claim;
}

// The prover's bound is tight; the checker's curvature comes from intervals of doubles.
TangencyClaim CheckedClaims::agreed(TangencyClaim claim, std::size_t piece, End end,
                                    double tolerance) {
  const verification::Piece& its = solids_.back().pieces()[piece];
  const auto follows = [&] {
    return holds(0, [&] { return verification::follows(its, claim, end); });
  };
  lacks_work_ = false;
  bool is_so = follows();
  if (!is_so && claim.curvature) {
    const double proven = *claim.curvature, size = 1 / its.start.radius;
    for (double room = 0x1p-50; room < 1 && !is_so; room *= 4) {
      claim.curvature = proven * (1 + room) + room * size;
      is_so = follows();
    }
    if (!is_so) {
      claim.curvature.reset();
      is_so = follows();
    }
  }
  const Ring& ring = end == End::end ? its.end : its.start;
  if (!is_so || !verification::is_near(claim, ring, tolerance)) {
    if (lacks_work_) {
      throw Error(Errc::limit_exceeded,
                  "to check how its pieces meet takes more work than a certificate may; choose "
                  "parts of fewer pieces or points, or several documents",
                  names_.back());
    }
    throw Error(Errc::invalid_argument,
                "the stored rings differ from the surface by more than the tolerance",
                names_.back());
  }
  return claim;
}

std::optional<MeshClaim> CheckedClaims::agreed(MeshClaim claim, std::uint32_t part) {
  const double proven = claim.error_bound;
  lacks_work_ = false;
  for (const double room : {0x1p-20, 0x1p-6, 0x1p-4, 0x1p-2, 1.0}) {
    if (lacks_work_) {
      break;  // a looser bound would take no less
    }
    claim.error_bound = proven * (1 + room);
    if (holds(verification::work_for(claim),
              [&] { return verification::follows(solids_[part], claim); })) {
      return claim;
    }
  }
  return std::nullopt;
}

std::optional<std::vector<verification::PartPair>> CheckedClaims::pairs_nearer_than(
    double distance) {
  std::vector<verification::PartPair> pairs;
  const bool is_told = holds(verification::work_for_boxes(solids_.size()), [&] {
    pairs = verification::pairs_nearer_than(distance, solids_);
    return true;
  });
  return is_told ? std::optional(std::move(pairs)) : std::nullopt;
}

std::optional<std::vector<verification::PartPair>> CheckedClaims::loop_pairs_nearer_than(
    double distance) {
  std::vector<verification::PartPair> pairs;
  const bool is_told = holds(verification::work_for_boxes(solids_.size() + loops_.size()), [&] {
    pairs = verification::loop_pairs_nearer_than(distance, solids_, loops_);
    return true;
  });
  return is_told ? std::optional(std::move(pairs)) : std::nullopt;
}

std::optional<MeshClaim> CheckedClaims::agreed_of_hub(MeshClaim claim, const Sphere& hub) {
  if (claim.segments < 3) {
    return std::nullopt;
  }
  const double half = std::sin(std::numbers::pi / 2 / claim.segments);
  const double proven = std::sqrt(5.0) * hub.radius * half * half;
  for (double room = 0x1p-40; room < 2; room *= 16) {
    claim.error_bound = proven * (1 + room) + claim.grid + room * hub.radius * 0x1p-10;
    if (holds(verification::work_for(claim),
              [&] { return verification::follows_of_hub(hub, claim); })) {
      return claim;
    }
  }
  return std::nullopt;
}

ClearanceClaim CheckedClaims::agreed_at_hub(ClearanceClaim claim) {
  if (claim.verdict == Verdict::proved && holds(verification::work_for(claim.leaves), [&] {
        return verification::follows_at_hub(solids_[claim.first], *solids_[claim.second].ball(),
                                            claim);
      })) {
    return claim;
  }
  return {claim.first, claim.second, Verdict::undecided, 0, {}, {}};
}

ClearanceClaim CheckedClaims::agreed(ClearanceClaim claim,
                                     const std::vector<CertifiedPart>& parts) {
  if (claim.verdict == Verdict::undecided) {
    return claim;
  }
  const auto joints = verification::joints(solids_, parts, claim.first, claim.second);
  return nearer(std::move(claim), [&](const ClearanceClaim& weaker) {
    return verification::follows(solids_[weaker.first], solids_[weaker.second], joints, weaker);
  });
}

ClearanceClaim CheckedClaims::agreed(ClearanceClaim claim) {
  if (claim.verdict == Verdict::undecided) {
    return claim;
  }
  return nearer(std::move(claim), [&](const ClearanceClaim& weaker) {
    const auto& second = loops_[weaker.second - solids_.size()];
    return weaker.first < solids_.size()
               ? verification::follows(solids_[weaker.first], second, weaker)
               : verification::follows(loops_[weaker.first - solids_.size()], second, weaker);
  });
}

// With the largest of some shares of the distance that follows.
template <class Follows>
ClearanceClaim CheckedClaims::nearer(ClearanceClaim claim, const Follows& follows) {
  const double proven = claim.distance;
  for (const double share : {1.0, 1 - 0x1p-20, 0.5, 0x1p-10}) {
    claim.distance = proven * share;
    if (holds(verification::work_for(claim.leaves), [&] { return follows(claim); })) {
      return claim;
    }
    if (proven == 0) {
      break;
    }
  }
  return {claim.first, claim.second, Verdict::undecided, 0, {}, {}};
}

}  // namespace dupin::certification
