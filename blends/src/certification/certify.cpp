#include "dupin/blends/certify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include <Eigen/Geometry>

#include "assembly/cost_limit.h"
#include "assembly/fillet_overlap.h"
#include "assembly/filleted_runs.h"
#include "assembly/joined_hubs.h"
#include "assembly/part_context.h"
#include "assembly/welded_runs.h"
#include "certification/checked_claims.h"
#include "certification/mesh_claims.h"
#include "certification/prove_fillet.h"
#include "certification/prove_hub.h"
#include "certification/prove_loop_clearance.h"
#include "certification/prove_regular.h"
#include "certification/swept_disc_pairs.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin {
namespace {

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

// Of so many parts each pair has a claim of its own if nothing else is asked for.
constexpr std::size_t kFewParts = 64;

double default_distance(const Assembly& assembly, std::size_t parts) {
  return parts <= kFewParts ? 0 : 2 * assembly.tolerance;
}

std::vector<verification::PartPair> all_pairs(std::uint32_t parts) {
  std::vector<verification::PartPair> pairs;
  for (std::uint32_t i = 0; i < parts; ++i) {
    for (std::uint32_t j = i + 1; j < parts; ++j) {
      pairs.push_back({i, j});
    }
  }
  return pairs;
}

// Arcs are not divided further than the leaves of the claim that their loop is regular.
constexpr std::size_t kBoxesOfLoop = 1 << 11;

// The largest angle about a ring's axis that a triangle spans, but for what rounding its corners to
// the grid adds: claims count that by itself.
double widest_turn(const TriMesh& mesh, const Ring& ring, double grid) {
  const double moved = std::numbers::sqrt3 / 2 * grid;
  const auto arm = [&](std::uint32_t vertex) -> Vec3 {
    const Vec3 from = mesh.points[vertex] - ring.center;
    return from - from.dot(ring.normal) * ring.normal;
  };
  double widest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = arm(t.at(i)), b = arm(t.at((i + 1) % 3));
      widest = std::max(
          widest, std::atan2(a.cross(b).norm(), a.dot(b)) - moved / a.norm() - moved / b.norm());
    }
  }
  return widest;
}

class Certifier {
 public:
  Certifier(const Assembly& assembly, const CertifyOptions& options)
      : assembly_(assembly), options_(options), resolved_(resolve(assembly)), work_(options.work) {}

  Certificate run() {
    result_.document = assembly_.source;
    result_.unit = assembly_.unit;
    result_.tolerance = assembly_.tolerance;
    CertifiedInputs inputs = inputs_of(resolved_);
    result_.parts = std::move(inputs.parts);
    result_.fillets = std::move(inputs.fillets);
    result_.junctions = std::move(inputs.junctions);
    checker_.reserve_for(result_.junctions);
    for (const CertifiedPart& part : result_.parts) {
      sweeps_.push_back(std::visit(
          [&](const auto& s) { return certification::SweptDiscs(s, &work_); }, part.shape));
      checker_.read(part);
      result_.claims.push_back(
          std::visit([&](const auto& s) { return claims(s, sweeps_.back()); }, part.shape));
    }
    append_meshes();
    append_clearances();
    append_fillet_clearances();
    return std::move(result_);
  }

 private:
  static PartClaims claims(const Sphere&, const certification::SweptDiscs&) { return {}; }

