#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <vector>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_stream.h"
#include "streams/spilled_meshes.h"

namespace dupin::streams {

/// Files of VTK with the pieces appended for each of them, and the one that lists these.
class PvtuStream : public MeshStream {
 public:
  explicit PvtuStream(std::filesystem::path path);

  void append(const MeshPiece& piece, std::size_t file) override;
  void commit(const MeshHeader& header, const Normals& normals) override;

 private:
  [[nodiscard]] TriMesh mesh_of(const std::vector<std::size_t>& pieces) const;

  std::filesystem::path path_;
  AsideFile index_;
  SpilledMeshes meshes_;
  std::map<std::size_t, std::vector<std::size_t>> files_;  // the pieces of each
};

}  // namespace dupin::streams
