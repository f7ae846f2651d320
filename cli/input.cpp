#include "input.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "exchange_options.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

template <class Function>
auto blaming(const std::string& name, const Function& function) {
  try {
    return function();
  } catch (const Error& error) {
    throw error.in_part(name);
  }
}

}  // namespace

bool Input::is_document() const {
  if (has_size_of_binary_stl(bytes)) {  // the header of which may begin with anything
    return false;
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const std::size_t mark = bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n", mark);
  if (first != std::string::npos && bytes[first] == '{') {
    return true;
  }
  // An empty one, or what is no object: as a document it is told what is wrong with it.
  return lower_extension(name) == ".json" &&
         std::ranges::all_of(mesh_formats(), [&](const MeshFormat& format) {
           return format.recognises(bytes) == Evidence::none;
         });
}

std::string Input::unit() const { return mesh_unit(bytes, name); }

bool can_be_read_again(const std::string& path) {
  std::error_code ignored;
  return path != "-" && !std::filesystem::is_other(path, ignored);
}

void require_read_again(const std::string& path, const std::string& reason) {
  if (path == "-") {
    throw UsageError(reason + ", and standard input can be read only once");
  }
  if (!can_be_read_again(path)) {
    throw Error(Errc::invalid_argument, "has to be a regular file: " + reason, {}, path);
  }
}

Input read_input(const std::string& path) {
  return path == "-" ? Input{read_standard_input(kStandardInput), kStandardInput}
                     : Input{read_file(path), path};
}

std::vector<Input> read_inputs(const std::vector<std::string>& paths) {
  std::vector<Input> inputs;
  inputs.reserve(paths.size());
  for (const std::string& path : paths) {
    inputs.push_back(read_input(path));
  }
  return inputs;
}

std::string common_unit(const std::vector<StatedUnit>& stated) {
  const StatedUnit* first = nullptr;
  for (const StatedUnit& own : stated) {
    if (own.unit.empty()) {
      continue;
    }
    if (first == nullptr) {
      first = &own;
    } else if (first->unit != own.unit) {
      throw Error(Errc::invalid_argument,
                  "is in " + own.unit + ", but " + first->file + " in " + first->unit +
                      "; convert one of them first, with --to-unit",
                  {}, own.file);
    }
  }
  return first == nullptr ? std::string() : first->unit;
}

std::string common_unit(const std::vector<Input>& inputs) {
  std::vector<StatedUnit> stated;
  stated.reserve(inputs.size());
  for (const Input& input : inputs) {
    stated.push_back({input.name, input.unit()});
  }
  return common_unit(stated);
}

TriMesh read_mesh_input(const std::string& path) {
  const Input input = read_input(path);
  return read_mesh(input.bytes, input.name);
}

Solid solid_of(const Input& input) {
  return solid_of(read_mesh(input.bytes, input.name), input.name);
}

Solid solid_of(const TriMesh& mesh, const std::string& name) {
  return blaming(name, [&] { return Solid::from(mesh); });
}

Repaired repaired_solid_of(const Input& input, const Progress& progress) {
  return repaired_solid_of(read_mesh(input.bytes, input.name), input.name, progress);
}

Repaired repaired_solid_of(const TriMesh& mesh, const std::string& name, const Progress& progress) {
  return blaming(name, [&] {
    Repaired repaired = repair(mesh, progress);
    if (repaired.solid.empty() && !mesh.triangles.empty()) {
      throw Error(Errc::not_closed,
                  "it encloses nothing: of its " + std::to_string(mesh.triangles.size()) +
                      " faces, " + std::to_string(repaired.report.degenerate_faces) +
                      " have no area, and the others are those of sheets, there both ways round; "
                      "a solid has one face between itself and what is outside");
    }
    return repaired;
  });
}

Solid operand_of(const TriMesh& mesh, const std::string& name, bool is_repaired,
                 RepairReport& report) {
  if (!is_repaired) {
    return solid_of(mesh, name);
  }
  Repaired repaired = repaired_solid_of(mesh, name);
  report = repaired.report;
  return repaired.solid;
}

std::vector<FileRepair> repairs_in(std::span<const std::string> files,
                                   std::span<const RepairReport> reports) {
  std::vector<FileRepair> repairs;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (reports[i] != RepairReport{}) {
      repairs.push_back({files[i], reports[i]});
    }
  }
  return repairs;
}

}  // namespace dupin::cli
