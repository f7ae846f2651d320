#pragma once

#include <span>
#include <string>
#include <vector>

#include "dupin/io/report_json.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/solid.h"

namespace dupin::cli {

/// What messages call it.
constexpr const char* kStandardInput = "standard input";

/// A file's bytes and the name that messages give it; "-" reads standard input.
struct Input {
  std::string bytes;
  std::string name;

  /// True when the bytes look like an assembly document, not a mesh, or like neither in a file
  /// named .json.
  [[nodiscard]] bool is_document() const;

  /// What the mesh file says; empty if nothing. Throws as `dupin::mesh_unit`.
  [[nodiscard]] std::string unit() const;
};

/// Not standard input, and not pipes and the like, which can be read only once. What is not there,
/// is: to say so is up to reading.
[[nodiscard]] bool can_be_read_again(const std::string& path);
/// Throws UsageError of standard input, and Error{invalid_argument} of pipes and the like; `reason`
/// says who reads them twice.
void require_read_again(const std::string& path, const std::string& reason);

/// Throws Error{io_failed}.
[[nodiscard]] Input read_input(const std::string& path);

[[nodiscard]] std::vector<Input> read_inputs(const std::vector<std::string>& paths);

/// What a mesh file says its unit is; empty if nothing.
struct StatedUnit {
  std::string file, unit;
};

/// The unit of meshes that are to be used together: the one that all agree on who state any; empty
/// if none does. Throws Error{invalid_argument} naming two that differ.
[[nodiscard]] std::string common_unit(const std::vector<StatedUnit>& stated);
[[nodiscard]] std::string common_unit(const std::vector<Input>& inputs);

[[nodiscard]] TriMesh read_mesh_input(const std::string& path);

/// Throws Error naming the file as its part when the mesh is not a solid.
[[nodiscard]] Solid solid_of(const Input& input);
[[nodiscard]] Solid solid_of(const TriMesh& mesh, const std::string& name);
/// Repairs it first. Throws Error naming the file as its part when that is not possible, or leaves
/// nothing of it.
[[nodiscard]] Repaired repaired_solid_of(const Input& input, const Progress& progress = {});
[[nodiscard]] Repaired repaired_solid_of(const TriMesh& mesh, const std::string& name,
                                         const Progress& progress = {});

/// The operand of a set operation: repaired where that is asked for, and then `report` says how.
[[nodiscard]] Solid operand_of(const TriMesh& mesh, const std::string& name, bool is_repaired,
                               RepairReport& report);
/// What was repaired in the files, of which there is a report each.
[[nodiscard]] std::vector<FileRepair> repairs_in(std::span<const std::string> files,
                                                 std::span<const RepairReport> reports);

}  // namespace dupin::cli
