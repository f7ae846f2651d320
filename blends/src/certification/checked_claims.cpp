#include "certification/checked_claims.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dupin/kernel/error.h"
#include "verification/claims/hub_claims.h"

namespace dupin::certification {

void reserve_for(const std::vector<CertifiedJunction>& junctions, WorkLeft& left) {
  std::uint64_t units = 0;
  for (const CertifiedJunction& junction : junctions) {
    units += verification::kWorkOfCaps * junction.arms.size() * (junction.arms.size() - 1) / 2;
  }
  if (units > left.checks) {
    throw Error(Errc::limit_exceeded,
                "to check its junctions takes more work than a certificate may; choose junctions "
                "of fewer arms, or several documents");
  }
  left.checks -= units;
}

Solid admitted(const CertifiedPart& part, ClaimWork& work) {
  work.allow_checks(verification::work_for(part, {}));
  return Solid(part);
}

LoopClaims agreed(LoopClaims claims, LoopArcs& loop, const verification::RolledPipes& pipes,
                  double tolerance, ClaimWork& work) {
  work.allow_checks(verification::work_for_loop());
  std::optional<std::vector<verification::ArcCell>> cells;
  const auto lacks = [&](std::uint64_t allowance, const auto& check) {
    return !work.holds(allowance, check);
  };
  bool is_between = true;
  const auto touches = [&] {
    is_between = verification::touches_between(*loop.loop, pipes.starts, tolerance);
    return is_between && claims.contact->offset <= tolerance &&
           verification::follows(*loop.loop,
                                 verification::about_quadrics(*claims.contact, pipes.difference));
  };
  // What the pipes are off their quadrics, the prover knows nothing of; mostly there is room for
  // it.
  if (claims.contact && lacks(0, touches)) {
    claims.contact->offset += 2 * pipes.difference.offset;
    claims.contact->deviation += 2 * pipes.difference.deviation;
    if (lacks(0, touches)) {
      claims.contact.reset();
    }
  }
  if (!is_between) {
    throw Error(Errc::invalid_argument,
                "the ball that rolls along it touches a pipe beyond its end by more than the "
                "tolerance; make the pipe longer, or the fillet smaller");
  }
  if (lacks(verification::work_for_arcs(claims.regular), [&] {
        cells = verification::regular_cells(*loop.loop, claims.regular);
        return cells.has_value();
      })) {
    return {{Verdict::undecided, claims.regular.margin, {}, {}}, {}, claims.contact, {}};
  }
  if (lacks(verification::work_for(claims.embedded.leaves),
            [&] { return verification::follows(*loop.loop, *cells, claims.embedded); })) {
    claims.embedded = {};
  }
  if (claims.mesh && lacks(verification::work_for(*claims.mesh),
                           [&] { return verification::follows(*cells, *claims.mesh); })) {
    claims.mesh.reset();
  }
  loop.cells = std::move(*cells);
  return claims;
}

RegularClaim agreed(RegularClaim claim, const Solid& solid, ClaimWork& work) {
  if (claim.verdict != Verdict::undecided && !work.holds(verification::work_for(claim), [&] {
        return verification::follows(solid, claim);
      })) {
    claim = {Verdict::undecided, claim.margin, {}, {}};
  }
  if (!verification::has_form(solid, claim)) {
    claim.where = {};
  }
  return claim;
}

EmbeddedClaim agreed(EmbeddedClaim claim, const RegularClaim& regular, const Solid& solid,
                     ClaimWork& work) {
  work.forget_lack();
  if (claim.verdict != Verdict::undecided && !work.holds(verification::work_for(claim.leaves), [&] {
        return verification::follows(solid, claim, regular);
      })) {
    return {};
  }
  return claim;
}

// The prover's bound is tight; the checker's curvature comes from intervals of doubles.
TangencyClaim agreed(TangencyClaim claim, const PieceEnd& at, double tolerance, const Solid& solid,
                     const std::string& name, ClaimWork& work) {
  const verification::Piece& its = solid.pieces()[at.piece];
  const auto follows = [&] {
    return work.holds(0, [&] { return verification::follows(its, claim, at.end); });
  };
  work.forget_lack();
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
  const Ring& ring = at.end == End::end ? its.end : its.start;
  if (!is_so || !verification::is_near(claim, ring, solid.size_of_piece(at.piece), tolerance)) {
    if (work.lacks_work()) {
      throw Error(Errc::limit_exceeded,
                  "to check how its pieces meet takes more work than a certificate may; choose "
                  "parts of fewer pieces or points, or several documents",
                  name);
    }
    throw Error(Errc::invalid_argument,
                "the stored rings differ from the surface by more than the tolerance, or than they "
                "are wide",
                name);
  }
  return claim;
}

MeshRooms first_rooms() {
  return {{{0x1p-20, 4}, {0x1p-6, 1}, {0x1p-4, 1}, {0x1p-2, 1}, {1, 1}}, true};
}

namespace {

// That an error of this share of the tolerance has within it.
double room_within(double share) { return (1 / share - 1) * (1 - 0x1p-20); }

}  // namespace

MeshRooms rooms_of_many(double share) {
  constexpr double kLoose = 0x1p-1, kTight = 0x1p-20;
  constexpr std::uint64_t kHardlyAny = 1 << 12;
  const double within = std::min(room_within(share), kLoose);
  return within > kTight ? MeshRooms{{{kTight, kHardlyAny}, {within, 1}, {1, 1}}} : first_rooms();
}

MeshRooms last_rooms(double share) {
  MeshRooms rooms{{{0x1p-11, 4}, {0x1p-6, 2}, {0x1p-4, 2}, {0x1p-2, 1}, {1, 1}}};
  const double within = room_within(share);
  if (within > 0 && within < rooms.all.front().share) {
    rooms.all.insert(rooms.all.begin(), {within, 2});
  }
  return rooms;
}

// The tighter the bound, the shorter the stretches that it is looked for on.
std::optional<MeshClaim> agreed(MeshClaim claim, const Solid& solid, const MeshRooms& rooms,
                                ClaimWork& work) {
  const double proven = claim.error_bound;
  work.forget_lack();
  for (const MeshRoom& room : rooms.all) {
    claim.error_bound = proven * (1 + room.share);
    if (work.holds(
            verification::work_for(claim), [&] { return verification::follows(solid, claim); },
            room.of_work)) {
      return claim;
    }
    if (rooms.end_without_work && work.lacks_work()) {
      break;
    }
  }
  return std::nullopt;
}

std::optional<std::vector<verification::PartPair>> pairs_nearer_than(
    double distance, const verification::BoxAxes& axes, const std::vector<Solid>& solids,
    ClaimWork& work) {
  std::vector<verification::PartPair> pairs;
  const bool is_told = work.holds(verification::work_for_boxes(solids.size()), [&] {
    pairs = verification::pairs_nearer_than(distance, axes, solids);
    return true;
  });
  return is_told ? std::optional(std::move(pairs)) : std::nullopt;
}

std::optional<std::vector<verification::PartPair>> loop_pairs_nearer_than(
    double distance, const verification::BoxAxes& axes, const std::vector<Solid>& solids,
    const std::vector<LoopArcs>& loops, ClaimWork& work) {
  std::vector<verification::PartPair> pairs;
  const bool is_told = work.holds(verification::work_for_boxes(solids.size() + loops.size()), [&] {
    pairs = verification::loop_pairs_nearer_than(distance, axes, solids, loops);
    return true;
  });
  return is_told ? std::optional(std::move(pairs)) : std::nullopt;
}

std::optional<MeshClaim> agreed_of_hub(MeshClaim claim, const Sphere& hub, ClaimWork& work) {
  if (claim.segments < 3) {
    return std::nullopt;
  }
  const double half = std::sin(std::numbers::pi / 2 / claim.segments);
  const double proven = std::sqrt(5.0) * hub.radius * half * half;
  for (double room = 0x1p-40; room < 2; room *= 16) {
    claim.error_bound = proven * (1 + room) + claim.grid + room * hub.radius * 0x1p-10;
    if (work.holds(verification::work_for(claim),
                   [&] { return verification::follows_of_hub(hub, claim); })) {
      return claim;
    }
  }
  return std::nullopt;
}

ClearanceClaim agreed_at_hub(ClearanceClaim claim, const std::vector<Solid>& solids,
                             ClaimWork& work) {
  if (claim.verdict == Verdict::proved && work.holds(verification::work_for(claim.leaves), [&] {
        return verification::follows_at_hub(solids[claim.first], *solids[claim.second].ball(),
                                            claim);
      })) {
    return claim;
  }
  return {claim.first, claim.second, Verdict::undecided, 0, {}, {}};
}

namespace {

// With the largest of some shares of the distance that follows.
template <class Follows>
ClearanceClaim nearer(ClearanceClaim claim, ClaimWork& work, const Follows& follows) {
  const double proven = claim.distance;
  bool lacked_work = false;
  for (const double share : {1.0, 1 - 0x1p-20, 0.5, 0x1p-10}) {
    if (lacked_work && share > 0.5) {
      continue;  // hardly less work
    }
    work.forget_lack();
    claim.distance = proven * share;
    if (work.holds(verification::work_for(claim.leaves), [&] { return follows(claim); })) {
      return claim;
    }
    if (proven == 0 || (lacked_work && work.lacks_work())) {
      break;
    }
    lacked_work = lacked_work || work.lacks_work();
  }
  return {claim.first, claim.second, Verdict::undecided, 0, {}, {}};
}

}  // namespace

ClearanceClaim agreed(ClearanceClaim claim, const std::vector<CertifiedPart>& parts,
                      const std::vector<Solid>& solids, double tolerance, ClaimWork& work) {
  if (claim.verdict == Verdict::undecided) {
    return claim;
  }
  const auto joints = verification::joints(solids, parts, claim.first, claim.second, tolerance);
  return nearer(std::move(claim), work, [&](const ClearanceClaim& weaker) {
    return verification::follows(solids[weaker.first], solids[weaker.second], joints, weaker);
  });
}

ClearanceClaim agreed(ClearanceClaim claim, const std::vector<Solid>& solids,
                      const std::vector<LoopArcs>& loops, ClaimWork& work) {
  if (claim.verdict == Verdict::undecided) {
    return claim;
  }
  return nearer(std::move(claim), work, [&](const ClearanceClaim& weaker) {
    const LoopArcs& second = loops[weaker.second - solids.size()];
    return weaker.first < solids.size()
               ? verification::follows(solids[weaker.first], second, weaker)
               : verification::follows(loops[weaker.first - solids.size()], second, weaker);
  });
}

}  // namespace dupin::certification
