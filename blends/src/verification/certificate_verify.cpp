#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
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

// By keys and indices, as the text of a certificate has them.
template <class... Steps>
std::string place(const Steps&... steps) {
  std::ostringstream text;
  ((text << '/' << steps), ...);
  return text.str();
}

[[noreturn]] void refuse(const std::string& message, const std::string& part,
                         const std::string& place) {
  throw Error(Errc::invalid_argument, message, part, "certificate#" + place);
}

void require(bool follows, const std::string& part, const std::string& claim,
             const std::string& place) {
  if (!follows) {
    refuse("the claim '" + claim + "' does not follow", part, place);
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
                   double tolerance, const std::string& at) {
  const auto& pieces = solid.pieces();
  verify_each(pieces.size(), [&](std::size_t i) {
    const double size = solid.size_of_piece(i);
    for (const End end : {End::start, End::end}) {
      const std::size_t index = 2 * i + std::size_t(dupin::at(end));
      const TangencyClaim& claim = claims.tangency[index];
      const std::string its = at + place("tangency", index);
      require(follows(pieces[i], claim, end), name, "tangency", its);
      require(is_near(claim, end == End::end ? pieces[i].end : pieces[i].start, size, tolerance),
              name, "joints", its);
    }
    require(i == 0 ? !solid.closed() || are_flips(pieces.back().end, pieces.front().start)
                   : solid.has_kneecaps() || are_flips(pieces[i - 1].end, pieces[i].start),
            name, "joints", at + place("tangency", 2 * i));
  });
}

// Hubs' meshes are none of latitudes and longitudes.
bool mesh_follows(const Solid& solid, const MeshClaim& claim, bool is_hub) {
  return is_hub ? solid.ball() != nullptr && follows_of_hub(*solid.ball(), claim)
                : follows(solid, claim);
}

void verify_part(const Solid& solid, const std::string& name, const PartClaims& claims,
                 double tolerance, bool is_hub, const std::string& at) {
  if (solid.ball() != nullptr) {
    require(!claims.regular && !claims.embedded && claims.tangency.empty(), name, "regular", at);
  } else if (solid.pieces().empty()) {
    require(is_silent(claims), name, "undecided", at);
  } else {
    require(
        claims.regular && claims.embedded && claims.tangency.size() == 2 * solid.pieces().size(),
        name, "regular", at);
    require(is_undecided(claims.regular->verdict) ? has_form(solid, *claims.regular)
                                                  : follows(solid, *claims.regular),
            name, "regular", at + place("regular"));
    require(is_undecided(claims.embedded->verdict)
                ? has_form(*claims.embedded)
                : follows(solid, *claims.embedded, *claims.regular),
            name, "embedded", at + place("embedded"));
    verify_joints(solid, name, claims, tolerance, at);
  }
  require(!claims.mesh || mesh_follows(solid, *claims.mesh, is_hub), name, "mesh",
          at + place("mesh"));
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
              parts[i].name, "joined", place("parts", i, "joined", at(end)));
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
                     const CanalFillet& loop, const LoopClaims& claims, double tolerance,
                     const std::string& at) {
  std::array<const Piece*, 2> pipes{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Solid& pipe = solids[fillet.between.at(side)];
    require(!pipe.pieces().empty() && is_same(loop.quadrics.at(side), end_ring(pipe, End::end)) &&
                !loop.quadrics.at(side).ellipse,
            fillet.name, "between", at);
    require(is_straight(pipe), fillet.name, "between", at);
    pipes.at(side) = &pipe.pieces().front();
  }
  if (const auto& contact = claims.contact) {
    const auto [starts, difference] = rolled_pipes(loop.quadrics, pipes);
    require(touches_between(loop, starts, tolerance), fillet.name, "between",
            at + place("contact"));
    require(follows(loop, about_quadrics(*contact, difference)) && contact->offset <= tolerance,
            fillet.name, "contact", at + place("contact"));
  }
  auto cells = regular_cells(loop, claims.regular);
  require(cells || (is_undecided(claims.regular.verdict) && has_form(claims.regular)), fillet.name,
          "regular", at + place("regular"));
  require(is_undecided(claims.embedded.verdict) ? has_form(claims.embedded)
                                                : cells && follows(loop, *cells, claims.embedded),
          fillet.name, "embedded", at + place("embedded"));
  require(!claims.mesh || (cells && follows(*cells, *claims.mesh)), fillet.name, "mesh",
          at + place("mesh"));
  return {&loop, cells ? std::move(*cells) : std::vector<ArcCell>()};
}

