#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dupin/io/mesh_stream.h"
#include "dupin/io/processes.h"
#include "files/placed_file.h"
#include "formats/ply_header.h"
#include "formats/split_points.h"
#include "streams/point_numbers.h"
#include "streams/spilled_meshes.h"

namespace dupin::streams {

/// A binary PLY of pieces, as ply_binary_bytes() writes them joined. Vertices and faces take as
/// many bytes each as all others, so that every process knows where its own are.
class PlyStream : public MeshStream {
 public:
  explicit PlyStream(const std::filesystem::path& path, const Processes* processes = nullptr)
      : processes_(processes), file_(path, processes), meshes_(path.string()) {}

  void append(const MeshPiece& piece, std::size_t file) override;
  void commit(const MeshHeader& header, const Normals& normals) override;
  void abandon() override { file_.abandon(); }

 private:
  /// A piece with one normal for each vertex: where its arrays are.
  struct Split {
    std::uint64_t at;
    std::uint32_t normals, copies;
  };

  /// How many of its points no piece before has.
  [[nodiscard]] std::uint64_t own_points(std::size_t piece) const {
    return meshes_.points_of(piece) - points_.pieces[piece].known.size();
  }
  /// As pieces that go on in others see their triangles, and these theirs: of a point of both they
  /// find the same.
  [[nodiscard]] formats::SplitPoints split_piece(std::size_t piece, const Normals& normals) const;
  void split(const Normals& normals);
  /// How many copies pieces have that are elsewhere.
  void learn_copies();
  /// The normals, the copied points, and the triangles of vertices.
  [[nodiscard]] std::vector<Direction> split_normals(std::size_t piece) const;
  [[nodiscard]] std::vector<std::uint32_t> copied(std::size_t piece) const;
  [[nodiscard]] std::vector<Triangle> split_triangles(std::size_t piece, std::size_t count) const;

  [[nodiscard]] std::uint64_t vertex_size() const;
  [[nodiscard]] std::uint64_t face_size() const;
  /// Each from its first byte on.
  void write_vertices(std::uint64_t at);
  void write_copies(std::uint64_t at);
  void write_faces(std::uint64_t at, const MeshHeader& header);

  const Processes* processes_;
  files::PlacedFile file_;
  SpilledMeshes meshes_;
  SpilledArrays arrays_;
  std::vector<Split> splits_;  // empty without normals
  NumberedPoints points_;
  formats::PlyContents contents_;
};

}  // namespace dupin::streams
