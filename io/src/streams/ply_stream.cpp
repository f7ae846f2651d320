#include "streams/ply_stream.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "dupin/kernel/parallel.h"
#include "formats/ply_numbers.h"
#include "formats/split_points.h"
#include "text/label_colour.h"
#include "text/little_endian.h"

namespace dupin::streams {
namespace {

/// The triangles of another mesh at a border of both.
void append_around(const MeshBorder& own, const MeshBorder& other, TriMesh& mesh) {
  const auto numbers = [](const Vec3& place) {
    return std::array{place.x(), place.y(), place.z()};
  };
  std::map<std::array<double, 3>, std::uint32_t> known;
  for (const std::uint32_t point : own.points) {
    known.emplace(numbers(mesh.points[point]), point);
  }
  std::map<std::string, std::uint32_t> labels;
  for (std::uint32_t i = 0; i < mesh.names.size(); ++i) {
    labels.emplace(mesh.names[i], i);
  }
  for (std::size_t i = 0; i < other.labels.size(); ++i) {
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& corner = other.corners[3 * i + k];
      const auto [entry, is_new] =
          known.try_emplace(numbers(corner), static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) {
        mesh.points.push_back(corner);
      }
      triangle.at(k) = entry->second;
    }
    const auto [label, is_new] =
        labels.try_emplace(other.labels[i], static_cast<std::uint32_t>(mesh.names.size()));
    if (is_new) {
      mesh.names.push_back(other.labels[i]);
    }
    mesh.labels.push_back(label->second);
  }
}

}  // namespace

void PlyStream::append(const MeshPiece& piece, std::size_t) { meshes_.append(piece); }

void PlyStream::commit(const MeshHeader& header, const Normals& normals) {
  const UsualArithmetic usual;
  meshes_.number_labels();
  std::vector<std::size_t> pieces(meshes_.size());
  std::iota(pieces.begin(), pieces.end(), 0);
  points_ = numbered_points(meshes_, pieces);
  std::uint64_t copies = 0;
  if (normals) {
    split(normals);
    learn_copies();
    for (const Split& split : splits_) {
      copies += split.copies;
    }
  }
  contents_ = {.vertices = points_.count + copies,
               .triangles = meshes_.triangles(),
               .has_normals = normals && meshes_.triangles() > 0,
               .has_copies = copies > 0,
               .has_labels = meshes_.have_labels(),
               .has_colours = meshes_.have_labels() && !header.colours.empty()};
  const std::string start = formats::ply_header_text(contents_, meshes_.names(), header,
                                                     formats::PlyEncoding::little_endian);
  write_vertices(start.size());
  write_copies(start.size() + vertex_size() * points_.count);
  write_faces(start.size() + vertex_size() * contents_.vertices, header);
  file_.commit(start);
}

formats::SplitPoints PlyStream::split_piece(std::size_t piece, const Normals& normals) const {
  TriMesh mesh = meshes_.mesh(piece);
  const std::size_t points = mesh.points.size(), triangles = mesh.triangles.size(),
                    labels = mesh.labels.size(), names = mesh.names.size();
  const std::vector<SharedBorder>& shared = points_.pieces[piece].shared;
  std::vector<std::size_t> ends;  // of the triangles of each, behind the mesh's
  for (const SharedBorder& seam : shared) {
    append_around(meshes_.borders(piece)[seam.border], meshes_.borders(seam.piece)[seam.of_piece],
                  mesh);
    ends.push_back(mesh.triangles.size());
  }
  CornerNormals all = normals(mesh);
  formats::GivenNormals given;
  for (std::size_t i = 0, face = triangles; i < shared.size(); ++i) {
    for (; face < ends[i]; ++face) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (shared[i].piece < piece && mesh.triangles[face].at(k) < points) {
          given.try_emplace(mesh.triangles[face].at(k), all[face].at(k));
        }
      }
    }
  }
  mesh.points.resize(points);
  mesh.triangles.resize(triangles);
  mesh.labels.resize(labels);
  mesh.names.resize(names);
  all.resize(triangles);
  return formats::split_points(mesh, all, given);
}

void PlyStream::split(const Normals& normals) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (meshes_.is_elsewhere(i)) {
      splits_.push_back({});
      continue;
    }
    const formats::SplitPoints own = split_piece(i, normals);
    splits_.push_back({arrays_.end(), static_cast<std::uint32_t>(own.normals.size()),
                       static_cast<std::uint32_t>(own.copied.size())});
    arrays_.append(own.normals);
    arrays_.append(own.copied);
    arrays_.append(own.triangles);
  }
}

