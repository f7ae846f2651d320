#include "dupin/blends/certify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "assembly/cost_limit.h"
#include "assembly/fillet_overlap.h"
#include "assembly/filleted_runs.h"
#include "assembly/joined_hubs.h"
#include "assembly/part_box.h"
#include "assembly/part_context.h"
#include "assembly/welded_runs.h"
#include "certification/checked_claims.h"
#include "certification/claim_work.h"
#include "certification/mesh_claims.h"
#include "certification/part_pairs.h"
#include "certification/prove_fillet.h"
#include "certification/prove_hub.h"
#include "certification/prove_loop_clearance.h"
#include "certification/prove_regular.h"
#include "certification/swept_disc_pairs.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin {
namespace {

using certification::ClaimWork;
using certification::for_each_claim;
using certification::SearchWork;
using certification::SweptDiscs;
using verification::PartPair;

std::vector<certification::JoinedEnds> joints(const CertifiedPart& part, std::uint32_t other) {
  std::vector<certification::JoinedEnds> result;
  for (const End end : {End::start, End::end}) {
    const auto& joined = part.joined.at(at(end));
    if (joined && joined->part == other) {
      result.push_back({end, joined->end});
    }
  }
  return result;
}

CertifiedInputs inputs_of(const ResolvedAssembly& resolved) {
  CertifiedInputs result;
  for (const ResolvedPart& part : resolved.parts) {
    result.parts.push_back({part.name, part.kind, part.shape, part.joined});
  }
  for (const ResolvedFillet& fillet : resolved.fillets) {
    if (!fillet.shape.is_cope()) {  // it adds no surface to those of its pipes
      result.fillets.push_back(
          {fillet.name, fillet.between, fillet.shape.buried, fillet.shape.loops});
    }
  }
  for (const ResolvedJunction& junction : resolved.junctions) {
    result.junctions.push_back({std::uint32_t(result.parts.size()), junction.arms});
    result.parts.push_back({junction.name, "junction", junction.shape.hub, {}});
  }
  return result;
}

// So much a pair of parts that are far from each other costs, whatever else the work goes to.
constexpr std::uint64_t kWorkOfPair = 8;

// Boxes that all pairs together may take for tight bounds of their distances, and each at least.
constexpr std::size_t kTightOfAll = 1 << 16, kLeastTight = 1 << 7;

// Of so many parts each pair has a claim of its own if nothing else is asked for.
constexpr std::size_t kFewParts = 64;

// What is asked for each kFewParts of them.
std::uint64_t work_of_parts(std::uint64_t work, std::size_t parts) {
  const std::uint64_t times = 1 + (std::max<std::size_t>(parts, 1) - 1) / kFewParts;
  return work <= std::numeric_limits<std::uint64_t>::max() / times ? work * times : work;
}

double default_distance(const Assembly& assembly, std::size_t parts) {
  return parts <= kFewParts ? 0 : 2 * assembly.tolerance;
}

// Arcs are not divided further than the leaves of the claim that their loop is regular.
constexpr std::size_t kBoxesOfLoop = 1 << 11;

class Certifier {
 public:
  Certifier(const Assembly& assembly, const CertifyOptions& options)
      : assembly_(assembly),
        options_(options),
        resolved_(resolve(assembly)),
        grid_(assembly::lattice_spacing(assembly, resolved_)),
        runs_(assembly::welded_runs(resolved_)),
        left_{0, CertificateLimits::kWork} {
    assembly::refuse_too_costly(assembly_, resolved_, runs_, grid_, options_.most_triangles);
  }

  Certificate run() {
    result_.document = assembly_.source;
    result_.unit = assembly_.unit;
    result_.tolerance = assembly_.tolerance;
    CertifiedInputs inputs = inputs_of(resolved_);
    result_.parts = std::move(inputs.parts);
    result_.fillets = std::move(inputs.fillets);
    result_.junctions = std::move(inputs.junctions);
    left_.searches = work_of_parts(options_.work, result_.parts.size());
    certification::reserve_for(result_.junctions, left_);
    tell(options_.progress, "certify parts");
    admit_parts();
    find_near_pairs();
    append_parts();
    tell(options_.progress, "certify meshes");
    append_first_meshes();
    tell(options_.progress, "certify clearances");
    append_clearances();
    append_fillet_clearances();
    append_waiting_meshes();
    return std::move(result_);
  }

