#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/crease.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Where the mesh goes on in one other.
struct MeshBorder {
  std::string name;                   ///< both have it
  std::vector<std::uint32_t> points;  ///< in an order that both have, of the same places
  /// The triangles at these points, by their corners, three by three, and their labels' names.
  std::vector<Vec3> corners;
  std::vector<std::string> labels;
};

/// The mesh of a solid on its way into a file of several, or of a part of one.
struct MeshPiece {
  std::string bytes;                                    ///< as the streams of its format take them
  std::vector<std::string> names;                       ///< of labels
  std::uint32_t points = 0, triangles = 0, labels = 0;  ///< labels: one for each triangle, or none
  std::vector<MeshBorder> borders;  ///< where it is open; of formats that number points
  /// Another process has the bytes, and writes them.
  bool is_elsewhere = false;
};

/// A file of meshes that grows aside, in the memory that one of them needs. Its bytes are those
/// that the format's writer gives for all of them joined (dupin/kernel/districts.h). What it is to
/// hold behind others is in a ScratchFile meanwhile. Several processes may write it: each makes the
/// same calls, but has the bytes of some pieces only, and writes these. All functions throw what
/// AsideFile does.
class MeshStream {
 public:
  /// The normals of a piece's mesh, for formats that have some.
  using Normals = std::function<CornerNormals(const TriMesh& mesh)>;

  MeshStream() = default;
  virtual ~MeshStream() = default;
  MeshStream(const MeshStream&) = delete;
  MeshStream& operator=(const MeshStream&) = delete;

  /// Behind those that are there. Where meshes are in several files, `file` says which.
  virtual void append(const MeshPiece& piece, std::size_t file) = 0;
  /// Where what was appended lies in its place already, it is on the disk, so that commit() waits
  /// for less. Nothing else is called meanwhile.
  virtual void flush() {}
  /// The file takes its place, or all of them do. Throws Error{limit_exceeded} for more than the
  /// format can say.
  virtual void commit(const MeshHeader& header, const Normals& normals) = 0;
  /// The file is given up, in all processes that make it, which go on.
  virtual void abandon() {}
};

}  // namespace dupin
