#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dupin/blends/certificate.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "verification/admitted.h"
#include "verification/claims/claims.h"
#include "verification/claims/loop_clearance.h"
#include "verification/claims/near_parts.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

void require(bool follows, const std::string& part, const std::string& claim) {
  if (!follows) {
    throw Error(Errc::invalid_argument, "the claim '" + claim + "' does not follow", part,
                "certificate");
  }
}

// In order, whatever is found first.
template <class Verify>
void verify_each(std::size_t count, const Verify& verify) {
  (void)holds_of_all(count, [&](std::size_t i) {
    verify(i);
    return true;
  });
}

bool is_undecided(Verdict verdict) { return verdict == Verdict::undecided; }

bool are_flips(const Ring& a, const Ring& b) {
  const Ellipse none;
  const Ellipse x = a.ellipse.value_or(none), y = b.ellipse.value_or(none);
  return a.center == b.center && a.normal == -b.normal && a.radius == b.radius &&
         a.slope == -b.slope && a.ellipse.has_value() == b.ellipse.has_value() &&
         x.axis == y.axis && x.across == y.across &&
         (!a.ellipse || x.across_slope == -y.across_slope);
}

const Ring& end_ring(const Solid& solid, End end) {
  return end == End::end ? solid.pieces().back().end : solid.pieces().front().start;
}

// Nothing is claimed of it but that nothing is known.
bool is_silent(const PartClaims& claims) {
  const bool no_margin = claims.regular && is_undecided(claims.regular->verdict) &&
                         claims.regular->margin == 0 && claims.regular->leaves.empty() &&
                         claims.regular->where == ParameterInterval{};
  return no_margin && claims.embedded && is_undecided(claims.embedded->verdict) &&
         has_form(*claims.embedded) && claims.tangency.empty() && !claims.mesh;
}

void verify_joints(const Solid& solid, const std::string& name, const PartClaims& claims,
                   double tolerance) {
  const auto& pieces = solid.pieces();
  verify_each(pieces.size(), [&](std::size_t i) {
    require(follows(pieces[i], claims.tangency[2 * i], End::start) &&
                follows(pieces[i], claims.tangency[2 * i + 1], End::end),
            name, "tangency");
    const double size = solid.size_of_piece(i);
    require(is_near(claims.tangency[2 * i], pieces[i].start, size, tolerance) &&
                is_near(claims.tangency[2 * i + 1], pieces[i].end, size, tolerance),
            name, "joints");
    require(i == 0 ? !solid.closed() || are_flips(pieces.back().end, pieces.front().start)
                   : solid.has_kneecaps() || are_flips(pieces[i - 1].end, pieces[i].start),
            name, "joints");
  });
}

// Hubs' meshes are none of latitudes and longitudes.
bool mesh_follows(const Solid& solid, const MeshClaim& claim, bool is_hub) {
  return is_hub ? solid.ball() != nullptr && follows_of_hub(*solid.ball(), claim)
                : follows(solid, claim);
}

void verify_part(const Solid& solid, const std::string& name, const PartClaims& claims,
                 double tolerance, bool is_hub) {
  if (solid.ball() != nullptr) {
    require(!claims.regular && !claims.embedded && claims.tangency.empty(), name, "regular");
  } else if (solid.pieces().empty()) {
    require(is_silent(claims), name, "undecided");
  } else {
    require(
        claims.regular && claims.embedded && claims.tangency.size() == 2 * solid.pieces().size(),
        name, "regular");
    require(is_undecided(claims.regular->verdict) ? has_form(solid, *claims.regular)
                                                  : follows(solid, *claims.regular),
            name, "regular");
    require(is_undecided(claims.embedded->verdict)
                ? has_form(*claims.embedded)
                : follows(solid, *claims.embedded, *claims.regular),
            name, "embedded");
    verify_joints(solid, name, claims, tolerance);
  }
  require(!claims.mesh || mesh_follows(solid, *claims.mesh, is_hub), name, "mesh");
}