 private:
  void admit_parts() {
    std::vector<std::optional<verification::Solid>> solids(result_.parts.size());
    for_each_claim(solids.size(), left_, [&](std::size_t i, ClaimWork& work) {
      solids[i] = certification::admitted(result_.parts[i], work);
    });
    for (auto& solid : solids) {
      solids_.push_back(std::move(*solid));
    }
  }

  void append_parts() {
    std::vector<std::optional<SweptDiscs>> sweeps(result_.parts.size());
    result_.claims.resize(result_.parts.size());
    for_each_claim(result_.parts.size(), left_, [&](std::size_t i, ClaimWork& work) {
      const CertifiedPart& part = result_.parts[i];
      sweeps[i] =
          std::visit([&](const auto& s) { return SweptDiscs(s, &work.searches()); }, part.shape);
      result_.claims[i] = std::visit(
          [&](const auto& s) { return claims(s, *sweeps[i], solids_[i], part.name, work); },
          part.shape);
    });
    for (const auto& sweep : sweeps) {
      sweeps_.push_back(sweep->with(nullptr));
    }
  }

  static PartClaims claims(const Sphere&, const SweptDiscs&, const verification::Solid&,
                           const std::string&, ClaimWork&) {
    return {};
  }

  [[nodiscard]] PartClaims claims(const Chain& chain, const SweptDiscs& sweep,
                                  const verification::Solid& solid, const std::string& name,
                                  ClaimWork& work) const {
    PartClaims result;
    result.regular.emplace();
    result.embedded.emplace();
    if (sweep.length() == 0) {
      return result;
    }
    // First, for without it there is no certificate.
    for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
      for (const auto end : {End::start, End::end}) {
        result.tangency.push_back(certification::agreed(
            std::visit([=](const auto& p) { return surfaces::tangency_claim(p, end); },
                       chain.pieces[i]),
            {i, end}, assembly_.tolerance, solid, name, work));
      }
    }
    result.regular =
        certification::agreed(certification::prove_regular(chain, options_.margin), solid, work);
    if (result.regular->verdict == Verdict::proved) {
      result.embedded = embedded(sweep, solid, *result.regular, work);
    }
    return result;
  }

  // The checker's intervals are wider on long ways than the prover's; shorter ones take more work.
  [[nodiscard]] EmbeddedClaim embedded(const SweptDiscs& sweep, const verification::Solid& solid,
                                       const RegularClaim& regular, ClaimWork& work) const {
    constexpr double kShortestWay = 1.0 / 32;
    for (double way = certification::kLongestWay;; way /= 4) {
      EmbeddedClaim found =
          certification::prove_embedded(sweep, regular.margin, options_.boxes, way);
      const bool is_open = found.verdict == Verdict::undecided;
      EmbeddedClaim agreed = certification::agreed(std::move(found), regular, solid, work);
      if (is_open || agreed.verdict != Verdict::undecided || work.lacks_work() ||
          way <= kShortestWay) {
        return agreed;
      }
    }
  }

