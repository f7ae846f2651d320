#include "report_page_file.h"

#include <utility>

#include "dupin/io/report_page.h"
#include "exit_code.h"
#include "output.h"

namespace dupin::cli {

void require_page_file(const std::string& page, const std::string& mesh) {
  if (!has_page_viewer()) {
    throw Error(Errc::invalid_argument,
                "this build makes no report pages: three.js was not there when it was made "
                "(Debian: libjs-three)");
  }
  if (!mesh.empty() && output_path(page) == "-") {
    throw UsageError("--report takes a file of its own, not standard output");
  }
}

void write_page(const std::string& path, const Document& document, const BuildReport& report,
                TriMesh mesh, const Certificate* certificate) {
  BuiltDocument built{document.assembly, report};
  built.line = document.line.components.empty() ? nullptr : &document.line;
  built.graph = document.graph.nodes.empty() ? nullptr : &document.graph;
  built.certificate = certificate;
  built.colours = document.colours;
  write_text(path, report_page_html(report_page(built, std::move(mesh))));
}

}  // namespace dupin::cli