  [[nodiscard]] PartClaims claims(const Chain& chain, const certification::SweptDiscs& sweep) {
    PartClaims result;
    result.regular.emplace();
    result.embedded.emplace();
    if (sweep.length() == 0) {
      return result;
    }
    // First, for without it there is no certificate.
    for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
      for (const auto end : {End::start, End::end}) {
        result.tangency.push_back(checker_.agreed(
            std::visit([=](const auto& p) { return surfaces::tangency_claim(p, end); },
                       chain.pieces[i]),
            i, end, assembly_.tolerance));
      }
    }
    result.regular = checker_.agreed(certification::prove_regular(chain, options_.margin));
    if (result.regular->verdict == Verdict::proved) {
      result.embedded = embedded(sweep, *result.regular);
    }
    return result;
  }

  // The checker's intervals are wider on long ways than the prover's; shorter ones take more work.
  [[nodiscard]] EmbeddedClaim embedded(const certification::SweptDiscs& sweep,
                                       const RegularClaim& regular) {
    constexpr double kShortestWay = 1.0 / 32;
    for (double way = certification::kLongestWay;; way /= 4) {
      EmbeddedClaim found =
          certification::prove_embedded(sweep, regular.margin, options_.boxes, way);
      const bool is_open = found.verdict == Verdict::undecided;
      EmbeddedClaim agreed = checker_.agreed(std::move(found), regular);
      if (is_open || agreed.verdict != Verdict::undecided || checker_.lacks_work() ||
          way <= kShortestWay) {
        return agreed;
      }
    }
  }

  void append_meshes() {
    const double grid = assembly::lattice_spacing(assembly_, resolved_);
    const auto runs = assembly::welded_runs(resolved_);
    assembly::refuse_too_costly(assembly_, resolved_, runs, grid, options_.most_triangles);
    std::vector<RingSampling> samplings(resolved_.parts.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const RingSampling sampling = assembly::run_sampling(assembly_, resolved_, runs[i], i, grid);
      for (const auto part : runs[i].parts) {
        samplings[part] = sampling;
        if (std::ranges::none_of(resolved_.fillets, [&](const ResolvedFillet& fillet) {
              return std::ranges::count(fillet.between, part) > 0;
            })) {
          append_mesh(part,
                      assembly::with_part_context(assembly_, resolved_.parts[part].index, [&] {
                        return mesh_claim(resolved_.parts[part].shape, sampling);
                      }));
        }
      }
    }
    append_fillets(samplings, grid);
    append_hubs(samplings, grid);
  }

  void append_hubs(const std::vector<RingSampling>& samplings, double grid) {
    for (std::size_t i = 0; i < resolved_.junctions.size(); ++i) {
      const ResolvedJunction& junction = resolved_.junctions[i];
      std::vector<RingSampling> of_arms;
      std::uint32_t fewest = CertificateLimits::kSegments;
      for (const std::uint32_t arm : junction.arms) {
        of_arms.push_back(samplings[arm]);
        fewest = std::min(fewest, samplings[arm].segments);
      }
      const Tessellation hub =
          assembly::hub_tessellation(assembly_, junction, of_arms, options_.most_triangles);
      result_.claims[result_.junctions[i].hub].mesh = checker_.agreed_of_hub(
          certification::hub_mesh_claim(junction.shape.hub, hub.mesh, fewest, grid),
          junction.shape.hub);
    }
  }

  [[nodiscard]] std::optional<MeshClaim> mesh_claim(const PartSurface& shape,
                                                    const RingSampling& sampling) const {
    return std::visit(
        [&](const auto& s) { return certification::mesh_claim(s, sampling, assembly_.tolerance); },
        shape);
  }

  void append_mesh(std::uint32_t part, std::optional<MeshClaim> claim) {
    if (claim) {
      result_.claims[part].mesh = checker_.agreed(std::move(*claim), part);
    }
  }

  void append_fillets(const std::vector<RingSampling>& samplings, double grid) {
    std::vector<std::vector<surfaces::FilletMesh>> meshes;
    std::set<std::uint32_t> trimmed;
    for (const ResolvedFillet& fillet : resolved_.fillets) {
      meshes.push_back(assembly::fillet_meshes(
          assembly_, fillet, {samplings[fillet.between[0]], samplings[fillet.between[1]]},
          options_.most_triangles));
      trimmed.insert(fillet.between.begin(), fillet.between.end());
      if (!fillet.shape.is_cope()) {
        result_.fillet_claims.push_back(assembly::with_part_context(
            assembly_, fillet.index, [&] { return fillet_claims(fillet, meshes.back(), grid); }));
      }
    }
    // Of a straight pipe's mesh it counts only how far its triangles go about the axis.
    for (const std::uint32_t part : trimmed) {
      const Tessellation face = face_of(part, samplings, meshes);
      const Ring ring = end_ring(std::get<Chain>(result_.parts[part].shape), End::end);
      const double turn = widest_turn(face.mesh, ring, grid) * (1 + 0x1p-40);
      const auto segments = std::uint32_t(2 * std::numbers::pi / turn);
      append_mesh(part, MeshClaim{segments, grid, {0, 1}, face.error_bound, face.axes});
    }
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
      const ResolvedFillet& fillet, const std::vector<surfaces::FilletMesh>& meshes, double grid) {
    std::vector<LoopClaims> claims;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      claims.push_back(checker_.agreed(
          fillet.shape.loops[i],
          certification::prove_loop(fillet.shape.loops[i],
                                    {meshes[i].tessellation.knots, meshes[i].columns, grid},
                                    {options_.margin, options_.boxes, assembly_.tolerance})));
    }
    return claims;
  }

  void append_clearances() {
    result_.apart = options_.apart.value_or(default_distance(assembly_, sweeps_.size()));
    std::optional<std::vector<verification::PartPair>> pairs;
    if (result_.apart > 0) {
      pairs = checker_.pairs_nearer_than(result_.apart);
    }
    if (!pairs) {
      result_.apart = 0;
      pairs = all_pairs(std::uint32_t(sweeps_.size()));
    }
    work_.allow(kWorkOfPair * pairs->size());
    const auto at_hubs = arms_and_hubs();
    for (const verification::PartPair& pair : *pairs) {
      const auto [first, second] = pair;
      const bool is_at_hub = at_hubs.contains(pair);
      ClearanceClaim claim =
          is_at_hub ? certification::prove_at_hub(checker_.solid(first),
                                                  std::get<Sphere>(result_.parts[second].shape),
                                                  options_.boxes)
                    : clearance(first, second);
      claim.first = first;
      claim.second = second;
      result_.clearances.push_back(is_at_hub ? checker_.agreed_at_hub(std::move(claim))
                                             : checker_.agreed(std::move(claim), result_.parts));
    }
  }

  [[nodiscard]] std::set<verification::PartPair> arms_and_hubs() const {
    std::set<verification::PartPair> result;
    for (const CertifiedJunction& junction : result_.junctions) {
      for (const std::uint32_t arm : junction.arms) {
        result.insert({arm, junction.hub});
      }
    }
    return result;
  }

  // Of every loop and every part but its pipes, then every later loop; or of those that are near.
  void append_fillet_clearances() {
    const auto& loops = checker_.loops();
    std::vector<certification::SweptDiscs> arcs;
    std::vector<const CertifiedFillet*> fillet_of;
    arcs.reserve(loops.size());
    for (const auto& loop : loops) {
      arcs.push_back(certification::swept_arcs(loop, &work_));
    }
    for (const CertifiedFillet& fillet : result_.fillets) {
      fillet_of.insert(fillet_of.end(), fillet.loops.size(), &fillet);
    }
    const std::size_t parts = sweeps_.size();
    const certification::ClearanceGoals goals{std::min(options_.boxes, kBoxesOfLoop),
                                              assembly_.tolerance};
    const auto pairs = loop_pairs();
    work_.allow(kWorkOfPair * pairs.size());
    for (const auto& [first, second] : pairs) {
      const std::size_t k = second - parts;
      if (first >= parts) {
        append_fillet_clearance(
            first, second,
            certification::prove_clearance(
                certification::SweptLoop{loops[first - parts], arcs[first - parts]},
                {loops[k], arcs[k]}, goals));
      } else if (std::ranges::count(fillet_of[k]->between, first) == 0) {
        append_fillet_clearance(first, second,
                                certification::prove_clearance(
                                    certification::SweptPart{checker_.solid(first), sweeps_[first]},
                                    {loops[k], arcs[k]}, goals));
      }
    }
  }

  // In the order of the certificate.
  [[nodiscard]] std::vector<verification::PartPair> loop_pairs() {
    const auto parts = std::uint32_t(sweeps_.size());
    const auto surfaces = parts + std::uint32_t(checker_.loops().size());
    if (result_.apart > 0 && surfaces > parts) {
      if (auto near = checker_.loop_pairs_nearer_than(result_.apart)) {
        return std::move(*near);
      }
    }
    std::vector<verification::PartPair> pairs;
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

  void append_fillet_clearance(std::size_t first, std::size_t second, ClearanceClaim claim) {
    claim.first = std::uint32_t(first);
    claim.second = std::uint32_t(second);
    result_.fillet_clearances.push_back(checker_.agreed(std::move(claim)));
  }

  [[nodiscard]] ClearanceClaim clearance(std::uint32_t i, std::uint32_t j) const {
    const auto ends = joints(result_.parts[i], j);
    if (sweeps_[i].length() == 0 || sweeps_[j].length() == 0) {
      return {};
    }
    return ends.empty() ? certification::prove_clearance(sweeps_[i], sweeps_[j], options_.boxes)
                        : certification::prove_joint(sweeps_[i], sweeps_[j], ends, options_.boxes);
  }

  const Assembly& assembly_;
  const CertifyOptions& options_;
  ResolvedAssembly resolved_;
  certification::SearchWork work_;
  std::vector<certification::SweptDiscs> sweeps_;
  certification::CheckedClaims checker_;
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
      count += loop.mesh ? 0 : 1;
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

CertifiedInputs certified_inputs(const Assembly& assembly) { return inputs_of(resolve(assembly)); }

Certificate certify(const Assembly& assembly, const CertifyOptions& options) {
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
