#pragma once

#include <string_view>

namespace dupin {

/// The JSON Schema (draft 7) of assembly documents, io/assembly.schema.json as it is in the
/// sources.
[[nodiscard]] std::string_view assembly_schema();

/// The JSON Schema (draft 7) of certificates, io/certificate.schema.json.
[[nodiscard]] std::string_view certificate_schema();

}  // namespace dupin