  void append_meshes() {
    waiting_meshes_.resize(result_.parts.size());
    std::vector<RingSampling> samplings(resolved_.parts.size());
    std::set<std::uint32_t> trimmed;
    for (const ResolvedFillet& fillet : resolved_.fillets) {
      trimmed.insert(fillet.between.begin(), fillet.between.end());
    }
    std::vector<std::uint32_t> whole;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const RingSampling sampling =
          assembly::run_sampling(assembly_, resolved_, runs_[i], i, grid_);
      for (const auto part : runs_[i].parts) {
        samplings[part] = sampling;
        if (!trimmed.contains(part)) {
          whole.push_back(part);
        }
      }
    }
    for_each_claim(whole.size(), left_, [&](std::size_t i, ClaimWork& work) {
      const ResolvedPart& part = resolved_.parts[whole[i]];
      auto claim = assembly::with_part_context(
          assembly_, part.index, [&] { return mesh_claim(part.shape, samplings[whole[i]]); });
      agree_mesh(whole[i], std::move(claim), work);
    });
    append_fillets(samplings, trimmed);
    append_hubs(samplings);
  }

  void append_hubs(const std::vector<RingSampling>& samplings) {
    for_each_claim(resolved_.junctions.size(), left_, [&](std::size_t i, ClaimWork& work) {
      const ResolvedJunction& junction = resolved_.junctions[i];
      std::vector<RingSampling> of_arms;
      std::uint32_t fewest = CertificateLimits::kSegments;
      for (const std::uint32_t arm : junction.arms) {
        of_arms.push_back(samplings[arm]);
        fewest = std::min(fewest, samplings[arm].segments);
      }
      const Tessellation hub =
          assembly::hub_tessellation(assembly_, junction, of_arms, options_.most_triangles);
      result_.claims[result_.junctions[i].hub].mesh = certification::agreed_of_hub(
          certification::hub_mesh_claim(junction.shape.hub, hub.mesh, fewest, grid_),
          junction.shape.hub, work);
    });
  }

  [[nodiscard]] std::optional<MeshClaim> mesh_claim(const PartSurface& shape,
                                                    const RingSampling& sampling) const {
    return std::visit(
        [&](const auto& s) { return certification::mesh_claim(s, sampling, assembly_.tolerance); },
        shape);
  }

  void agree_mesh(std::uint32_t part, std::optional<MeshClaim> claim, ClaimWork& work) {
    waiting_meshes_[part].reset();
    if (!claim) {
      return;
    }
    const bool is_of_many = result_.parts.size() > kFewParts;
    result_.claims[part].mesh = certification::agreed(
        *claim, solids_[part],
        is_of_many ? certification::rooms_of_many(claim->error_bound / assembly_.tolerance)
                   : certification::first_rooms(),
        work);
    if (!result_.claims[part].mesh && work.lacks_work()) {
      waiting_meshes_[part] = std::move(claim);
    }
  }

  // Of meshes that a tight bound took too much work of: what clearances have left.
  void append_waiting_meshes() {
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t i = 0; i < waiting_meshes_.size(); ++i) {
      if (waiting_meshes_[i]) {
        waiting.push_back(i);
      }
    }
    for_each_claim(waiting.size(), left_, [&](std::size_t i, ClaimWork& work) {
      const std::uint32_t part = waiting[i];
      const MeshClaim& claim = *waiting_meshes_[part];
      result_.claims[part].mesh = certification::agreed(
          claim, solids_[part], certification::last_rooms(claim.error_bound / assembly_.tolerance),
          work);
    });
  }

  void append_fillets(const std::vector<RingSampling>& samplings,
                      const std::set<std::uint32_t>& trimmed) {
    std::vector<std::vector<surfaces::FilletMesh>> meshes(resolved_.fillets.size());
    std::vector<std::size_t> first_loop;
    for (const ResolvedFillet& fillet : resolved_.fillets) {
      first_loop.push_back(loops_.size());
      if (!fillet.shape.is_cope()) {
        for (const CanalFillet& loop : fillet.shape.loops) {
          loops_.push_back({&loop, {}});
        }
      }
    }
    std::vector<std::vector<LoopClaims>> claims(meshes.size());
    for_each_claim(meshes.size(), left_, [&](std::size_t i, ClaimWork& work) {
      const ResolvedFillet& fillet = resolved_.fillets[i];
      meshes[i] = assembly::fillet_meshes(
          assembly_, fillet, {samplings[fillet.between[0]], samplings[fillet.between[1]]},
          options_.most_triangles);
      if (!fillet.shape.is_cope()) {
        claims[i] = assembly::with_part_context(assembly_, fillet.index, [&] {
          return fillet_claims(&loops_[first_loop[i]], fillet.between, meshes[i], work);
        });
      }
    });
    for (std::size_t i = 0; i < claims.size(); ++i) {
      if (!resolved_.fillets[i].shape.is_cope()) {
        result_.fillet_claims.push_back(std::move(claims[i]));
      }
    }
    append_trimmed({trimmed.begin(), trimmed.end()}, samplings, meshes);
  }

  // Of a straight pipe's mesh it counts only how far its triangles go about the axis.
  void append_trimmed(const std::vector<std::uint32_t>& trimmed,
                      const std::vector<RingSampling>& samplings,
                      const std::vector<std::vector<surfaces::FilletMesh>>& meshes) {
    for_each_claim(trimmed.size(), left_, [&](std::size_t i, ClaimWork& work) {
      const std::uint32_t part = trimmed[i];
      const Tessellation face = face_of(part, samplings, meshes);
      const Ring ring = end_ring(std::get<Chain>(result_.parts[part].shape), End::end);
      const double turn = certification::widest_turn(face.mesh, ring, grid_) * (1 + 0x1p-40);
      const auto segments = std::uint32_t(2 * std::numbers::pi / turn);
      agree_mesh(part, MeshClaim{segments, grid_, {0, 1}, face.error_bound, face.axes}, work);
    });
  }

  [[nodiscard]] Tessellation face_of(
      std::uint32_t part, const std::vector<RingSampling>& samplings,
      const std::vector<std::vector<surfaces::FilletMesh>>& meshes) const {
    try {
      return assembly::trimmed(resolved_, part, samplings[part], meshes);
    } catch (const Error& error) {
      std::map<std::uint32_t, RingSampling> by_part;
      for (std::uint32_t i = 0; i < samplings.size(); ++i) {
        by_part.emplace(i, samplings[i]);
      }
      throw assembly::trim_refusal(assembly_, resolved_, part, by_part, meshes, error);
    }
  }

  [[nodiscard]] std::vector<LoopClaims> fillet_claims(
      verification::LoopArcs* loops, const std::array<std::uint32_t, 2>& pipes,
      const std::vector<surfaces::FilletMesh>& meshes, ClaimWork& work) const {
    const verification::RolledPipes rolled = verification::rolled_pipes(
        loops[0].loop->quadrics,
        {&solids_[pipes[0]].pieces().front(), &solids_[pipes[1]].pieces().front()});
    std::vector<LoopClaims> claims;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      loops[i].cells.clear();
      claims.push_back(certification::agreed(
          certification::prove_loop(*loops[i].loop,
                                    {meshes[i].tessellation.knots, meshes[i].columns, grid_},
                                    {options_.margin, options_.boxes, assembly_.tolerance}),
          loops[i], rolled, assembly_.tolerance, work));
    }
    return claims;
  }

  // Before what may take all of the work: without them there is a claim for each pair.
  void find_near_pairs() {
    result_.apart = options_.apart.value_or(default_distance(assembly_, solids_.size()));
    std::optional<std::vector<PartPair>> pairs;
    if (result_.apart > 0) {
      result_.axes = directions_of_parts();
      for_each_claim(1, left_, [&](std::size_t, ClaimWork& work) {
        pairs = certification::pairs_nearer_than(result_.apart, result_.axes, solids_, work);
      });
    }
    if (!pairs) {
      result_.apart = 0;
      result_.axes.reset();
    }
    pairs_ = pairs ? std::move(*pairs) : certification::all_pairs(std::uint32_t(solids_.size()));
  }

  // Of many parts they would take all of the work: half of it is for the clearances.
  void append_first_meshes() {
    certification::WorkLeft kept;
    if (result_.parts.size() > kFewParts) {
      kept = {0, left_.checks / 2, certification::kMostRefused / 2};
      left_.checks -= kept.checks;
      left_.refused += kept.refused;
    }
    append_meshes();
    left_.checks += kept.checks;
    left_.refused -= kept.refused;
  }

  void append_clearances() {
    allow(kWorkOfPair * pairs_.size());
    tight_ = std::max(kLeastTight, kTightOfAll / std::max<std::size_t>(pairs_.size(), 1));
    const auto at_hubs = arms_and_hubs();
    result_.clearances.resize(pairs_.size());
    const auto order = certification::easiest_first(pairs_, result_.parts);
    for_each_claim(order.size(), left_, [&](std::size_t turn, ClaimWork& work) {
      const std::size_t i = order[turn];
      const PartPair& pair = pairs_[i];
      const auto [first, second] = pair;
      const bool is_at_hub = at_hubs.contains(pair);
      ClearanceClaim claim =
          is_at_hub
              ? certification::prove_at_hub(
                    solids_[first], std::get<Sphere>(result_.parts[second].shape), options_.boxes)
              : clearance(first, second, work);
      claim.first = first;
      claim.second = second;
      result_.clearances[i] = is_at_hub
                                  ? certification::agreed_at_hub(std::move(claim), solids_, work)
                                  : certification::agreed(std::move(claim), result_.parts, solids_,
                                                          assembly_.tolerance, work);
    });
  }

  [[nodiscard]] std::optional<Directions> directions_of_parts() const {
    std::vector<const PartSurface*> shapes;
    for (const CertifiedPart& part : result_.parts) {
      shapes.push_back(&part.shape);
    }
    const auto axes = assembly::main_axes(shapes);
    return axes ? std::optional(Directions{axes->right, axes->up, axes->towards}) : std::nullopt;
  }

  void allow(std::uint64_t units) {
    left_.searches += std::min(units, std::numeric_limits<std::uint64_t>::max() - left_.searches);
  }

  [[nodiscard]] std::set<PartPair> arms_and_hubs() const {
    std::set<PartPair> result;
    for (const CertifiedJunction& junction : result_.junctions) {
      for (const std::uint32_t arm : junction.arms) {
        result.insert({arm, junction.hub});
      }
    }
    return result;
  }

  // Of every loop and every part but its pipes, then every later loop; or of those that are near.
  void append_fillet_clearances() {
    std::vector<SweptDiscs> arcs;
    std::vector<const CertifiedFillet*> fillet_of;
    for (const auto& loop : loops_) {
      arcs.push_back(certification::swept_arcs(loop));
    }
    for (const CertifiedFillet& fillet : result_.fillets) {
      fillet_of.insert(fillet_of.end(), fillet.loops.size(), &fillet);
    }
    auto pairs = loop_pairs();
    allow(kWorkOfPair * pairs.size());
    std::erase_if(pairs, [&](const PartPair& pair) {
      return pair[0] < sweeps_.size() &&
             std::ranges::count(fillet_of[pair[1] - sweeps_.size()]->between, pair[0]) > 0;
    });
    result_.fillet_clearances.resize(pairs.size());
    for_each_claim(pairs.size(), left_, [&](std::size_t i, ClaimWork& work) {
      result_.fillet_clearances[i] = fillet_clearance(pairs[i], arcs, work);
    });
  }

  [[nodiscard]] ClearanceClaim fillet_clearance(const PartPair& pair,
                                                const std::vector<SweptDiscs>& arcs,
                                                ClaimWork& work) const {
    const certification::ClearanceGoals goals{std::min(options_.boxes, kBoxesOfLoop),
                                              assembly_.tolerance};
    const auto [first, second] = pair;
    const std::size_t parts = sweeps_.size(), k = second - parts;
    SearchWork* searches = &work.searches();
    const SweptDiscs own = (first < parts ? sweeps_[first] : arcs[first - parts]).with(searches),
                     other = arcs[k].with(searches);
    ClearanceClaim claim =
        first < parts
            ? certification::prove_clearance(certification::SweptPart{solids_[first], own},
                                             {loops_[k], other}, goals)
            : certification::prove_clearance(certification::SweptLoop{loops_[first - parts], own},
                                             {loops_[k], other}, goals);
    claim.first = first;
    claim.second = second;
    return certification::agreed(std::move(claim), solids_, loops_, work);
  }

  // In the order of the certificate.
  [[nodiscard]] std::vector<PartPair> loop_pairs() {
    const auto parts = std::uint32_t(sweeps_.size());
    const auto surfaces = parts + std::uint32_t(loops_.size());
    if (result_.apart > 0 && surfaces > parts) {
      std::optional<std::vector<PartPair>> near;
      for_each_claim(1, left_, [&](std::size_t, ClaimWork& work) {
        near = certification::loop_pairs_nearer_than(result_.apart, result_.axes, solids_, loops_,
                                                     work);
      });
      if (near) {
        return std::move(*near);
      }
    }
    std::vector<PartPair> pairs;
    for (std::uint32_t k = parts; k < surfaces; ++k) {
      for (std::uint32_t i = 0; i < parts; ++i) {
        pairs.push_back({i, k});
      }
      for (std::uint32_t j = k + 1; j < surfaces; ++j) {
        pairs.push_back({k, j});
      }
    }
    return pairs;
  }

  [[nodiscard]] ClearanceClaim clearance(std::uint32_t i, std::uint32_t j, ClaimWork& work) const {
    const auto ends = joints(result_.parts[i], j);
    if (sweeps_[i].length() == 0 || sweeps_[j].length() == 0) {
      return {};
    }
    const SweptDiscs first = sweeps_[i].with(&work.searches()),
                     second = sweeps_[j].with(&work.searches());
    return ends.empty() ? certification::prove_clearance(first, second, options_.boxes, tight_)
                        : certification::prove_joint(first, second, ends, options_.boxes);
  }

  const Assembly& assembly_;
  const CertifyOptions& options_;
  ResolvedAssembly resolved_;
  double grid_;  // of the meshes
  std::vector<assembly::WeldedRun> runs_;
  certification::WorkLeft left_;
  std::vector<PartPair> pairs_;
  std::size_t tight_ = 0;  // boxes of a pair
  std::vector<SweptDiscs> sweeps_;
  std::vector<verification::Solid> solids_;
  std::vector<verification::LoopArcs> loops_;
  std::vector<std::optional<MeshClaim>> waiting_meshes_;  // by part
  Certificate result_;
};

}  // namespace

