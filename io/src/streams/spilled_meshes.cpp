#include "streams/spilled_meshes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "dupin/kernel/error.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"

namespace dupin::streams {
namespace {

using Numbers = std::array<double, 3>;

template <class Item>
void append_items(const std::vector<Item>& items, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
}

}  // namespace

MeshPiece spilled_piece(const TriMesh& mesh) {
  MeshPiece piece{.names = mesh.names,
                  .points = static_cast<std::uint32_t>(mesh.points.size()),
                  .triangles = static_cast<std::uint32_t>(mesh.triangles.size()),
                  .labels = static_cast<std::uint32_t>(mesh.labels.size())};
  std::vector<Numbers> points;
  points.reserve(mesh.points.size());
  for (const Vec3& point : text::writable_points(mesh, Coordinates::binary64)) {
    points.push_back({point.x(), point.y(), point.z()});
  }
  append_items(points, piece.bytes);
  append_items(mesh.triangles, piece.bytes);
  append_items(mesh.labels, piece.bytes);
  return piece;
}

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A mesh without its ends, and its points and labels in it, or kNone.
struct OpenMesh {
  TriMesh left;
  std::vector<std::uint32_t> place, label;
};

OpenMesh open_mesh(const TriMesh& mesh, std::span<const std::uint32_t> triangles,
                   std::span<const std::string> names) {
  OpenMesh result{{},
                  std::vector<std::uint32_t>(mesh.points.size(), kNone),
                  std::vector<std::uint32_t>(mesh.names.size(), kNone)};
  auto& [left, place, label] = result;
  for (std::size_t i = 0; i < mesh.names.size(); ++i) {
    if (std::ranges::count(names, mesh.names[i]) == 0) {
      label[i] = static_cast<std::uint32_t>(left.names.size());
      left.names.push_back(mesh.names[i]);
    }
  }
  auto end = triangles.begin();
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (end != triangles.end() && *end == i) {
      ++end;
      continue;
    }
    left.triangles.push_back(mesh.triangles[i]);
    if (!mesh.labels.empty()) {
      left.labels.push_back(label[mesh.labels[i]]);
    }
    for (const std::uint32_t corner : mesh.triangles[i]) {
      place[corner] = 0;
    }
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (place[i] == 0) {
      place[i] = static_cast<std::uint32_t>(left.points.size());
      left.points.push_back(mesh.points[i]);
    }
  }
  for (Triangle& triangle : left.triangles) {
    std::ranges::transform(triangle, triangle.begin(),
                           [&own = place](std::uint32_t corner) { return own[corner]; });
  }
  // What only had labels to tell its ends.
  if (left.names == std::vector<std::string>{""}) {
    left.names.clear();
    left.labels.clear();
  }
  return result;
}

void add_triangles(const TriMesh& left, std::span<const std::uint32_t> border_of,
                   std::vector<MeshBorder>& borders) {
  for (std::size_t i = 0; i < left.triangles.size(); ++i) {
    std::set<std::uint32_t> at;
    for (const std::uint32_t corner : left.triangles[i]) {
      at.insert(border_of[corner]);
    }
    at.erase(kNone);
    for (const std::uint32_t border : at) {
      for (const std::uint32_t corner : left.triangles[i]) {
        borders[border].corners.push_back(left.points[corner]);
      }
      borders[border].labels.push_back(left.labels.empty() ? "" : left.names[left.labels[i]]);
    }
  }
}

}  // namespace

MeshPiece open_piece(const TriMesh& mesh, std::span<const std::uint32_t> triangles,
                     std::span<const std::string> names) {
  const auto& [left, place, label] = open_mesh(mesh, triangles, names);
  std::vector<std::uint32_t> border_of(left.points.size(), kNone);
  std::vector<MeshBorder> borders;
  for (const std::string& name : names) {
    borders.push_back({name, {}, {}, {}});
  }
  for (const std::uint32_t triangle : triangles) {
    const auto border = static_cast<std::uint32_t>(
        std::ranges::find(names, mesh.names[mesh.labels[triangle]]) - names.begin());
    for (const std::uint32_t corner : mesh.triangles[triangle]) {
      if (place[corner] != kNone && border_of[place[corner]] == kNone) {
        border_of[place[corner]] = border;
        borders[border].points.push_back(place[corner]);
      }
    }
  }
  for (MeshBorder& border : borders) {
    std::ranges::sort(border.points, {}, [&own = left](std::uint32_t point) {
      return std::tuple(own.points[point].x(), own.points[point].y(), own.points[point].z());
    });
  }
  add_triangles(left, border_of, borders);
  MeshPiece piece = spilled_piece(left);
  piece.borders = std::move(borders);
  return piece;
}

