#include "output.h"

#include <algorithm>
#include <iostream>
#include <limits>
#include <sstream>

#include <CLI/App.hpp>

#include "dupin/io/atomic_file.h"
#include "exit_code.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

/// Runs a function that writes; what the system refuses there is an output error.
template <class Function>
auto writing(const Function& function) {
  try {
    return function();
  } catch (const Error& error) {
    if (error.code() == Errc::io_failed) {
      throw OutputError(error);
    }
    throw;
  }
}

void write_stdout(const std::string& bytes) {
  std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The same promise as `write_verified`, for a stream that cannot be taken back.
Report write_verified_stdout(const TriMesh& mesh, const MeshFormat& format,
                             const MeshHeader& header, const Progress& progress) {
  tell(progress, "write");
  const std::string bytes = mesh_bytes(mesh, format, header);
  tell(progress, "verify");
  Report report = check(format.read(bytes, "standard output"));
  if (!report.is_solid()) {
    throw Error(Errc::unroundable,
                "the mesh is no solid any more with the coordinates of " + std::string(format.name),
                {}, "standard output");
  }
  write_stdout(bytes);
  return report;
}

void write_bytes(const std::string& bytes, const Destination& to) {
  to.is_stdout() ? write_stdout(bytes) : write_file(to.path, bytes);
}

/// Under these names, too, a report behind the mesh would spoil it.
bool names_stdout(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

std::string shown(const Destination& to) { return to.is_stdout() ? "standard output" : to.path; }

/// What rounding every coordinate to the nearest does.
RoundingReport nearest_rounding(const TriMesh& mesh, Coordinates coordinates) {
  RoundingReport report;
  report.coordinates = coordinates;
  for (const Vec3& point : mesh.points) {
    const double move = (nearest(point, coordinates) - point).norm();
    report.moved += move > 0 ? 1 : 0;
    report.largest_move = std::max(report.largest_move, move);
  }
  return report;
}

/// STL has no vertices, only corners: readers weld those that coincide.
void refuse_contacts(const std::vector<Contact>& contacts, const Destination& to) {
  if (!to.format.merges_points || contacts.empty()) {
    return;
  }
  constexpr std::size_t kTold = 3;
  std::string places;
  for (std::size_t i = 0; i < std::min(kTold, contacts.size()); ++i) {
    places += (i == 0 ? " " : ", ") + place_text(contacts[i].from);
  }
  throw Error(Errc::contact,
              "the solid touches itself in " + counted(contacts.size(), "place") + ", at" + places +
                  (contacts.size() > kTold ? ", ..." : "") +
                  ", and readers of STL would weld it there; write another format, or see "
                  "--contacts separate=LENGTH and bridge=LENGTH",
              {}, shown(to));
}

std::string origin_note(const Vec3& origin) {
  std::ostringstream note;
  note.precision(std::numeric_limits<double>::max_digits10);
  note << "origin at " << origin.x() << " " << origin.y() << " " << origin.z();
  return note.str();
}

}  // namespace

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const MeshFormat& format : mesh_formats()) {
    names.emplace_back(format.key);
  }
  return names;
}

void add_output_options(CLI::App& command, OutputArguments& arguments) {
  std::string help = "Instead of what the extension says; needed for standard output:\n";
  std::string_view separator;
  for (const std::string& name : format_names()) {
    help += std::string(separator) + name;
    separator = ", ";
  }
  command.add_option("--format", arguments.format, help)
      ->type_name("NAME")
      ->check(CLI::IsMember(format_names()));
  command.add_flag("--no-verify", arguments.no_verify,
                   "Write without reading the file back and checking it");
}

std::string output_path(const std::string& typed) { return names_stdout(typed) ? "-" : typed; }

Destination destination(const OutputArguments& arguments) {
  const auto& [typed, format, no_verify] = arguments;
  const std::string path = output_path(typed);
  if (const MeshFormat* const chosen = find_mesh_format(format)) {
    return {path, *chosen, !no_verify};
  }
  if (path == "-") {
    throw UsageError("standard output needs --format");
  }
  try {
    return {path, format_of(path), !no_verify};
  } catch (const Error& error) {
    throw UsageError(error.what() + std::string("; or say --format"));
  }
}

OutputReport write_solid(const Solid& solid, const Destination& to, const RoundingOptions& rounding,
                         MeshHeader header, const ContactChoice& contacts,
                         const Progress& progress) {
  OutputReport report;
  if (!solid.contacts().empty()) {
    tell(progress, "settle");
  }
  const Solid settled = settle(solid, contacts, report);
  tell(progress, "round");
  const bool parts = contacts.kind == ContactChoice::Kind::standard && to.format.merges_points &&
                     !settled.contacts().empty();
  const Rounded rounded = parts ? rounded_apart(settled, to.format.coordinates, rounding, report)
                                : to_mesh(settled, to.format.coordinates, rounding);
  refuse_contacts(rounded.contacts(), to);
  report.contacts = rounded.contacts();
  if (rounded.report().origin != Vec3::Zero()) {
    header.note += (header.note.empty() ? "" : "; ") + origin_note(rounded.report().origin);
  }
  report.file = shown(to);
  report.format = to.format.name;
  report.rounding = rounded.report();
  report.check = writing([&]() -> std::optional<Report> {
    if (!to.verify) {
      tell(progress, "write");
      write_bytes(mesh_bytes(rounded.mesh(), to.format, header), to);
      return std::nullopt;
    }
    return to.is_stdout() ? write_verified_stdout(rounded.mesh(), to.format, header, progress)
                          : write_verified(to.path, rounded.mesh(), to.format, header, progress);
  });
  return report;
}

OutputReport write_plain(const TriMesh& mesh, const Destination& to, const MeshHeader& header) {
  OutputReport report;
  report.file = shown(to);
  report.format = to.format.name;
  report.rounding = nearest_rounding(mesh, to.format.coordinates);
  const std::string bytes = mesh_bytes(mesh, to.format, header);
  if (to.verify) {
    report.check = check(to.format.read(bytes, shown(to)));
  }
  writing([&] { write_bytes(bytes, to); });
  return report;
}

void write_text(const std::string& path, const std::string& text) {
  writing([&] { names_stdout(path) ? write_stdout(text) : write_file(path, text); });
}

std::ostream& report_stream(const Destination& to) {
  return to.is_stdout() ? std::cerr : std::cout;
}

std::ostream& report_stream(const std::string& path) {
  return names_stdout(path) ? std::cerr : std::cout;
}

void print_written(const OutputReport& report, const Destination& to, const CommonOptions& common) {
  if (common.json) {
    report_stream(to) << to_json(report) << '\n';
  } else if (!common.quiet) {
    print_output(report_stream(to), report, "");
  }
  if (!common.json) {
    print_timing(std::cerr, report.timing);
  }
}

}  // namespace dupin::cli