// In rings that are the same, bitwise.
bool are_joined(const Solid& first, End own, const Solid& second, End other) {
  return first.ball() == nullptr && second.ball() == nullptr && !first.closed() &&
         !second.closed() && are_flips(end_ring(first, own), end_ring(second, other));
}

// Also where no clearance says anything of the two.
void verify_joined(const std::vector<Solid>& solids, const std::vector<CertifiedPart>& parts) {
  verify_each(parts.size(), [&](std::size_t i) {
    for (const End end : {End::start, End::end}) {
      const auto& other = parts[i].joined.at(at(end));
      require(!other || solids[i].length() == 0 || solids[other->part].length() == 0 ||
                  are_joined(solids[i], end, solids[other->part], other->end),
              parts[i].name, "joined");
    }
  });
}

}  // namespace

std::vector<JoinedEnds> joints(const std::vector<Solid>& solids,
                               const std::vector<CertifiedPart>& parts, std::uint32_t first,
                               std::uint32_t second, double tolerance) {
  std::vector<JoinedEnds> result;
  for (const End end : {End::start, End::end}) {
    const auto& other = parts[first].joined.at(at(end));
    if (other && other->part == second) {
      JoinedEnds joint{end, other->end};
      if (solids[first].length() == 0 || solids[second].length() == 0) {
        continue;  // nothing can be claimed
      }
      joint.have_rims_apart = have_rims_apart(solids[first].rim(joint.first),
                                              solids[second].rim(joint.second), tolerance);
      result.push_back(joint);
    }
  }
  return result;
}

