#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dupin/io/mesh_stream.h"
#include "dupin/io/scratch_file.h"

/// Meshes that are written before all of them are known. A stream is fed with pieces, solids that
/// have nothing to do with each other, and gives the bytes that the format's writer gives for all
/// of them joined: what comes first in the file, its counts and its names, is known last. So pieces
/// of PLY and VTK are put aside (spilled_meshes.h) and written at the end, one after the other, as
/// often as the format has sections (ply_stream.h, pvtu_stream.h); those of STL follow one another
/// at once, and the header is completed (dupin/io/stl_stream.h).
namespace dupin::streams {

/// Arrays of plain items in a scratch file, one behind the other.
class SpilledArrays {
 public:
  template <class Items>
  requires std::is_trivially_copyable_v<typename Items::value_type>
  void append(const Items& items) {
    const std::size_t size = items.size() * sizeof(typename Items::value_type);
    file_.write(end_, {reinterpret_cast<const char*>(items.data()), size});
    end_ += size;
  }
  template <class Item>
  requires std::is_trivially_copyable_v<Item>
  [[nodiscard]] std::vector<Item> read(std::uint64_t at, std::size_t count) const {
    std::vector<Item> items(count);
    file_.read(at, {reinterpret_cast<char*>(items.data()), count * sizeof(Item)});
    return items;
  }
  /// Where the next one will be.
  [[nodiscard]] std::uint64_t end() const { return end_; }

 private:
  ScratchFile file_;
  std::uint64_t end_ = 0;
};

/// The points, triangles and labels of a mesh, for SpilledMeshes.
[[nodiscard]] MeshPiece spilled_piece(const TriMesh& mesh);

/// The same without triangles, ascending, that have labels of these names, and without points that
/// only these have. Where it is open, it has borders of these names, with points in the order of
/// their places.
[[nodiscard]] MeshPiece open_piece(const TriMesh& mesh, std::span<const std::uint32_t> triangles,
                                   std::span<const std::string> names);

/// Pieces, put aside.
class SpilledMeshes {
 public:
  /// For the file that is shown so.
  explicit SpilledMeshes(std::string shown = {}) : shown_(std::move(shown)) {}
  /// Throws Error{invalid_argument} for what is no such piece, and when labels have numbers.
  void append(const MeshPiece& piece);
  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  [[nodiscard]] std::uint64_t points() const { return points_; }
  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }

  /// Behind the last one, and before the first is read: labels get the numbers that joined()
  /// (dupin/kernel/districts.h) gives them. Throws Error{invalid_argument} if they have.
  void number_labels();
  /// Of all labels; none, if no piece has any.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool have_labels() const { return have_labels_; }
  /// Whether another process has it; all but its numbers is known.
  [[nodiscard]] bool is_elsewhere(std::size_t piece) const { return pieces_[piece].is_elsewhere; }
  [[nodiscard]] std::uint32_t points_of(std::size_t piece) const { return pieces_[piece].points; }
  [[nodiscard]] std::uint32_t triangles_of(std::size_t piece) const {
    return pieces_[piece].triangles;
  }
  [[nodiscard]] const std::vector<MeshBorder>& borders(std::size_t piece) const {
    return pieces_[piece].borders;
  }
  /// As it was; if others have labels it has one, too, named "". It is not elsewhere.
  [[nodiscard]] TriMesh mesh(std::size_t piece) const;
  /// Of each label of that mesh, its place in names().
  [[nodiscard]] const std::vector<std::uint32_t>& numbers(std::size_t piece) const {
    return pieces_[piece].numbers;
  }

 private:
  struct Piece {
    std::uint64_t at;
    std::uint32_t points, triangles, labels;
    bool is_elsewhere;
    std::vector<std::string> names;  // until labels have numbers
    std::vector<std::uint32_t> numbers;
    std::vector<MeshBorder> borders;
  };

  void require_open() const;

  std::string shown_;
  bool are_numbered_ = false;
  SpilledArrays arrays_;
  std::vector<Piece> pieces_;
  std::vector<std::string> names_;
  std::uint64_t points_ = 0, triangles_ = 0;
  bool have_labels_ = false;
};

}  // namespace dupin::streams
