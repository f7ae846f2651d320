#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "json/certificate_seal.h"

namespace dupin {

namespace {

void require(bool holds, const std::string& source, const std::string& reason,
             const std::string& part = {}) {
  if (!holds) {
    throw Error(Errc::invalid_argument, "the certificate is not about this document: " + reason,
                part, source);
  }
}

// The digest says that it may be about the document; who made the certificate wrote it, too.
void require_digest(const Certificate& certificate, std::string_view document,
                    const std::string& source) {
  require(sha256(document) == certificate.document_sha256, source, "the digest is another's");
}

}  // namespace

void verify(const Certificate& certificate, const std::string& source) {
  constexpr std::string_view kUnnamed = "certificate";
  try {
    verify(certificate);
  } catch (const Error& error) {
    if (!error.where().starts_with(kUnnamed)) {
      throw;
    }
    throw Error(error.code(), error.message(), error.part(),
                source + error.where().substr(kUnnamed.size()));
  }
}

JointFit widest_joint(const Certificate& certificate) {
  const UsualArithmetic usual;
  JointFit widest;
  for (const PartClaims& claims : certificate.claims) {
    for (const TangencyClaim& claim : claims.tangency) {
      widest.offset = std::max(widest.offset, claim.offset);
      widest.angle = std::max(widest.angle, claim.axis_angle);
    }
  }
  return widest;
}

void require_about(const Certificate& certificate, std::string_view document,
                   const std::string& source) {
  const UsualArithmetic usual;
  require_digest(certificate, document, source);
  require_about(certificate, document, parse_assembly(document, source));
}

void require_about(const Certificate& certificate, std::string_view document,
                   const Assembly& assembly) {
  const UsualArithmetic usual;
  require_digest(certificate, document, assembly.source);
  const auto require = [&](bool holds, const std::string& reason, const std::string& part = {}) {
    dupin::require(holds, assembly.source, reason, part);
  };
  require(certificate.unit == assembly.unit, "the unit is another");
  require(certificate.tolerance <= assembly.tolerance, "its tolerance is larger");
  const auto [parts, fillets, junctions] = certified_inputs(assembly);
  require(certificate.parts.size() == parts.size(), "it has not as many parts");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    require(json::input_text(certificate.parts[i]) == json::input_text(parts[i]),
            "the part is another", parts[i].name);
  }
  require(certificate.fillets.size() == fillets.size(), "it has not as many fillets");
  for (std::size_t i = 0; i < fillets.size(); ++i) {
    require(json::input_text(certificate.fillets[i]) == json::input_text(fillets[i]),
            "the fillet is another", fillets[i].name);
  }
  require(certificate.junctions.size() == junctions.size(), "it has not as many junctions");
  for (std::size_t i = 0; i < junctions.size(); ++i) {
    require(json::input_text(certificate.junctions[i]) == json::input_text(junctions[i]),
            "the junction is another", parts[junctions[i].hub].name);
  }
}

}  // namespace dupin
