#pragma once

#include <string>
#include <string_view>

#include "dupin/blends/certificate.h"

namespace dupin::json {

inline constexpr std::string_view kCertificateFormat = "dupin certificate 1";

/// What the claims are about, as in the document.
[[nodiscard]] std::string inputs_text(const Certificate& certificate);

/// One of the parts, of the fillets, or of the junctions.
[[nodiscard]] std::string input_text(const CertifiedPart& part);
[[nodiscard]] std::string input_text(const CertifiedFillet& fillet);
[[nodiscard]] std::string input_text(const CertifiedJunction& junction);

/// The text of an unfinished object, ended by a key with the digest of all bytes before it.
[[nodiscard]] std::string sealed(const std::string& text);

/// Whether `text` is what `sealed` made of its beginning.
[[nodiscard]] bool has_seal(std::string_view text);

}  // namespace dupin::json
