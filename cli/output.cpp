#include "output.h"

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include <CLI/App.hpp>

#include "dupin/io/atomic_file.h"
#include "dupin/io/patches_json.h"
#include "exit_code.h"
#include "interrupt.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

void require_stdout(int reason) {
  if (!std::cout && !has_lost_reader()) {
    throw Error(
        Errc::io_failed,
        "cannot be written" + (reason != 0 ? ": " + std::generic_category().message(reason) : ""),
        {}, "standard output");
  }
}

void write_stdout(const std::string& bytes) {
  errno = 0;
  std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require_stdout(errno);
  flush_stdout();
}

/// The same promise as `write_verified`, by the full check, for a stream that cannot be taken back.
Report write_checked_stdout(const TriMesh& mesh, const MeshFormat& format, const MeshHeader& header,
                            const Progress& progress) {
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

Report measured(const Rounded& rounded, const Destination& to, const Progress& progress) {
  tell(progress, "measure");
  Report report = check(rounded);
  if (!report.is_solid()) {
    throw Error(Errc::internal,
                "internal error, please report it: rounding gave a mesh that is no solid", {},
                shown(to));
  }
  return report;
}

/// Returns the measures of a mesh that the file gives back as rounding has proved it.
std::optional<Report> write_compared(const Rounded& rounded, const Destination& to,
                                     const MeshHeader& header, const Progress& progress) {
  std::optional<Report> report;
  if (to.is_measured) {
    report = measured(rounded, to, progress);
  }
  if (to.is_stdout()) {
    write_stdout(verified_bytes("standard output", rounded, to.format, header, progress));
  } else {
    write_verified(to.path, rounded, to.format, header, progress);
  }
  return report;
}

std::optional<Report> write_as_chosen(const Rounded& rounded, const Destination& to,
                                      const MeshHeader& header, const Progress& progress) {
  switch (to.verification) {
    case Verification::none:
      tell(progress, "write");
      write_bytes(mesh_bytes(rounded.mesh(), to.format, header), to);
      return std::nullopt;
    case Verification::compare:
      return write_compared(rounded, to, header, progress);
    case Verification::full:
      return to.is_stdout() ? write_checked_stdout(rounded.mesh(), to.format, header, progress)
                            : write_verified(to.path, rounded.mesh(), to.format, header, progress);
  }
  return std::nullopt;
}

/// Under these names, too, a report behind the mesh would spoil it.
bool names_stdout(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

/// What rounding every coordinate to the nearest does.
RoundingReport nearest_rounding(const TriMesh& mesh, Coordinates coordinates) {
  RoundingReport report;
  report.coordinates = coordinates;
  for (const Vec3& point : mesh.points) {
    const Vec3 there = nearest(point, coordinates);
    report.moved += there != point ? 1 : 0;
    report.largest_move = std::max(report.largest_move, (there - point).stableNorm());
  }
  return report;
}

std::string places_text(const std::vector<Contact>& contacts) {
  constexpr std::size_t kTold = 3;
  std::vector<std::string> places;  // edges and points may begin in one
  for (const Contact& contact : contacts) {
    if (std::string place = place_text(contact.from);
        std::ranges::find(places, place) == places.end()) {
      places.push_back(std::move(place));
    }
    if (places.size() > kTold) {
      places.back() = "...";
      break;
    }
  }
  std::string text = counted(contacts.size(), "place") + ", at";
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += (i == 0 ? " " : ", ") + places[i];
  }
  return text;
}

/// STL has no vertices, only corners: readers weld those that coincide.
void refuse_to_be_welded(const std::vector<Contact>& contacts, const Destination& to,
                         const ContactChoice& choice) {
  if (!to.format.merges_points || contacts.empty()) {
    return;
  }
  throw Error(Errc::contact,
              "the solid touches itself in " + places_text(contacts) +
                  ", and readers of STL would weld it there; write another format, or " +
                  (choice.length > 0 ? "give --contacts more than " + number(choice.length) +
                                           ", which is too little for the numbers it is rounded to"
                                     : "see --contacts separate=LENGTH and bridge=LENGTH"),
              {}, shown(to));
}

/// Of the solid, or what else only rounding has made.
void refuse_if_chosen(const std::vector<Contact>& contacts, bool by_rounding, const Destination& to,
                      const ContactChoice& choice) {
  if (choice.kind != ContactChoice::Kind::refuse || contacts.empty()) {
    return;
  }
  throw Error(
      Errc::contact,
      "the solid touches itself in " + places_text(contacts) + ", which --contacts refuse forbids" +
          (by_rounding
               ? ", once its points are rounded to the numbers of " + std::string(to.format.name) +
                     "; a format of finer numbers, or --contacts report, would do"
               : "; --contacts report writes it as it is, separate=LENGTH or bridge=LENGTH "
                 "without"),
      {}, shown(to));
}

}  // namespace

