#pragma once

#include <string>

#include "document.h"
#include "dupin/blends/certificate.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/mesh.h"

namespace dupin::cli {

/// Throws UsageError for a report page that would go to standard output beside a mesh, and
/// Error{invalid_argument} where this build makes none. `mesh` may be empty.
void require_page_file(const std::string& page, const std::string& mesh);

/// Writes the report page of a build, in one step. With a certificate its claims are shown, too.
/// Throws OutputError.
void write_page(const std::string& path, const Document& document, const BuildReport& report,
                TriMesh mesh, const Certificate* certificate = nullptr);

}  // namespace dupin::cli
