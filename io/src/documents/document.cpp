#include "dupin/io/document.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/graph_file.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

// Ends of a piping file that are measured as a pair, in millimetres.
constexpr double kConnectPiping = 1;

Document piping_document(std::string_view text, const std::string& source,
                         const SourceOptions& given) {
  PipingOptions options{.bridge = given.bridge,
                        .wall = given.wall,
                        .fillet = given.fillet,
                        .keep_going = given.keep_going,
                        .progress = given.progress};
  options.snap = given.snap.value_or(options.snap);
  PcfReport report;
  report.snap = options.snap;
  report.bridge = options.bridge;
  report.is_strict = given.is_strict;
  report.file = parse_pcf(text, source, given.bores);
  if (!given.schedule.empty()) {
    give_walls(report.file, given.schedule);
  }
  PipingLine line = std::exchange(report.file.line, {});
  report.network = assembly_of(line, options);
  Document document{std::exchange(report.network.assembly, {})};
  document.piping = std::move(report);
  document.line = std::move(line);
  document.piping_options = std::move(options);
  return document;
}

Document graph_document(std::string_view text, const std::string& source,
                        const SourceOptions& given) {
  PipeGraphOptions options{
      .radius = given.radius, .keep_going = given.keep_going, .unit = given.unit};
  std::vector<SourceNote> notes;
  PipeGraph graph = parse_graph_file(text, source, given.keep_going ? &notes : nullptr);
  graph.notes = std::move(notes);
  PipeNetwork network = assembly_of(graph, options);
  return {std::exchange(network.assembly, {}), std::move(network), std::move(graph),
          std::move(options)};
}

// The component that each part is of; empty if none is of any.
std::vector<BillOrigin> origins(const Assembly& assembly) {
  std::vector<BillOrigin> result;
  result.reserve(assembly.parts.size());
  bool is_any = false;
  for (const Part& part : assembly.parts) {
    result.push_back({part.component.name, part.component.kind, part.component.line});
    is_any = is_any || !part.component.name.empty();
  }
  return is_any ? result : std::vector<BillOrigin>();
}

// A piping file's line is the place of an error, as of a build.
BillOfMaterials bill_of(const Document& document) {
  try {
    return bill_of_materials(document.assembly);
  } catch (const Error& error) {
    const auto& parts = document.assembly.parts;
    const auto part = std::ranges::find(parts, error.part(), &Part::name);
    if (!document.piping || part == parts.end()) {
      throw;
    }
    throw Error(error.code(), error.message(), error.part(),
                document.assembly.source + ":" + std::to_string(part->component.line));
  }
}

}  // namespace

DocumentKind document_kind(const std::filesystem::path& file) {
  return is_pcf_file(file)     ? DocumentKind::piping
         : is_graph_file(file) ? DocumentKind::graph
                               : DocumentKind::assembly;
}

Document document_of(std::string_view text, const std::string& source, DocumentKind kind,
                     const SourceOptions& options) {
  const UsualArithmetic usual;
  switch (kind) {
    case DocumentKind::piping:
      return piping_document(text, source, options);
    case DocumentKind::graph:
      return graph_document(text, source, options);
    case DocumentKind::assembly:
      break;
  }
  AssemblyDocument parsed = parse_document(text, source);
  Document document{std::move(parsed.assembly)};
  document.colours = std::move(parsed.colours);
  return document;
}

Built build(Document& document, const BuildOptions& options) {
  const UsualArithmetic usual;
  if (document.network) {
    PipeNetwork network = std::move(*document.network);
    network.assembly = std::exchange(document.assembly, {});
    Built built = build(document.graph, document.graph_options, network, options);
    document.assembly = std::exchange(network.assembly, {});
    document.network = std::move(network);
    return built;
  }
  if (!document.piping) {
    return build(document.assembly, options);
  }
  PipingNetwork& network = document.piping->network;
  network.assembly = std::exchange(document.assembly, {});
  Built built = build(document.line, document.piping_options, network, options);
  document.assembly = std::exchange(network.assembly, {});
  return built;
}

void take(BuildReport& report, Built&& built, Document& document, double connect) {
  const Assembly& assembly = document.assembly;
  report.graph = document.network;
  report.piping = std::move(document.piping);
  report.gaps = {assembly.source, assembly.unit, connect, std::move(built.ports),
                 std::move(built.gaps)};
  report.output.cross_check = std::move(built.cross_check);
  report.parts = std::move(built.parts);
  report.runs = built.runs;
  report.pieces = built.pieces;
  report.grid = built.grid;
  report.region = built.region;
  report.volumes = built.volumes;
  report.insulation = built.insulation;
}

BillReport bill_report(const Document& document) {
  const UsualArithmetic usual;
  BillReport report{bill_of(document), {}, origins(document.assembly), {}};
  report.source.graph = document.network;
  report.source.piping = document.piping;
  return report;
}

GapSummary gap_summary(const Assembly& assembly, std::optional<double> connect) {
  const UsualArithmetic usual;
  const ResolvedAssembly resolved = resolve(assembly);
  GapSummary summary{
      assembly.source, assembly.unit, connect.value_or(assembly.tolerance), ports(resolved), {}};
  summary.pairs = pair_ends(resolved, summary.ports, summary.connect);
  return summary;
}

GapSummary gap_summary(const Document& document, std::optional<double> connect) {
  const UsualArithmetic usual;
  GapSummary summary = gap_summary(document.assembly, connect);
  if (document.network) {
    summary.source = SourceNotes{{}, document.network->notes, {}};
  }
  return summary;
}

GapSummary piping_gap_summary(std::string_view text, const std::string& source, BoreMeaning bores,
                              std::optional<double> connect, bool keep_going) {
  const UsualArithmetic usual;
  PcfFile file = parse_pcf(text, source, bores);
  PipingOptions options;
  options.keep_going = keep_going;
  options.blends_kinks = false;
  std::vector<SourceNote> notes = assembly_of(file.line, options).notes;
  std::set<std::size_t> left_out;  // lines of components
  for (const SourceNote& note : notes) {
    if (note.is_refusal) {
      left_out.insert(note.line);
    }
  }
  std::erase_if(file.line.components, [&](const PipingComponent& component) {
    return left_out.contains(component.line);
  });
  GapSummary summary{
      source, Unit::millimetre, connect.value_or(kConnectPiping), ports(file.line), {}};
  summary.pairs = pair_ends(summary.ports, summary.connect);
  summary.source = SourceNotes{std::move(file.notes), std::move(notes), std::move(file.unknown)};
  return summary;
}

}  // namespace dupin