std::string shown(const Destination& to) { return to.is_stdout() ? "standard output" : to.path; }

void add_settled(ContactSettlement settled, OutputReport& report) {
  if (!report.settled) {
    report.settled = std::move(settled);
    return;
  }
  report.settled->length = std::max(report.settled->length, settled.length);
  std::ranges::move(settled.contacts, std::back_inserter(report.settled->contacts));
}

void note_origin(const Vec3& origin, MeshHeader& header) {
  if (origin == Vec3::Zero()) {
    return;
  }
  std::ostringstream note;
  note.precision(std::numeric_limits<double>::max_digits10);
  note << "origin at " << origin.x() << " " << origin.y() << " " << origin.z();
  header.note += (header.note.empty() ? "" : "; ") + note.str();
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const MeshFormat& format : mesh_formats()) {
    names.emplace_back(format.key);
  }
  return names;
}

void add_output_options(CLI::App& command, OutputArguments& arguments,
                        const std::vector<std::string>& others) {
  arguments.others = others;
  std::vector<std::string> formats = format_names();
  formats.insert(formats.end(), others.begin(), others.end());
  std::string help = "Instead of what the extension says; needed for standard output:\n";
  constexpr std::size_t kPerLine = 10;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    help += (i == 0 ? "" : i % kPerLine == 0 ? ",\n" : ", ") + formats[i];
  }
  command.add_option("--format", arguments.format, help)
      ->type_name("NAME")
      ->check(CLI::IsMember(formats));
  auto* const verify =
      command
          .add_option("--verify", arguments.verification,
                      "How the file is verified before it takes its place: compare (the usual)\n"
                      "with the mesh that rounding has proved, number by number, or full:\n"
                      "checked again from what is read back alone, as by check")
          ->type_name("HOW")
          ->check(CLI::IsMember({name(Verification::compare), name(Verification::full)}));
  command
      .add_option("--patches", arguments.patches,
                  "JSON file that lists the solid's patches by name (area, centroid, normal)\n"
                  "and a point proved inside of each component, for mesh generators")
      ->type_name("FILE");
  command
      .add_flag("--no-verify", arguments.no_verify, "Write without reading the file back at all")
      ->excludes(verify);
}

std::string output_path(const std::string& typed) { return names_stdout(typed) ? "-" : typed; }

Destination destination(const OutputArguments& arguments) {
  const auto& [typed, format, chosen_verification, patches, no_verify, others] = arguments;
  const Verification verification = no_verify ? Verification::none
                                    : chosen_verification == name(Verification::full)
                                        ? Verification::full
                                        : Verification::compare;
  const std::string path = output_path(typed);
  if (names_stdout(patches)) {
    throw UsageError("--patches takes a file of its own, not standard output");
  }
  if (const MeshFormat* const chosen = find_mesh_format(format)) {
    return {path, *chosen, verification, patches};
  }
  if (path == "-") {
    throw UsageError("standard output needs --format");
  }
  try {
    return {path, format_of(path), verification, patches};
  } catch (const Error& error) {
    std::string also;
    for (const std::string& other : others) {
      also += (also.empty() ? ", and here ." : ", .") + other;
    }
    throw UsageError(error.what() + also + "; or say --format");
  }
}

void flush_stdout() {
  const bool was_good = static_cast<bool>(std::cout);  // else errno may be of something else
  errno = 0;
  std::cout.flush();
  require_stdout(was_good ? errno : 0);
}

