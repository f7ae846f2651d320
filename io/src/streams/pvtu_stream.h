#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_stream.h"
#include "dupin/io/processes.h"
#include "streams/spilled_meshes.h"

namespace dupin::streams {

/// Of the files that a .pvtu lists, beside it.
[[nodiscard]] std::string listed_name(const std::filesystem::path& pvtu, std::size_t number);

/// Files of VTK with the pieces appended for each of them, and the one that lists these. Each is
/// written by the process that has its pieces, and put in its place by the first one with the
/// others.
class PvtuStream : public MeshStream {
 public:
  explicit PvtuStream(std::filesystem::path path, const Processes* processes = nullptr);

  void append(const MeshPiece& piece, std::size_t file) override;
  void commit(const MeshHeader& header, const Normals& normals) override;

 private:
  [[nodiscard]] TriMesh mesh_of(const std::vector<std::size_t>& pieces) const;

  /// Whether this process writes the file of these pieces.
  [[nodiscard]] bool is_own(const std::vector<std::size_t>& pieces) const;

  std::filesystem::path path_;
  const Processes* processes_;        // several, or null
  std::unique_ptr<AsideFile> index_;  // which the first process writes
  SpilledMeshes meshes_;
  std::map<std::size_t, std::vector<std::size_t>> files_;  // the pieces of each
};

}  // namespace dupin::streams
