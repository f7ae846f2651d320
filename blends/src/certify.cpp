#include <algorithm>
#include <cmath>
#include <string>

#include "decimal.h"
#include "disc_pairs.h"
#include "dupin/blends/certificate.h"
#include "dupin/blends/tangency.h"
#include "dupin/kernel/error.h"
#include "run_sampling.h"

namespace dupin {
namespace {

// Nearly the largest margin that holds, with room for a checker's own rounding, in few digits.
double nearly_largest_margin(const RingedSurface& surface) {
  constexpr double kRoom = 0x1p-12, kDigits = 0x1p20;
  const double lower = regularity(surface, {kRoom}).lower;
  return std::max(0.0, std::floor((lower - kRoom) * kDigits) / kDigits);
}

RegularClaim prove_regular(const RingedSurface& surface, const CertifyOptions& options) {
  RegularClaim claim;
  claim.margin = options.margin ? *options.margin : nearly_largest_margin(surface);
  const MarginProof proof = prove_margin(surface, claim.margin);
  claim.verdict = proof.verdict;
  claim.where = proof.where;
  if (claim.verdict == Verdict::proved && !(smallest_radius(surface.radius) > 0)) {
    claim.verdict = Verdict::undecided;
  }
  if (claim.verdict == Verdict::proved) {
    claim.leaves = proof.proven;
  }
  return claim;
}

std::variant<RingedSurface, Sphere, OtherShape> certified_shape(const PartSurface& surface) {
  if (const auto* sphere = std::get_if<Sphere>(&surface)) {
    return *sphere;
  }
  const auto* tube = std::get_if<RingedSurface>(&surface);
  const bool has_circles = tube != nullptr && !tube->start.ellipse && !tube->end.ellipse;
  return has_circles ? std::variant<RingedSurface, Sphere, OtherShape>(*tube) : OtherShape{};
}

// The length of the straight part that is joined to an end, 0 for others.
double straight_neighbour(const ResolvedAssembly& assembly, const std::optional<EndIndex>& end) {
  if (!end) {
    return 0;
  }
  const auto* surface = std::get_if<RingedSurface>(&assembly.parts[end->part].shape);
  const auto* line = surface != nullptr ? std::get_if<LineSpine>(&surface->spine) : nullptr;
  const bool is_straight =
      line != nullptr && (std::holds_alternative<ConstantRadius>(surface->radius) ||
                          std::holds_alternative<LinearRadius>(surface->radius));
  return is_straight ? (line->to - line->from).norm() : 0;
}

bool joined(const CertifiedPart& part, std::uint32_t other) {
  return std::any_of(part.joined.begin(), part.joined.end(),
                     [other](const auto& end) { return end && end->part == other; });
}

class Certifier {
 public:
  Certifier(const Assembly& assembly, const CertifyOptions& options)
      : assembly_(assembly), options_(options), resolved_(resolve(assembly)) {}

  Certificate run() {
    result_.document = assembly_.source;
    result_.unit = assembly_.unit;
    result_.tolerance = assembly_.tolerance;
    for (const ResolvedPart& part : resolved_.parts) {
      result_.parts.push_back({part.name, part.kind, certified_shape(part.shape), part.joined});
      result_.claims.push_back(std::visit([&](const auto& shape) { return claims(part, shape); },
                                          result_.parts.back().shape));
    }
    append_meshes();
    append_clearances();
    return std::move(result_);
  }

 private:
  [[nodiscard]] static PartClaims claims(const ResolvedPart&, const Sphere&) { return {}; }

  [[nodiscard]] static PartClaims claims(const ResolvedPart&, const OtherShape&) {
    PartClaims result;
    result.regular.emplace();
    result.embedded.emplace();
    return result;
  }

  [[nodiscard]] PartClaims claims(const ResolvedPart& part, const RingedSurface& surface) const {
    PartClaims result;
    result.regular = prove_regular(surface, options_);
    const std::array<double, 2> extension{straight_neighbour(resolved_, part.joined[0]),
                                          straight_neighbour(resolved_, part.joined[1])};
    result.embedded.emplace();
    if (result.regular->verdict == Verdict::proved) {
      result.embedded = detail::prove_embedded(detail::DiscSweep(surface, extension),
                                               result.regular->margin, options_.boxes);
    }
    result.embedded->extension = extension;
    for (const auto end : {SurfaceEnd::start, SurfaceEnd::end}) {
      const Tangency tangency = tangency_at_end(surface, end);
      // Adding 0 takes the sign from a zero.
      result.tangency.push_back({tangency.deviation.upper + 0.0, tangency.axis_angle.upper + 0.0});
    }
    return result;
  }

  void append_meshes() {
    const double grid = detail::lattice_spacing(assembly_, resolved_);
    const auto runs = detail::runs(resolved_);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const RingSampling sampling = detail::run_sampling(assembly_, resolved_, runs[i], i, grid);
      for (const auto part : runs[i].parts) {
        if (is_other(part)) {
          continue;
        }
        Tessellation mesh = detail::tessellated(assembly_, resolved_.parts[part], sampling);
        // A little more than was proven, for a checker's own rounding.
        result_.claims[part].mesh = {sampling.segments, grid, std::move(mesh.knots),
                                     mesh.error_bound * (1 + 0x1p-20)};
      }
    }
  }

  void append_clearances() {
    std::vector<detail::DiscSweep> sweeps;
    for (const auto& part : result_.parts) {
      const auto* sphere = std::get_if<Sphere>(&part.shape);
      const auto* tube = std::get_if<RingedSurface>(&part.shape);
      sweeps.push_back(tube != nullptr ? detail::DiscSweep(*tube, {})
                                       : detail::DiscSweep(sphere != nullptr ? *sphere : Sphere{}));
    }
    for (std::uint32_t i = 0; i < sweeps.size(); ++i) {
      for (std::uint32_t j = i + 1; j < sweeps.size(); ++j) {
        if (joined(result_.parts[i], j)) {
          continue;
        }
        append_clearance(i, j,
                         is_other(i) || is_other(j)
                             ? ClearanceClaim{}
                             : detail::prove_clearance(sweeps[i], sweeps[j], options_.boxes));
      }
    }
  }

  [[nodiscard]] bool is_other(std::uint32_t part) const {
    return std::holds_alternative<OtherShape>(result_.parts[part].shape);
  }

  void append_clearance(std::uint32_t i, std::uint32_t j, ClearanceClaim claim) {
    claim.first = i;
    claim.second = j;
    result_.clearances.push_back(std::move(claim));
  }

  const Assembly& assembly_;
  const CertifyOptions& options_;
  ResolvedAssembly resolved_;
  Certificate result_;
};

}  // namespace

std::size_t Certificate::findings() const {
  std::size_t count = 0;
  for (const PartClaims& part : claims) {
    count += part.regular && part.regular->verdict != Verdict::proved ? 1 : 0;
    count += part.embedded && part.embedded->verdict != Verdict::proved ? 1 : 0;
  }
  return count +
         std::size_t(std::count_if(clearances.begin(), clearances.end(), [](const auto& claim) {
           return claim.verdict != Verdict::proved;
         }));
}

Certificate certify(const Assembly& assembly, const CertifyOptions& options) {
  if (options.margin && !(*options.margin >= 0 && *options.margin < 1)) {
    throw Error(Errc::invalid_argument,
                "the margin to prove must be at least 0 and less than 1, not " +
                    detail::decimal(*options.margin));
  }
  return Certifier(assembly, options).run();
}

}  // namespace dupin
