#include <algorithm>
#include <string>

#include "claims.h"
#include "dupin/kernel/error.h"
#include "mesh_bound.h"

namespace dupin::verifier {
namespace {

void require(bool follows, const std::string& part, const std::string& claim) {
  if (!follows) {
    throw Error(Errc::invalid_argument, "the claim '" + claim + "' does not follow", part,
                "certificate");
  }
}

void verify_part(const std::vector<CertifiedPart>& parts, const CertifiedPart& part,
                 const PartClaims& claims) {
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    require(sphere->radius > 0 && claims.mesh && mesh_follows(*sphere, *claims.mesh), part.name,
            "mesh");
    return;
  }
  if (std::holds_alternative<OtherShape>(part.shape)) {
    require(claims.regular && claims.regular->verdict == Verdict::undecided && claims.embedded &&
                claims.embedded->verdict == Verdict::undecided && claims.tangency.empty() &&
                !claims.mesh,
            part.name, "undecided");
    return;
  }
  require(claims.regular && claims.embedded && claims.tangency.size() == 2, part.name, "regular");
  const Tube tube(std::get<RingedSurface>(part.shape));
  require(claims.regular->verdict == Verdict::undecided || follows(tube, *claims.regular),
          part.name, "regular");
  require(claims.embedded->verdict == Verdict::undecided ||
              follows(parts, part, *claims.embedded, *claims.regular),
          part.name, "embedded");
  require(follows(tube, claims.tangency[0], false) && follows(tube, claims.tangency[1], true),
          part.name, "tangency");
  require(claims.mesh && mesh_follows(tube, *claims.mesh), part.name, "mesh");
}

bool joined(const CertifiedPart& part, std::uint32_t other) {
  return std::any_of(part.joined.begin(), part.joined.end(),
                     [other](const auto& end) { return end && end->part == other; });
}

}  // namespace
}  // namespace dupin::verifier

namespace dupin {

void verify(const Certificate& certificate) {
  const auto& parts = certificate.parts;
  verifier::require(certificate.claims.size() == parts.size(), "", "parts");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    verifier::verify_part(parts, parts[i], certificate.claims[i]);
  }
  auto claim = certificate.clearances.begin();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    for (std::uint32_t j = i + 1; j < parts.size(); ++j) {
      if (verifier::joined(parts[i], j)) {
        continue;
      }
      verifier::require(
          claim != certificate.clearances.end() && claim->first == i && claim->second == j &&
              (claim->verdict == Verdict::undecided || verifier::follows(parts, *claim)),
          parts[i].name, "clearance of " + parts[j].name);
      ++claim;
    }
  }
  verifier::require(claim == certificate.clearances.end(), "", "clearance");
}

}  // namespace dupin