namespace {

// That the numbers are below `end`.
bool are_below(std::string_view bytes, std::uint64_t at, std::uint64_t count, std::uint64_t end) {
  for (std::uint64_t i = 0; i < count; ++i) {
    if (text::load<std::uint32_t>(bytes, at + i * sizeof(std::uint32_t)) >= end) {
      return false;
    }
  }
  return true;
}

bool is_whole(const MeshPiece& piece) {
  const std::uint64_t triangles = piece.points * sizeof(Numbers),
                      labels = triangles + piece.triangles * sizeof(Triangle);
  const bool are_counts_right =
      (piece.labels == 0 || piece.labels == piece.triangles) &&
      (piece.is_elsewhere ||
       piece.bytes.size() == labels + std::uint64_t{piece.labels} * sizeof(std::uint32_t));
  return are_counts_right &&
         std::ranges::all_of(piece.borders,
                             [&](const MeshBorder& border) {
                               return border.corners.size() == 3 * border.labels.size() &&
                                      std::ranges::all_of(border.points, [&](std::uint32_t point) {
                                        return point < piece.points;
                                      });
                             }) &&
         (piece.is_elsewhere ||
          (are_below(piece.bytes, triangles, 3 * std::uint64_t{piece.triangles}, piece.points) &&
           are_below(piece.bytes, labels, piece.labels, piece.names.size())));
}

}  // namespace

void SpilledMeshes::require_open() const {
  if (are_numbered_) {
    throw Error(Errc::invalid_argument,
                "the file is committed: nothing can be appended, and it is committed once", {},
                shown_);
  }
}

void SpilledMeshes::append(const MeshPiece& piece) {
  require_open();
  if (!is_whole(piece)) {
    throw Error(Errc::invalid_argument,
                "the bytes, counts and names of a piece do not fit together; append what "
                "mesh_piece() or without() has made for the same format",
                {}, shown_);
  }
  pieces_.push_back({arrays_.end(),
                     piece.points,
                     piece.triangles,
                     piece.labels,
                     piece.is_elsewhere,
                     piece.names,
                     {},
                     piece.borders});
  arrays_.append(piece.bytes);
  points_ += piece.points;
  triangles_ += piece.triangles;
  have_labels_ = have_labels_ || piece.labels > 0;
}

void SpilledMeshes::number_labels() {
  require_open();
  are_numbered_ = true;
  if (!have_labels_) {
    names_ = pieces_.size() == 1 ? pieces_.front().names : std::vector<std::string>();
    return;
  }
  text::LabelBuilder labels;
  for (Piece& piece : pieces_) {
    for (const std::string& name : std::exchange(piece.names, {})) {
      piece.numbers.push_back(labels.label(name));
    }
    if (piece.labels == 0 && piece.triangles > 0) {
      piece.numbers.assign(1, labels.label(""));
    }
  }
  TriMesh named;
  std::move(labels).name_labels(named);
  names_ = std::move(named.names);
}

TriMesh SpilledMeshes::mesh(std::size_t number) const {
  const Piece& piece = pieces_[number];
  TriMesh mesh;
  mesh.points.reserve(piece.points);
  for (const auto& [x, y, z] : arrays_.read<Numbers>(piece.at, piece.points)) {
    mesh.points.emplace_back(x, y, z);
  }
  std::uint64_t at = piece.at + piece.points * sizeof(Numbers);
  mesh.triangles = arrays_.read<Triangle>(at, piece.triangles);
  at += piece.triangles * sizeof(Triangle);
  if (piece.labels > 0) {
    mesh.labels = arrays_.read<std::uint32_t>(at, piece.labels);
  } else if (have_labels_) {
    mesh.labels.assign(piece.triangles, 0);
  }
  for (const std::uint32_t name : piece.numbers) {
    mesh.names.push_back(names_[name]);
  }
  return mesh;
}

}  // namespace dupin::streams
