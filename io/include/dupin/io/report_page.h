#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/certificate.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// A place that one goes to.
struct PagePlace {
  Vec3 at = Vec3::Zero();
  double size = 0;  ///< of what is to be seen there, in the mesh's unit; 0: the page's choice
  std::vector<std::vector<Vec3>> lines = {};  ///< that are drawn there, over everything
  bool is_marked = false;                     ///< a dot in the picture shows it
};

/// A row of a table. One with a place or a part can be clicked.
struct PageRow {
  std::vector<std::string> cells;
  bool is_finding = false;
  std::optional<PagePlace> place = {};
  std::optional<std::uint32_t> part = {};  ///< in ReportPage::parts
};

struct PageSection {
  std::string title, note;
  std::vector<std::string> columns = {};
  std::vector<PageRow> rows = {};
  bool is_counted = false;  ///< its tab says how many rows there are
};

/// What is shown and hidden together.
struct PagePart {
  std::string name, kind;
  std::string colour = {};                    ///< "#rrggbb"; empty: the page's choice
  std::map<std::string, double> values = {};  ///< that parts may be coloured by
  std::vector<std::uint32_t> labels = {};     ///< of the mesh
};

/// What a report page shows.
struct ReportPage {
  std::string title, summary;
  std::string unit;  ///< may be empty
  TriMesh mesh;
  std::vector<PagePart> parts;  ///< every label is one part's
  std::vector<PageSection> sections;
};

/// What a build was made of and came to.
struct BuiltDocument {
  const Assembly& assembly;
  const BuildReport& report;
  const PipingLine* line = nullptr;                 ///< of a piping file
  const PipeGraph* graph = nullptr;                 ///< of a graph
  const Certificate* certificate = nullptr;         ///< if claims were proved
  std::map<std::string, std::string> colours = {};  ///< of parts, as parse_document has them
};

/// `mesh` is that of the solid in the assembly's own coordinates. Takes the time of
/// `margin_places` and, where there are walls, `thinnest_walls`.
[[nodiscard]] ReportPage report_page(const BuiltDocument& built, TriMesh mesh);

/// Of a mesh file; `summary.check` is shown as it is.
[[nodiscard]] ReportPage report_page(const MeshSummary& summary);

/// Whether this build has the viewer (three.js), without which there are no pages.
[[nodiscard]] bool has_page_viewer();

/// One HTML file that needs nothing else, not even a network: a 3D view and tables. The same bytes
/// for the same page. Whatever texts hold is shown as text. Throws Error{invalid_argument} for a
/// build without the viewer, for a mesh that no file can hold, and for a label that is not one
/// part's.
[[nodiscard]] std::string report_page_html(const ReportPage& page);

/// What the command that wrote it says: {file, findings}.
[[nodiscard]] std::string page_report_json(const std::string& file, std::size_t findings);

}  // namespace dupin
