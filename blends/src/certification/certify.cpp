#include "dupin/blends/certify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "assembly/cost_limit.h"
#include "assembly/welded_runs.h"
#include "certification/checked_claims.h"
#include "certification/prove_regular.h"
#include "certification/swept_disc_pairs.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/surface_piece.h"

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

std::vector<CertifiedPart> parts_of(const ResolvedAssembly& resolved) {
  std::vector<CertifiedPart> result;
  for (const ResolvedPart& part : resolved.parts) {
    result.push_back({part.name, part.kind, part.shape, part.joined});
  }
  return result;
}

// So much a pair of parts that are far from each other costs, whatever else the work goes to.
constexpr std::uint64_t kWorkOfPair = 8;

std::uint64_t work_for(std::uint64_t parts, const CertifyOptions& options) {
  const std::uint64_t pairs = kWorkOfPair * (parts * (parts + 1) / 2);
  return options.work + std::min(pairs, std::numeric_limits<std::uint64_t>::max() - options.work);
}

class Certifier {
 public:
  Certifier(const Assembly& assembly, const CertifyOptions& options)
      : assembly_(assembly),
        options_(options),
        resolved_(resolve(assembly)),
        work_(work_for(resolved_.parts.size(), options)) {}

  Certificate run() {
    refuse_fillets(assembly_, resolved_, "certificates");
    result_.document = assembly_.source;
    result_.unit = assembly_.unit;
    result_.tolerance = assembly_.tolerance;
    result_.parts = parts_of(resolved_);
    for (const CertifiedPart& part : result_.parts) {
      sweeps_.push_back(std::visit(
          [&](const auto& s) { return certification::SweptDiscs(s, &work_); }, part.shape));
      checker_.read(part);
      result_.claims.push_back(
          std::visit([&](const auto& s) { return claims(s, sweeps_.back()); }, part.shape));
    }
    append_meshes();
    append_clearances();
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
    result.regular = checker_.agreed(certification::prove_regular(chain, options_.margin));
    if (result.regular->verdict == Verdict::proved) {
      result.embedded = checker_.agreed(
          certification::prove_embedded(sweep, result.regular->margin, options_.boxes),
          *result.regular);
    }
    for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
      for (const auto end : {End::start, End::end}) {
        result.tangency.push_back(checker_.agreed(
            std::visit([=](const auto& p) { return surfaces::tangency_claim(p, end); },
                       chain.pieces[i]),
            i, end, assembly_.tolerance));
      }
    }
    return result;
  }

  void append_meshes() {
    const double grid = assembly::lattice_spacing(assembly_, resolved_);
    const auto runs = assembly::welded_runs(resolved_);
    assembly::refuse_too_costly(assembly_, resolved_, runs, grid, options_.most_triangles);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const RingSampling sampling = assembly::run_sampling(assembly_, resolved_, runs[i], i, grid);
      for (const auto part : runs[i].parts) {
        Tessellation mesh = assembly::tessellated(assembly_, resolved_.parts[part], sampling);
        const bool is_sphere = std::holds_alternative<Sphere>(result_.parts[part].shape);
        if (is_sphere || !mesh.knots.empty()) {
          result_.claims[part].mesh = checker_.agreed(
              {sampling.segments, grid, std::move(mesh.knots), mesh.error_bound}, part);
        }
      }
    }
  }

  void append_clearances() {
    for (std::uint32_t i = 0; i < sweeps_.size(); ++i) {
      for (std::uint32_t j = i + 1; j < sweeps_.size(); ++j) {
        ClearanceClaim claim = clearance(i, j);
        claim.first = i;
        claim.second = j;
        result_.clearances.push_back(checker_.agreed(std::move(claim), result_.parts));
      }
    }
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
  return count +
         std::size_t(std::count_if(clearances.begin(), clearances.end(), [](const auto& claim) {
           return claim.verdict != Verdict::proved;
         }));
}

bool Certificate::joined(const ClearanceClaim& claim) const {
  return !joints(parts[claim.first], claim.second).empty();
}

std::vector<CertifiedPart> certified_parts(const Assembly& assembly) {
  const ResolvedAssembly resolved = resolve(assembly);
  refuse_fillets(assembly, resolved, "certificates");
  return parts_of(resolved);
}

Certificate certify(const Assembly& assembly, const CertifyOptions& options) {
  if (options.margin && !(*options.margin >= 0 && *options.margin < 1)) {
    throw Error(Errc::invalid_argument,
                "the margin to prove must be at least 0 and less than 1, not " +
                    decimal(*options.margin, kMessageDigits));
  }
  return Certifier(assembly, options).run();
}

}  // namespace dupin