std::vector<Solid> verify_parts(const Certificate& certificate,
                                const std::set<std::uint32_t>& hubs) {
  const auto& parts = certificate.parts;
  std::vector<std::optional<Solid>> found(parts.size());
  verify_each(parts.size(), [&](std::size_t i) {
    verify_part(found[i].emplace(parts[i]), parts[i].name, certificate.claims[i],
                certificate.tolerance, hubs.contains(std::uint32_t(i)), place("claims", i));
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
  require(certificate.fillet_claims.size() == fillets.size(), "", "fillets",
          place("fillet_claims"));
  std::vector<std::vector<LoopArcs>> arcs(fillets.size());
  verify_each(fillets.size(), [&](std::size_t i) {
    const auto& claims = certificate.fillet_claims[i];
    const auto& loops = fillets[i].loops;
    require(!loops.empty() && loops.size() == claims.size(), fillets[i].name, "loops",
            place("fillet_claims", i));
    admit(fillets[i]);
    arcs[i].clear();
    for (std::size_t k = 0; k < loops.size(); ++k) {
      arcs[i].push_back(verify_loop(solids, fillets[i], loops[k], claims[k], certificate.tolerance,
                                    place("fillet_claims", i, k)));
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
  require(is_name(certificate.document), "", "document", place("document"));
  require(is_bound(certificate.tolerance), "", "tolerance", place("tolerance"));
  require(is_bound(certificate.apart), "", "apart", place("apart"));
  require(!certificate.axes ||
              (certificate.apart > 0 &&
               std::all_of(certificate.axes->begin(), certificate.axes->end(), is_point)),
          "", "axes", place("axes"));
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
    require(is_name(part.name) && is_name(part.kind) && names.insert(part.name).second, "", "name",
            place("parts", i, "name"));  // of which nothing is repeated: it would be printed
    for (const End end : {End::start, End::end}) {
      const auto& joined = part.joined.at(at(end));
      require(!joined || says_back({i, end}, *joined), part.name, "joined",
              place("parts", i, "joined", at(end)));
    }
  }
  for (std::size_t i = 0; i < certificate.fillets.size(); ++i) {
    const CertifiedFillet& fillet = certificate.fillets[i];
    require(is_name(fillet.name) && names.insert(fillet.name).second, "", "name",
            place("fillets", i, "name"));
    require(std::max(fillet.between[0], fillet.between[1]) < certificate.parts.size() &&
                fillet.between[0] != fillet.between[1],
            fillet.name, "between", place("fillets", i, "between"));
  }
}

// Arms and their hubs, of which one comes after the other.
using HubPairs = std::set<PartPair>;

std::set<std::uint32_t> hubs_of(const Certificate& certificate) {
  std::set<std::uint32_t> result;
  for (const CertifiedJunction& junction : certificate.junctions) {
    require(junction.hub < certificate.parts.size() && result.insert(junction.hub).second, "",
            "junctions", place("junctions"));
  }
  return result;
}

HubPairs verify_junctions(const std::vector<Solid>& solids, const Certificate& certificate) {
  HubPairs result;
  std::set<std::uint32_t> all_arms;
  for (std::size_t i = 0; i < certificate.junctions.size(); ++i) {
    const auto& [hub, arms] = certificate.junctions[i];
    const std::string its = place("junctions", i), &name = certificate.parts[hub].name;
    const Sphere* ball = solids[hub].ball();
    require(ball != nullptr && arms.size() >= 2, name, "junction", its);
    for (auto arm = arms.begin(); arm != arms.end(); ++arm) {
      require(*arm < hub && is_arm(solids[*arm], *ball) && all_arms.insert(*arm).second, name,
              "arms", its);
      require(!certificate.parts[*arm].joined.at(at(End::end)), name, "arms", its);
      require(std::all_of(arms.begin(), arm,
                          [&](std::uint32_t other) {
                            return caps_are_disjoint(solids[other], solids[*arm]);
                          }),
              name, "caps", its);
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

// Lists of claims about pairs are in order. Where one is in the place of another, the other is
// missing, or there and behind, or the one has no business in the list.
[[noreturn]] void refuse_missing(const Certificate& certificate, const PartPair& pair,
                                 const std::string& place) {
  refuse("has no claim 'clearance of " + certificate.surface_name(pair[1]) + "'",
         certificate.surface_name(pair[0]), place);
}

[[noreturn]] void refuse_order(const std::string& place) {
  refuse("the claim 'clearance' is one too many, or out of order", "", place);
}

PartPair pair_of(const ClearanceClaim& claim) { return {claim.first, claim.second}; }

// That the one at the index is about the pair.
void require_pair(const Certificate& certificate, const std::string& list, std::size_t index,
                  const PartPair& pair) {
  const auto& claims =
      list == "clearances" ? certificate.clearances : certificate.fillet_clearances;
  if (index < claims.size() && pair_of(claims[index]) == pair) {
    return;
  }
  if (std::ranges::find(claims, pair, pair_of) == claims.end()) {
    refuse_missing(certificate, pair, index < claims.size() ? place(list, index) : place(list));
  }
  refuse_order(place(list, index));
}

void verify_clearance(const std::vector<Solid>& solids, const Certificate& certificate,
                      const HubPairs& hub_pairs, std::size_t index) {
  const auto& claim = certificate.clearances[index];
  require(follows_or_is_silent(solids, certificate, hub_pairs, claim),
          certificate.parts[claim.first].name,
          "clearance of " + certificate.parts[claim.second].name, place("clearances", index));
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
    require_pair(certificate, "clearances", i, pairs[i]);
    verify_clearance(solids, certificate, hub_pairs, i);
  });
  if (claims.size() > pairs.size()) {
    refuse_order(place("clearances", pairs.size()));
  }
}

// Those that have a claim, in order and each once; none is missing that may be closer than is
// claimed of the others.
void verify_near_pairs(const std::vector<Solid>& solids, const Certificate& certificate,
                       const HubPairs& hub_pairs) {
  const auto near = pairs_nearer_than(certificate.apart, certificate.axes, solids);
  const auto& claims = certificate.clearances;
  verify_each(claims.size(), [&](std::size_t i) {
    const PartPair before = i == 0 ? PartPair{0, 0} : pair_of(claims[i - 1]),
                   pair = pair_of(claims[i]);
    if (!(before < pair && pair[0] < pair[1] && pair[1] < solids.size())) {
      refuse_order(place("clearances", i));
    }
    verify_clearance(solids, certificate, hub_pairs, i);
  });
  auto missing = near.begin();
  for (std::size_t i = 0; i < claims.size(); ++i) {
    missing += missing != near.end() && *missing == pair_of(claims[i]) ? 1 : 0;
  }
  if (missing != near.end()) {
    refuse_missing(certificate, *missing, place("clearances"));
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

void verify_fillet_clearance(const std::vector<Solid>& solids, const Loops& loops,
                             const Certificate& certificate, std::size_t index) {
  const std::size_t parts = solids.size();
  const ClearanceClaim& claim = certificate.fillet_clearances[index];
  const auto holds = [&] {
    const LoopArcs& arcs = loops.arcs[claim.second - parts];
    return claim.first < parts ? follows(solids[claim.first], arcs, claim)
                               : follows(loops.arcs[claim.first - parts], arcs, claim);
  };
  require((is_undecided(claim.verdict) ? has_form(claim) : holds()) &&
              claim.corner <= certificate.tolerance,
          certificate.surface_name(claim.first),
          "clearance of " + certificate.surface_name(claim.second),
          place("fillet_clearances", index));
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
    require_pair(certificate, "fillet_clearances", i, pairs[i]);
    verify_fillet_clearance(solids, loops, certificate, i);
  });
  if (claims.size() > pairs.size()) {
    refuse_order(place("fillet_clearances", pairs.size()));
  }
}

// As verify_near_pairs does.
void verify_near_fillet_pairs(const std::vector<Solid>& solids, const Loops& loops,
                              const Certificate& certificate) {
  const std::size_t parts = solids.size();
  auto near = loop_pairs_nearer_than(certificate.apart, certificate.axes, solids, loops.arcs);
  std::erase_if(near, [&](const PartPair& pair) { return !is_pair(pair, loops, parts); });
  const auto& claims = certificate.fillet_clearances;
  verify_each(claims.size(), [&](std::size_t i) {
    const PartPair pair = pair_of(claims[i]);
    if (!is_pair(pair, loops, parts) ||
        (i > 0 && !(place_of(pair_of(claims[i - 1]), parts) < place_of(pair, parts)))) {
      refuse_order(place("fillet_clearances", i));
    }
    verify_fillet_clearance(solids, loops, certificate, i);
  });
  auto missing = near.begin();
  for (std::size_t i = 0; i < claims.size(); ++i) {
    missing += missing != near.end() && *missing == pair_of(claims[i]) ? 1 : 0;
  }
  if (missing != near.end()) {
    refuse_missing(certificate, *missing, place("fillet_clearances"));
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
  verification::require(certificate.claims.size() == parts.size(), "", "parts", "/claims");
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