void PlyStream::learn_copies() {
  if (processes_ == nullptr || processes_->count() == 1) {
    return;
  }
  std::string own;
  for (const Split& split : splits_) {
    text::store(own, split.copies);  // none of what is elsewhere
  }
  const std::vector<std::string> all = processes_->exchanged(own);
  for (std::size_t process = 0; process < all.size(); ++process) {
    for (std::size_t i = 0; process != processes_->own() && i < splits_.size(); ++i) {
      splits_[i].copies += text::load<std::uint32_t>(all[process], sizeof(std::uint32_t) * i);
    }
  }
}

std::vector<Direction> PlyStream::split_normals(std::size_t piece) const {
  return splits_.empty() ? std::vector<Direction>()
                         : arrays_.read<Direction>(splits_[piece].at, splits_[piece].normals);
}

std::vector<std::uint32_t> PlyStream::copied(std::size_t piece) const {
  const Split& split = splits_[piece];
  return arrays_.read<std::uint32_t>(split.at + split.normals * sizeof(Direction), split.copies);
}

std::vector<Triangle> PlyStream::split_triangles(std::size_t piece, std::size_t count) const {
  const Split& split = splits_[piece];
  return arrays_.read<Triangle>(
      split.at + split.normals * sizeof(Direction) + split.copies * sizeof(std::uint32_t), count);
}

std::uint64_t PlyStream::vertex_size() const {
  std::string bytes;
  const Direction normal{};
  const std::uint32_t number = 0;
  formats::store_ply_vertex(bytes, Vec3::Zero(), contents_.has_normals ? &normal : nullptr,
                            contents_.has_copies ? &number : nullptr);
  return bytes.size();
}

std::uint64_t PlyStream::face_size() const {
  std::string bytes;
  const std::uint32_t label = 0;
  const text::Colour colour{};
  formats::store_ply_face(bytes, {}, contents_.has_labels ? &label : nullptr,
                          contents_.has_colours ? &colour : nullptr);
  return bytes.size();
}

void PlyStream::write_vertices(std::uint64_t at) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (meshes_.is_elsewhere(i)) {
      at += vertex_size() * own_points(i);
      continue;
    }
    const TriMesh mesh = meshes_.mesh(i);
    const std::vector<Direction> normals = split_normals(i);
    std::uint32_t number = points_.pieces[i].first;
    auto known = points_.pieces[i].known.begin();
    std::string bytes;
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
      if (known != points_.pieces[i].known.end() && known->first == point) {
        ++known;
        continue;
      }
      formats::store_ply_vertex(bytes, mesh.points[point],
                                contents_.has_normals ? &normals[point] : nullptr,
                                contents_.has_copies ? &number : nullptr);
      ++number;
    }
    file_.write(at, bytes);
    at += bytes.size();
  }
}

void PlyStream::write_copies(std::uint64_t at) {
  for (std::size_t i = 0; contents_.has_copies && i < meshes_.size(); ++i) {
    if (!meshes_.is_elsewhere(i)) {
      const TriMesh mesh = meshes_.mesh(i);
      const std::vector<Direction> normals = split_normals(i);
      std::string bytes;
      std::size_t vertex = mesh.points.size();
      for (const std::uint32_t point : copied(i)) {
        const std::uint32_t number = points_.pieces[i].of(point);
        formats::store_ply_vertex(bytes, mesh.points[point], &normals[vertex++], &number);
      }
      file_.write(at, bytes);
    }
    at += vertex_size() * splits_[i].copies;
  }
}

void PlyStream::write_faces(std::uint64_t at, const MeshHeader& header) {
  std::vector<text::Colour> colours;
  if (contents_.has_colours) {
    colours = text::label_colours(meshes_.names(), header.colours);
  }
  auto copies = static_cast<std::uint32_t>(points_.count);
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (!meshes_.is_elsewhere(i)) {
      const TriMesh mesh = meshes_.mesh(i);
      const auto own = static_cast<std::uint32_t>(mesh.points.size());
      std::vector<Triangle> triangles =
          contents_.has_normals ? split_triangles(i, mesh.triangles.size()) : mesh.triangles;
      std::string bytes;
      for (std::size_t face = 0; face < triangles.size(); ++face) {
        for (std::uint32_t& corner : triangles[face]) {
          corner = corner < own ? points_.pieces[i].of(corner) : copies + (corner - own);
        }
        const std::uint32_t label =
            contents_.has_labels ? meshes_.numbers(i)[mesh.labels[face]] : 0;
        formats::store_ply_face(bytes, triangles[face], contents_.has_labels ? &label : nullptr,
                                contents_.has_colours ? &colours[label] : nullptr);
      }
      file_.write(at, bytes);
    }
    at += face_size() * meshes_.triangles_of(i);
    copies += contents_.has_copies ? splits_[i].copies : 0;
  }
}

}  // namespace dupin::streams
