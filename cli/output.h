#pragma once

#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "commands.h"
#include "contact_options.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"

namespace CLI {
class App;
}

namespace dupin::cli {

/// Where a mesh goes: a file, or standard output for "-".
struct Destination {
  std::string path;
  MeshFormat format = kOff;
  Verification verification = Verification::compare;
  std::string patches = {};  ///< the file beside it that lists its patches; empty: none
  /// Whether a report tells the measures of what is written; it is the solid that rounding has
  /// proved in any case.
  bool is_measured = true;

  [[nodiscard]] bool is_stdout() const { return path == "-"; }
};

/// What --format takes: the keys of all formats.
[[nodiscard]] std::vector<std::string> format_names();

/// What the commands that write a mesh are told of where it goes.
struct OutputArguments {
  std::string path, format, verification, patches;
  bool no_verify = false;
  std::vector<std::string> others = {};  ///< formats besides those of meshes
};

/// Adds --format, --verify and --no-verify, shared by all commands that write a mesh. `others` are
/// formats that the command knows besides those of meshes.
void add_output_options(CLI::App& command, OutputArguments& arguments,
                        const std::vector<std::string>& others = {});

/// A file's path as typed, or "-" under all names of standard output.
[[nodiscard]] std::string output_path(const std::string& typed);

/// The format is the one asked for (see format_names) or, if empty, the one that the
/// path's extension names. Throws UsageError.
[[nodiscard]] Destination destination(const OutputArguments& arguments);

/// The normals of the smooth surface that a mesh in the solid's coordinates stands for, of which no
/// point has moved by more than that from the solid.
using NormalsOf = std::function<CornerNormals(const TriMesh& mesh, double moved)>;

/// Settles contacts as chosen, rounds once to what the format holds, reads the bytes back and
/// verifies them as chosen, and only then lets the file take its place; says so in the
/// header if the origin is moved. Then writes the list of patches, if there is to be one. Tells the
/// stages "settle" (if there are contacts), "round", "write" and "verify". `written`, if given,
/// gets the mesh that was written, in the solid's coordinates. `normals`, if given, is asked for
/// what formats that hold normals shall say. Throws Error{unroundable}, Error{contact} for contacts
/// in a format whose readers weld vertices, OutputError.
[[nodiscard]] OutputReport write_solid(const Solid& solid, const Destination& to,
                                       const RoundingOptions& rounding, MeshHeader header,
                                       const ContactChoice& contacts = {},
                                       const Progress& progress = {}, TriMesh* written = nullptr,
                                       const NormalsOf& normals = {});

/// The first half of it, up to the one rounding. What it tells comes behind what the report says of
/// other solids already. Remedies are not tried.
[[nodiscard]] Rounded settled_and_rounded(const Solid& solid, const Destination& to,
                                          const RoundingOptions& rounding,
                                          const ContactChoice& contacts, OutputReport& report,
                                          const Progress& progress = {});

/// What `attempt` makes of these solids. Where it throws Error{unroundable}, it is asked again, and
/// the error says with which other options it would do.
[[nodiscard]] Rounded rounded_or_told_how(
    std::span<const Solid> solids, Coordinates coordinates, const RoundingOptions& rounding,
    const std::function<Rounded(const RoundingOptions&)>& attempt);

/// The second half.
[[nodiscard]] OutputReport write_rounded(const Rounded& rounded, const Destination& to,
                                         MeshHeader header, OutputReport report,
                                         const Progress& progress = {}, TriMesh* written = nullptr,
                                         const NormalsOf& normals = {});

/// Behind what was settled of other solids.
void add_settled(ContactSettlement settled, OutputReport& report);

/// "out.stl", or "standard output".
[[nodiscard]] std::string shown(const Destination& to);

/// The note that says where the origin is, behind what the header says already.
void note_origin(const Vec3& origin, MeshHeader& header);

/// The mesh where the solid is that was rounded, whatever origin was subtracted.
[[nodiscard]] TriMesh in_own_place(const Rounded& rounded);

/// Writes any mesh with every coordinate rounded to the nearest that the format holds, and says
/// what came of it. Of such a mesh nothing is proved: whatever is read back is checked in full.
/// Throws Error{invalid_argument} where its patches are to be listed, and OutputError.
[[nodiscard]] OutputReport write_plain(const TriMesh& mesh, const Destination& to,
                                       const MeshHeader& header = {});

/// What is on its way to standard output is there. Throws Error{io_failed}, unless its reader has
/// gone (interrupt.h).
void flush_stdout();

/// Writes text to a file, in one step, or to standard output for "-". Throws OutputError.
void write_text(const std::string& path, const std::string& text);

/// Where the report goes: standard output, or standard error when the mesh goes to standard output.
[[nodiscard]] std::ostream& report_stream(const Destination& to);
/// The same for a text, by its path as typed.
[[nodiscard]] std::ostream& report_stream(const std::string& path);

/// Prints the report as the common options say.
void print_written(const OutputReport& report, const Destination& to, const CommonOptions& common);

}  // namespace dupin::cli
