#pragma once

#include <string>

#include "commands.h"
#include "dupin/blends/unit.h"

namespace dupin::cli {

/// A length typed on the command line, in `unit`; `otherwise` for an empty text. Throws UsageError.
[[nodiscard]] double length_in(Unit unit, const std::string& text, double otherwise);

/// The same of a length that an option puts in the place of a document's, within the bounds of
/// these; else the option is blamed, not the document.
[[nodiscard]] double document_length(const std::string& option, Unit unit, const std::string& text,
                                     double otherwise);

/// The same beside meshes that state this unit; where they state none, their coordinates are taken
/// as millimetres. Meshes may state microns, too, "um".
[[nodiscard]] double mesh_length(const std::string& text, double otherwise,
                                 const std::string& mesh_unit);

/// Throws UsageError when --tolerance was given to a command that has no use for it; `instead` is
/// the option that may have been meant.
void refuse_tolerance(const std::string& command, const CommonOptions& common,
                      const std::string& instead = {});

}  // namespace dupin::cli