namespace {

bool is_same(const Ring& a, const Ring& b) { return are_flips(a, flipped(b)); }

bool is_straight(const Solid& pipe) {
  return pipe.pieces().size() == 1 && pipe.pieces().front().tubes.size() == 1 &&
         pipe.pieces().front().tubes.front().is_cone();
}

// The quadrics are those of the pipes but for the difference, which is part of what is claimed, so
// that what touches these between the pipes' ends touches the pipes.
LoopArcs verify_loop(const std::vector<Solid>& solids, const CertifiedFillet& fillet,
                     const CanalFillet& loop, const LoopClaims& claims, double tolerance) {
  std::array<const Piece*, 2> pipes{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Solid& pipe = solids[fillet.between.at(side)];
    require(!pipe.pieces().empty() && is_same(loop.quadrics.at(side), end_ring(pipe, End::end)) &&
                !loop.quadrics.at(side).ellipse,
            fillet.name, "between");
    require(is_straight(pipe), fillet.name, "between");
    pipes.at(side) = &pipe.pieces().front();
  }
  if (const auto& contact = claims.contact) {
    const auto [starts, difference] = rolled_pipes(loop.quadrics, pipes);
    require(touches_between(loop, starts, tolerance), fillet.name, "between");
    require(follows(loop, about_quadrics(*contact, difference)) && contact->offset <= tolerance,
            fillet.name, "contact");
  }
  auto cells = regular_cells(loop, claims.regular);
  require(cells || (is_undecided(claims.regular.verdict) && has_form(claims.regular)), fillet.name,
          "regular");
  require(is_undecided(claims.embedded.verdict) ? has_form(claims.embedded)
                                                : cells && follows(loop, *cells, claims.embedded),
          fillet.name, "embedded");
  require(!claims.mesh || (cells && follows(*cells, *claims.mesh)), fillet.name, "mesh");
  return {&loop, cells ? std::move(*cells) : std::vector<ArcCell>()};
}

std::vector<Solid> verify_parts(const Certificate& certificate,
                                const std::set<std::uint32_t>& hubs) {
  const auto& parts = certificate.parts;
  std::vector<std::optional<Solid>> found(parts.size());
  verify_each(parts.size(), [&](std::size_t i) {
    verify_part(found[i].emplace(parts[i]), parts[i].name, certificate.claims[i],
                certificate.tolerance, hubs.contains(std::uint32_t(i)));
  });
  std::vector<Solid> solids;
  solids.reserve(found.size());
  for (std::optional<Solid>& solid : found) {
    solids.push_back(std::move(*solid));
  }
  return solids;
}

// Of all fillets.
struct Loops {
  std::vector<const CertifiedFillet*> fillets;
  std::vector<LoopArcs> arcs;
};

Loops verify_fillets(const std::vector<Solid>& solids, const Certificate& certificate) {
  const auto& fillets = certificate.fillets;
  require(certificate.fillet_claims.size() == fillets.size(), "", "fillets");
  std::vector<std::vector<LoopArcs>> arcs(fillets.size());
  verify_each(fillets.size(), [&](std::size_t i) {
    const auto& claims = certificate.fillet_claims[i];
    const auto& loops = fillets[i].loops;
    require(!loops.empty() && loops.size() == claims.size(), fillets[i].name, "loops");
    admit(fillets[i]);
    arcs[i].clear();
    for (std::size_t k = 0; k < loops.size(); ++k) {
      arcs[i].push_back(
          verify_loop(solids, fillets[i], loops[k], claims[k], certificate.tolerance));
    }
  });
  Loops result;
  for (std::size_t i = 0; i < fillets.size(); ++i) {
    result.fillets.insert(result.fillets.end(), arcs[i].size(), &fillets[i]);
    std::ranges::move(arcs[i], std::back_inserter(result.arcs));
  }
  return result;
}

void verify_inputs(const Certificate& certificate) {
  require(is_name(certificate.document), "", "document");
  require(is_bound(certificate.tolerance), "", "tolerance");
  require(is_bound(certificate.apart), "", "apart");
  require(!certificate.axes ||
              (certificate.apart > 0 &&
               std::all_of(certificate.axes->begin(), certificate.axes->end(), is_point)),
          "", "axes");
  std::set<std::string> names;
  const auto says_back = [&](const EndIndex& own, const EndIndex& other) {
    if (other.part >= certificate.parts.size() || other.part == own.part) {
      return false;
    }
    const auto& back = certificate.parts[other.part].joined.at(at(other.end));
    return back && back->part == own.part && back->end == own.end;
  };
  for (std::uint32_t i = 0; i < certificate.parts.size(); ++i) {
    const CertifiedPart& part = certificate.parts[i];
    require(is_name(part.name) && is_name(part.kind) && names.insert(part.name).second, "",
            "name");  // of which nothing is repeated: it would be printed
    for (const End end : {End::start, End::end}) {
      const auto& joined = part.joined.at(at(end));
      require(!joined || says_back({i, end}, *joined), part.name, "joined");
    }
  }
  for (const CertifiedFillet& fillet : certificate.fillets) {
    require(is_name(fillet.name) && names.insert(fillet.name).second, "", "name");
    require(std::max(fillet.between[0], fillet.between[1]) < certificate.parts.size() &&
                fillet.between[0] != fillet.between[1],
            fillet.name, "between");
  }
}

// Arms and their hubs, of which one comes after the other.
using HubPairs = std::set<PartPair>;

std::set<std::uint32_t> hubs_of(const Certificate& certificate) {
  std::set<std::uint32_t> result;
  for (const CertifiedJunction& junction : certificate.junctions) {
    require(junction.hub < certificate.parts.size() && result.insert(junction.hub).second, "",
            "junctions");
  }
  return result;
}

HubPairs verify_junctions(const std::vector<Solid>& solids, const Certificate& certificate) {
  HubPairs result;
  std::set<std::uint32_t> all_arms;
  for (const auto& [hub, arms] : certificate.junctions) {
    const std::string& name = certificate.parts[hub].name;
    const Sphere* ball = solids[hub].ball();
    require(ball != nullptr && arms.size() >= 2, name, "junction");
    for (auto arm = arms.begin(); arm != arms.end(); ++arm) {
      require(*arm < hub && is_arm(solids[*arm], *ball) && all_arms.insert(*arm).second, name,
              "arms");
      require(!certificate.parts[*arm].joined.at(at(End::end)), name, "arms");
      require(std::all_of(arms.begin(), arm,
                          [&](std::uint32_t other) {
                            return caps_are_disjoint(solids[other], solids[*arm]);
                          }),
              name, "caps");
      result.insert({*arm, hub});
    }
  }
  return result;
}

bool follows_or_is_silent(const std::vector<Solid>& solids, const Certificate& certificate,
                          const HubPairs& hub_pairs, const ClearanceClaim& claim) {
  if (is_undecided(claim.verdict)) {
    return has_form(claim);
  }
  return hub_pairs.contains({claim.first, claim.second})
             ? follows_at_hub(solids[claim.first], *solids[claim.second].ball(), claim)
             : follows(solids[claim.first], solids[claim.second],
                       joints(solids, certificate.parts, claim.first, claim.second,
                              certificate.tolerance),
                       claim);
}

void verify_clearance(const std::vector<Solid>& solids, const Certificate& certificate,
                      const HubPairs& hub_pairs, const PartPair& pair,
                      const ClearanceClaim* claim) {
  require(claim != nullptr && PartPair{claim->first, claim->second} == pair &&
              follows_or_is_silent(solids, certificate, hub_pairs, *claim),
          certificate.parts[pair[0]].name, "clearance of " + certificate.parts[pair[1]].name);
}

// Of two parts each, as many as there are claims at most, and the one after these.
std::vector<PartPair> first_pairs(std::uint32_t parts, std::size_t claims) {
  std::vector<PartPair> result;
  for (std::uint32_t i = 0; i < parts && result.size() <= claims; ++i) {
    for (std::uint32_t j = i + 1; j < parts && result.size() <= claims; ++j) {
      result.push_back({i, j});
    }
  }
  return result;
}

void verify_all_pairs(const std::vector<Solid>& solids, const Certificate& certificate,
                      const HubPairs& hub_pairs) {
  const auto& claims = certificate.clearances;
  const auto pairs = first_pairs(std::uint32_t(solids.size()), claims.size());
  verify_each(pairs.size(), [&](std::size_t i) {
    verify_clearance(solids, certificate, hub_pairs, pairs[i],
                     i < claims.size() ? &claims[i] : nullptr);
  });
  require(pairs.size() == claims.size(), "", "clearance");
}

// Those that have a claim, in order and each once; none is missing that may be closer than is
// claimed of the others.
void verify_near_pairs(const std::vector<Solid>& solids, const Certificate& certificate,
                       const HubPairs& hub_pairs) {
  const auto near = pairs_nearer_than(certificate.apart, certificate.axes, solids);
  const auto& claims = certificate.clearances;
  const auto pair_of = [&](std::size_t i) { return PartPair{claims[i].first, claims[i].second}; };
  verify_each(claims.size(), [&](std::size_t i) {
    const PartPair before = i == 0 ? PartPair{0, 0} : pair_of(i - 1), pair = pair_of(i);
    require(before < pair && pair[0] < pair[1] && pair[1] < solids.size(), "", "clearance");
    verify_clearance(solids, certificate, hub_pairs, pair, &claims[i]);
  });
  auto missing = near.begin();
  for (std::size_t i = 0; i < claims.size(); ++i) {
    missing += missing != near.end() && *missing == pair_of(i) ? 1 : 0;
  }
  if (missing != near.end()) {
    verify_clearance(solids, certificate, hub_pairs, *missing, nullptr);
  }
}

bool is_on(const CertifiedFillet& fillet, std::uint32_t part) {
  return fillet.between[0] == part || fillet.between[1] == part;
}

// Whether the two are to have a claim: a loop and a part but its pipes, or a later loop.
bool is_pair(const PartPair& pair, const Loops& loops, std::size_t parts) {
  const auto [first, second] = pair;
  return first < second && second >= parts && second - parts < loops.arcs.size() &&
         (first >= parts || !is_on(*loops.fillets[second - parts], first));
}

void verify_fillet_clearance(const std::vector<Solid>& solids, const Loops& loops, double tolerance,
                             const PartPair& pair, const ClearanceClaim* claim) {
  const std::size_t parts = solids.size();
  const std::uint32_t first = pair[0], second = pair[1];
  const auto holds = [&] {
    const LoopArcs& arcs = loops.arcs[second - parts];
    return first < parts ? follows(solids[first], arcs, *claim)
                         : follows(loops.arcs[first - parts], arcs, *claim);
  };
  require(claim != nullptr && PartPair{claim->first, claim->second} == pair &&
              (is_undecided(claim->verdict) ? has_form(*claim) : holds()) &&
              claim->corner <= tolerance,
          loops.fillets[place_of(pair, parts)[0]]->name, "clearance");
}

void verify_all_fillet_pairs(const std::vector<Solid>& solids, const Loops& loops,
                             const Certificate& certificate) {
  const auto& claims = certificate.fillet_clearances;
  const auto parts = std::uint32_t(solids.size()),
             surfaces = parts + std::uint32_t(loops.arcs.size());
  std::vector<PartPair> pairs;
  const auto append = [&](const PartPair& pair) {
    if (pairs.size() <= claims.size() && is_pair(pair, loops, parts)) {
      pairs.push_back(pair);
    }
  };
  for (std::uint32_t k = parts; k < surfaces; ++k) {
    for (std::uint32_t i = 0; i < parts; ++i) {
      append({i, k});
    }
    for (std::uint32_t j = k + 1; j < surfaces; ++j) {
      append({k, j});
    }
  }
  verify_each(pairs.size(), [&](std::size_t i) {
    verify_fillet_clearance(solids, loops, certificate.tolerance, pairs[i],
                            i < claims.size() ? &claims[i] : nullptr);
  });
  require(pairs.size() == claims.size(), "", "clearance");
}

// As verify_near_pairs does.
void verify_near_fillet_pairs(const std::vector<Solid>& solids, const Loops& loops,
                              const Certificate& certificate) {
  const std::size_t parts = solids.size();
  auto near = loop_pairs_nearer_than(certificate.apart, certificate.axes, solids, loops.arcs);
  std::erase_if(near, [&](const PartPair& pair) { return !is_pair(pair, loops, parts); });
  const auto& claims = certificate.fillet_clearances;
  const auto pair_of = [&](std::size_t i) { return PartPair{claims[i].first, claims[i].second}; };
  verify_each(claims.size(), [&](std::size_t i) {
    const PartPair pair = pair_of(i);
    require(is_pair(pair, loops, parts) &&
                (i == 0 || place_of(pair_of(i - 1), parts) < place_of(pair, parts)),
            "", "clearance");
    verify_fillet_clearance(solids, loops, certificate.tolerance, pair, &claims[i]);
  });
  auto missing = near.begin();
  for (std::size_t i = 0; i < claims.size(); ++i) {
    missing += missing != near.end() && *missing == pair_of(i) ? 1 : 0;
  }
  if (missing != near.end()) {
    verify_fillet_clearance(solids, loops, certificate.tolerance, *missing, nullptr);
  }
}

}  // namespace
}  // namespace dupin::verification

namespace dupin {

void verify(const Certificate& certificate) {
  const UsualArithmetic usual;
  const auto& parts = certificate.parts;
  const verification::WorkLimit limit(verification::work_for(certificate));
  verification::verify_inputs(certificate);
  verification::require(certificate.claims.size() == parts.size(), "", "parts");
  const auto hubs = verification::hubs_of(certificate);
  const auto solids = verification::verify_parts(certificate, hubs);
  const auto hub_pairs = verification::verify_junctions(solids, certificate);
  verification::verify_joined(solids, parts);
  const auto fillets = verification::verify_fillets(solids, certificate);
  if (certificate.apart == 0) {
    verification::verify_all_pairs(solids, certificate, hub_pairs);
  } else {
    verification::verify_near_pairs(solids, certificate, hub_pairs);
  }
  if (certificate.apart == 0 || fillets.arcs.empty()) {
    verification::verify_all_fillet_pairs(solids, fillets, certificate);
  } else {
    verification::verify_near_fillet_pairs(solids, fillets, certificate);
  }
}

}  // namespace dupin
