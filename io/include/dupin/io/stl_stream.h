#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/tiled_check.h"

namespace dupin {

namespace files {
class Descriptor;
}

/// The facets of a solid as a binary STL has them.
struct StlFacets {
  std::string bytes;
  std::vector<std::string> names;  ///< of labels

  [[nodiscard]] std::uint64_t count() const;
};

/// Facets that give back the very numbers and neighbours that rounding has proved, or
/// Error{unroundable} is thrown, as by write_verified(), naming `file`.
[[nodiscard]] StlFacets stl_facets(const Rounded& solid, std::string_view file);

/// A binary STL that is written one solid after the other, aside, in the memory that one of them
/// needs. Its bytes are those that stl_binary_bytes() gives for all of them joined
/// (dupin/kernel/districts.h). All functions throw what AsideFile does.
class StlStream {
 public:
  explicit StlStream(const std::filesystem::path& path);

  /// Behind those that are there, and read back. Throws Error{limit_exceeded} for 2^32 triangles
  /// and more.
  void append(const StlFacets& solid);
  /// The file takes its place.
  void commit(const MeshHeader& header);

  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }

 private:
  std::string shown_;
  AsideFile file_;
  std::uint64_t triangles_ = 0;
  std::vector<std::string> names_;  // of labels, at most two of them
};

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

 private:
  [[nodiscard]] std::string bytes_at(std::uint64_t at, std::size_t size) const;

  std::string shown_;
  std::shared_ptr<const files::Descriptor> file_;
  std::uint32_t count_ = 0;
};

}  // namespace dupin