std::size_t Certificate::findings() const {
  std::size_t count = 0;
  for (const PartClaims& part : claims) {
    count += part.regular && part.regular->verdict != Verdict::proved ? 1 : 0;
    count += part.embedded && part.embedded->verdict != Verdict::proved ? 1 : 0;
    count += part.mesh ? 0 : 1;
  }
  for (const auto& loops : fillet_claims) {
    for (const LoopClaims& loop : loops) {
      count += loop.regular.verdict != Verdict::proved ? 1 : 0;
      count += loop.embedded.verdict != Verdict::proved ? 1 : 0;
      count += (loop.contact ? 0 : 1) + (loop.mesh ? 0 : 1);
    }
  }
  const auto is_open = [](const ClearanceClaim& claim) { return claim.verdict != Verdict::proved; };
  return count + std::size_t(std::ranges::count_if(clearances, is_open) +
                             std::ranges::count_if(fillet_clearances, is_open));
}

const std::string& Certificate::surface_name(std::uint32_t surface) const {
  if (surface < parts.size()) {
    return parts[surface].name;
  }
  std::size_t loop = surface - parts.size(), fillet = 0;
  while (loop >= fillets.at(fillet).loops.size()) {
    loop -= fillets[fillet++].loops.size();
  }
  return fillets[fillet].name;
}

bool Certificate::joined(const ClearanceClaim& claim) const {
  const bool at_hub = std::ranges::any_of(junctions, [&](const CertifiedJunction& junction) {
    return junction.hub == claim.second && std::ranges::count(junction.arms, claim.first) > 0;
  });
  return at_hub || !joints(parts[claim.first], claim.second).empty();
}

CertifiedInputs certified_inputs(const Assembly& assembly) {
  const UsualArithmetic usual;
  return inputs_of(resolve(assembly));
}

Certificate certify(const Assembly& assembly, const CertifyOptions& options) {
  const UsualArithmetic usual;
  if (options.margin && !(*options.margin >= 0 && *options.margin < 1)) {
    throw Error(Errc::invalid_argument,
                "the margin to prove must be at least 0 and less than 1, not " +
                    decimal(*options.margin, kMessageDigits));
  }
  if (options.apart && !(*options.apart >= 0 && std::isfinite(*options.apart))) {
    throw Error(Errc::invalid_argument,
                "the distance of pairs without a claim must be finite and not negative, not " +
                    decimal(*options.apart, kMessageDigits));
  }
  return Certifier(assembly, options).run();
}

}  // namespace dupin
