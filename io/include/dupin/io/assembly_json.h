#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "dupin/blends/assembly.h"

namespace dupin {

/// The document in `text`, see docs/assembly_format.md. `source` names it in messages, here and
/// later.
///
/// Strict: throws Error{parse_failed} with "source:line:column" for what is not JSON, and with
/// "source#/json/pointer" for unknown, missing and repeated keys and for values of the wrong type.
/// Whether numbers are in range and ports exist is for `resolve` to say.
[[nodiscard]] Assembly parse_assembly(std::string_view text, const std::string& source = {});

/// A document: what there is, and how it is shown, which is no matter of its geometry.
struct AssemblyDocument {
  Assembly assembly;
  std::map<std::string, std::string> colours;  ///< of parts, "#rrggbb" by their names
};

/// The same with the colours of its parts. Throws as parse_assembly.
[[nodiscard]] AssemblyDocument parse_document(std::string_view text,
                                              const std::string& source = {});

/// The document that parse_assembly makes this of again, bit by bit, a part on each line. Comments
/// and colours are not kept, and neither is `source`.
[[nodiscard]] std::string document_text(const Assembly& assembly);

/// The document in a file. Throws as read_file and parse_assembly.
[[nodiscard]] Assembly read_assembly(const std::filesystem::path& file);

}  // namespace dupin
