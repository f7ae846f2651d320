#include "streams/ply_stream.h"

#include "dupin/kernel/error.h"
#include "formats/ply_numbers.h"
#include "formats/split_points.h"
#include "text/label_colour.h"

namespace dupin::streams {

void PlyStream::append(const MeshPiece& piece, std::size_t) { meshes_.append(piece); }

void PlyStream::commit(const MeshHeader& header, const Normals& normals) {
  meshes_.number_labels();
  std::uint64_t copies = 0;
  if (normals) {
    split(normals);
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
  write(formats::ply_header_text(contents_, meshes_.names(), header,
                                 formats::PlyEncoding::little_endian));
  write_vertices();
  write_copies();
  write_faces(header);
  file_.commit();
}

void PlyStream::split(const Normals& normals) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const TriMesh mesh = meshes_.mesh(i);
    const formats::SplitPoints own = formats::split_points(mesh, normals(mesh));
    splits_.push_back({arrays_.end(), static_cast<std::uint32_t>(own.normals.size()),
                       static_cast<std::uint32_t>(own.copied.size())});
    arrays_.append(own.normals);
    arrays_.append(own.copied);
    arrays_.append(own.triangles);
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

void PlyStream::write_vertices() {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const TriMesh mesh = meshes_.mesh(i);
    const std::vector<Direction> normals = split_normals(i);
    std::string bytes;
    for (std::size_t point = 0; point < mesh.points.size(); ++point) {
      formats::store_ply_vertex(bytes, mesh.points[point],
                                contents_.has_normals ? &normals[point] : nullptr,
                                contents_.has_copies ? &number : nullptr);
      ++number;
    }
    write(bytes);
  }
}

void PlyStream::write_copies() {
  std::uint32_t before = 0;
  for (std::size_t i = 0; contents_.has_copies && i < meshes_.size(); ++i) {
    const TriMesh mesh = meshes_.mesh(i);
    const std::vector<Direction> normals = split_normals(i);
    std::string bytes;
    std::size_t vertex = mesh.points.size();
    for (const std::uint32_t point : copied(i)) {
      const std::uint32_t number = before + point;
      formats::store_ply_vertex(bytes, mesh.points[point], &normals[vertex++], &number);
    }
    before += static_cast<std::uint32_t>(mesh.points.size());
    write(bytes);
  }
}

void PlyStream::write_faces(const MeshHeader& header) {
  std::vector<text::Colour> colours;
  if (contents_.has_colours) {
    colours = text::label_colours(meshes_.names(), header.colours);
  }
  std::uint32_t points = 0;
  auto copies = static_cast<std::uint32_t>(meshes_.points());
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const TriMesh mesh = meshes_.mesh(i);
    const auto own = static_cast<std::uint32_t>(mesh.points.size());
    std::vector<Triangle> triangles =
        contents_.has_normals ? split_triangles(i, mesh.triangles.size()) : mesh.triangles;
    std::string bytes;
    for (std::size_t face = 0; face < triangles.size(); ++face) {
      for (std::uint32_t& corner : triangles[face]) {
        corner = corner < own ? points + corner : copies + (corner - own);
      }
      const std::uint32_t label = contents_.has_labels ? meshes_.numbers(i)[mesh.labels[face]] : 0;
      formats::store_ply_face(bytes, triangles[face], contents_.has_labels ? &label : nullptr,
                              contents_.has_colours ? &colours[label] : nullptr);
    }
    write(bytes);
    points += own;
    copies += contents_.has_copies ? splits_[i].copies : 0;
  }
}

void PlyStream::write(const std::string& bytes) {
  file_.append(bytes);
  if (!file_.holds_at(end_, bytes)) {
    throw Error(Errc::io_failed, "what was written is not what is read back", {}, shown_);
  }
  end_ += bytes.size();
}

}  // namespace dupin::streams
