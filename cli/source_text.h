#pragma once

#include <iosfwd>

#include "dupin/io/report_json.h"

namespace dupin::cli {

/// What became of the graph or piping file that was built, if it was one.
void print_source(std::ostream& out, const BuildReport& report);

/// The rows of what is said of it.
void print_source_notes(std::ostream& out, const SourceNotes& notes);

}  // namespace dupin::cli
