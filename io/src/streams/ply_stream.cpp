#include "streams/ply_stream.h"

#include "formats/ply_numbers.h"
#include "formats/split_points.h"
#include "text/label_colour.h"
#include "text/little_endian.h"

namespace dupin::streams {

void PlyStream::append(const MeshPiece& piece, std::size_t) { meshes_.append(piece); }

void PlyStream::commit(const MeshHeader& header, const Normals& normals) {
  meshes_.number_labels();
  std::uint64_t copies = 0;
  if (normals) {
    split(normals);
    learn_copies();
    for (const Split& split : splits_) {
      copies += split.copies;
    }
  }
  contents_ = {.vertices = meshes_.points() + copies,
               .triangles = meshes_.triangles(),
               .has_normals = normals && meshes_.triangles() > 0,
               .has_copies = copies > 0,
               .has_labels = meshes_.have_labels(),
               .has_colours = meshes_.have_labels() && !header.colours.empty()};
  const std::string start = formats::ply_header_text(contents_, meshes_.names(), header,
                                                     formats::PlyEncoding::little_endian);
  write_vertices(start.size());
  write_copies(start.size() + vertex_size() * meshes_.points());
  write_faces(start.size() + vertex_size() * contents_.vertices, header);
  file_.commit(start);
}

void PlyStream::split(const Normals& normals) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (meshes_.is_elsewhere(i)) {
      splits_.push_back({});
      continue;
    }
    const TriMesh mesh = meshes_.mesh(i);
    const formats::SplitPoints own = formats::split_points(mesh, normals(mesh));
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
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (meshes_.is_elsewhere(i)) {
      number += meshes_.points_of(i);
      at += vertex_size() * meshes_.points_of(i);
      continue;
    }
    const TriMesh mesh = meshes_.mesh(i);
    const std::vector<Direction> normals = split_normals(i);
    std::string bytes;
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
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
  std::uint32_t before = 0;
  for (std::size_t i = 0; contents_.has_copies && i < meshes_.size(); ++i) {
    if (!meshes_.is_elsewhere(i)) {
      const TriMesh mesh = meshes_.mesh(i);
      const std::vector<Direction> normals = split_normals(i);
      std::string bytes;
      std::size_t vertex = mesh.points.size();
      for (const std::uint32_t point : copied(i)) {
        const std::uint32_t number = before + point;
        formats::store_ply_vertex(bytes, mesh.points[point], &normals[vertex++], &number);
      }
      file_.write(at, bytes);
    }
    before += meshes_.points_of(i);
    at += vertex_size() * splits_[i].copies;
  }
}

void PlyStream::write_faces(std::uint64_t at, const MeshHeader& header) {
  std::vector<text::Colour> colours;
  if (contents_.has_colours) {
    colours = text::label_colours(meshes_.names(), header.colours);
  }
  std::uint32_t points = 0;
  auto copies = static_cast<std::uint32_t>(meshes_.points());
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (!meshes_.is_elsewhere(i)) {
      const TriMesh mesh = meshes_.mesh(i);
      const auto own = static_cast<std::uint32_t>(mesh.points.size());
      std::vector<Triangle> triangles =
          contents_.has_normals ? split_triangles(i, mesh.triangles.size()) : mesh.triangles;
      std::string bytes;
      for (std::size_t face = 0; face < triangles.size(); ++face) {
        for (std::uint32_t& corner : triangles[face]) {
          corner = corner < own ? points + corner : copies + (corner - own);
        }
        const std::uint32_t label =
            contents_.has_labels ? meshes_.numbers(i)[mesh.labels[face]] : 0;
        formats::store_ply_face(bytes, triangles[face], contents_.has_labels ? &label : nullptr,
                                contents_.has_colours ? &colours[label] : nullptr);
      }
      file_.write(at, bytes);
    }
    at += face_size() * meshes_.triangles_of(i);
    points += meshes_.points_of(i);
    copies += contents_.has_copies ? splits_[i].copies : 0;
  }
}

}  // namespace dupin::streams
