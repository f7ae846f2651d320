#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_stream.h"
#include "formats/ply_header.h"
#include "streams/spilled_meshes.h"

namespace dupin::streams {

/// A binary PLY of pieces, as ply_binary_bytes() writes them joined.
class PlyStream : public MeshStream {
 public:
  explicit PlyStream(const std::filesystem::path& path) : shown_(path.string()), file_(path) {}

  void append(const MeshPiece& piece, std::size_t file) override;
  void commit(const MeshHeader& header, const Normals& normals) override;

 private:
  /// A piece with one normal for each vertex: where its arrays are.
  struct Split {
    std::uint64_t at;
    std::uint32_t normals, copies;
  };

  void split(const Normals& normals);
  /// The normals, the copied points, and the triangles of vertices.
  [[nodiscard]] std::vector<Direction> split_normals(std::size_t piece) const;
  [[nodiscard]] std::vector<std::uint32_t> copied(std::size_t piece) const;
  [[nodiscard]] std::vector<Triangle> split_triangles(std::size_t piece, std::size_t count) const;

  void write_vertices();
  void write_copies();
  void write_faces(const MeshHeader& header);
  void write(const std::string& bytes);

  std::string shown_;
  AsideFile file_;
  std::uint64_t end_ = 0;
  SpilledMeshes meshes_;
  SpilledArrays arrays_;
  std::vector<Split> splits_;  // empty without normals
  formats::PlyContents contents_;
};

}  // namespace dupin::streams
