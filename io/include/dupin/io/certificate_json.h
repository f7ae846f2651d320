#pragma once

#include <string>
#include <string_view>

#include "dupin/blends/assembly.h"
#include "dupin/blends/certificate.h"

namespace dupin {

/// The certificate as a JSON document, see docs/certificate_format.md. Numbers are decimals that
/// read back to the same double; the last key holds the SHA-256 digest of all bytes before it.
/// Always the same text for the same certificate.
[[nodiscard]] std::string certificate_json(const Certificate& certificate);

/// What a certificate says, without what proves it: one object, keys as in docs/cli.md.
[[nodiscard]] std::string certificate_summary_json(const Certificate& certificate);

/// How far pieces end at most from the rings that they have there in common with what goes on:
/// upper bounds, of all claims about tangency.
struct JointFit {
  double offset = 0;  ///< in the certificate's unit
  double angle = 0;   ///< in radians
};

[[nodiscard]] JointFit widest_joint(const Certificate& certificate);

/// Reads it back. Throws Error{parse_failed} for text that is not a certificate, or one of which a
/// byte was changed. Whether its claims follow is for `verify` to say.
[[nodiscard]] Certificate parse_certificate(std::string_view text, const std::string& source = {});

/// As verify(certificate), of one that was read from `source`: what does not follow has its place,
/// source#/json/pointer.
void verify(const Certificate& certificate, const std::string& source);

/// Throws Error{invalid_argument} for a certificate that is not about this document: the parts,
/// read and resolved again, differ from the certificate's in some bit, or its tolerance is larger
/// than the document's. Throws as `parse_assembly` and `resolve` for a document that is none.
void require_about(const Certificate& certificate, std::string_view document,
                   const std::string& source);

/// The same of a file that was made into an assembly, as graphs are.
void require_about(const Certificate& certificate, std::string_view document,
                   const Assembly& assembly);

}  // namespace dupin