Rounded settled_and_rounded(const Solid& solid, const Destination& to,
                            const RoundingOptions& rounding, const ContactChoice& contacts,
                            OutputReport& report, const Progress& progress) {
  OutputReport own;
  refuse_if_chosen(solid.contacts(), false, to, contacts);
  if (!solid.contacts().empty()) {
    tell(progress, "settle");
  }
  const Solid settled = settle(solid, contacts, own);
  if (!rounding.whole) {
    require_something_left(own, settled.triangle_count());
  }
  tell(progress, "round");
  RoundingOptions options = rounding;
  options.tries_remedies = false;
  const bool parts = contacts.kind == ContactChoice::Kind::standard && to.format.merges_points;
  Rounded rounded = parts ? rounded_apart(settled, to.format.coordinates, options, own)
                          : to_mesh(settled, to.format.coordinates, options);
  refuse_if_chosen(rounded.contacts(), true, to, contacts);
  refuse_to_be_welded(rounded.contacts(), to, contacts);
  if (own.settled) {
    add_settled(*std::move(own.settled), report);
  }
  return rounded;
}

Rounded rounded_or_told_how(std::span<const Solid> solids, Coordinates coordinates,
                            const RoundingOptions& rounding,
                            const std::function<Rounded(const RoundingOptions&)>& attempt) {
  try {
    return attempt(rounding);
  } catch (const Error& error) {
    if (error.code() != Errc::unroundable) {
      throw;
    }
    throw with_remedies_tried(
        error, solids, coordinates, rounding, [&](const RoundingOptions& tried) {
          try {
            static_cast<void>(attempt(tried));
            return true;
          } catch (const Error& again) {
            if (again.code() != Errc::unroundable && again.code() != Errc::contact) {
              throw;
            }
            return false;
          }
        });
  }
}

OutputReport write_rounded(const Rounded& rounded, const Destination& to, MeshHeader header,
                           OutputReport report, const Progress& progress, TriMesh* written,
                           const NormalsOf& normals) {
  report.contacts = rounded.contacts();
  note_origin(rounded.report().origin, header);
  if (normals && to.format.has_normals) {
    header.normals = normals(in_own_place(rounded), rounded.report().largest_move);
  }
  report.file = shown(to);
  report.format = to.format.name;
  report.rounding = rounded.report();
  report.verification = to.verification;
  std::optional<AsideFile> patches;  // before the mesh takes its place: both are there, or none
  if (!to.patches.empty()) {
    tell(progress, "patches");
    writing(
        [&] { patches.emplace(to.patches, patches_json(rounded, report.file, header) + "\n"); });
  }
  report.check = writing([&] { return write_as_chosen(rounded, to, header, progress); });
  if (patches) {
    writing_beside(shown(to), [&] { patches->commit(); });
  }
  if (written != nullptr) {
    *written = in_own_place(rounded);
  }
  return report;
}

OutputReport write_solid(const Solid& solid, const Destination& to, const RoundingOptions& rounding,
                         MeshHeader header, const ContactChoice& contacts, const Progress& progress,
                         TriMesh* written, const NormalsOf& normals) {
  OutputReport report;
  const Rounded mesh = rounded_or_told_how(
      {&solid, 1}, to.format.coordinates, rounding, [&](const RoundingOptions& options) {
        report = {};
        return settled_and_rounded(solid, to, options, contacts, report, progress);
      });
  return write_rounded(mesh, to, std::move(header), std::move(report), progress, written, normals);
}

TriMesh in_own_place(const Rounded& rounded) {
  TriMesh mesh = rounded.mesh();
  for (Vec3& point : mesh.points) {
    point += rounded.report().origin;
  }
  return mesh;
}

OutputReport write_plain(const TriMesh& mesh, const Destination& to, const MeshHeader& header) {
  if (!to.patches.empty()) {
    throw Error(Errc::invalid_argument, "--patches lists those of solids, and this mesh is none",
                {}, shown(to));
  }
  OutputReport report;
  report.file = shown(to);
  report.format = to.format.name;
  report.rounding = nearest_rounding(mesh, to.format.coordinates);
  const std::string bytes = mesh_bytes(mesh, to.format, header);
  if (to.verification != Verification::none) {
    report.verification = Verification::full;
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
