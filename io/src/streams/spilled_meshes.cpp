#include "streams/spilled_meshes.h"

#include <array>
#include <utility>

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

void SpilledMeshes::append(const MeshPiece& piece) {
  pieces_.push_back({arrays_.end(),
                     piece.points,
                     piece.triangles,
                     piece.labels,
                     piece.is_elsewhere,
                     piece.names,
                     {}});
  arrays_.append(piece.bytes);
  points_ += piece.points;
  triangles_ += piece.triangles;
  have_labels_ = have_labels_ || piece.labels > 0;
}

void SpilledMeshes::number_labels() {
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
