#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dupin/io/mesh_stream.h"
#include "dupin/io/processes.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/tiled_check.h"

namespace dupin {

namespace files {
class Descriptor;
class PlacedFile;
}  // namespace files

/// A binary STL, each piece of which is read back at once; the header is completed at the end.
class StlStream : public MeshStream {
 public:
  explicit StlStream(const std::filesystem::path& path, const Processes* processes = nullptr);
  ~StlStream() override;

  /// Throws Error{limit_exceeded} for 2^32 triangles and more.
  void append(const MeshPiece& piece, std::size_t file) override;
  void flush() override;
  void commit(const MeshHeader& header, const Normals& normals) override;
  void abandon() override;

  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }

 private:
  std::string shown_;
  std::unique_ptr<files::PlacedFile> file_;
  std::uint64_t triangles_ = 0;
  std::vector<std::string> names_;  // of labels, at most two of them
};

/// Whether the path leads to a regular file that is taken for a binary STL, or for a damaged one.
/// Throws Error{io_failed}.
[[nodiscard]] bool is_stl_file(const std::filesystem::path& path);

/// A binary STL that is read where it lies, a little at a time, as often as it is asked for.
///
/// Throws Error{io_failed} with the system's reason, also where the file has become shorter;
/// Error{invalid_argument} for what is no regular file or of another format; Error{parse_failed}
/// for a damaged one, as read_stl_binary() does.
class StlFile : public FacetSource {
 public:
  explicit StlFile(const std::filesystem::path& path);

  [[nodiscard]] std::uint32_t count() const override { return count_; }
  void visit(const std::function<void(std::span<const Facet>)>& visit) const override;
  /// As read_stl_binary() gives it, without the file's bytes beside it in memory.
  [[nodiscard]] TriMesh mesh() const;
  /// What the header says; empty if nothing.
  [[nodiscard]] std::string unit() const;

 private:
  std::string shown_;
  std::shared_ptr<const files::Descriptor> file_;
  std::uint32_t count_ = 0;
};

}  // namespace dupin
