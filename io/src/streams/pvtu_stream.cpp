#include "streams/pvtu_stream.h"

#include <limits>
#include <memory>
#include <system_error>
#include <utility>

#include "dupin/io/atomic_file.h"
#include "dupin/io/vtu.h"
#include "dupin/kernel/error.h"

namespace dupin::streams {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path) {
  throw Error(Errc::io_failed, "what was written is not what is read back", {}, path.string());
}

/// Files that take their places together with the one that lists them, or not at all.
class ListedFiles {
 public:
  ListedFiles() = default;
  ~ListedFiles() {
    for (std::size_t i = 0; i < committed_; ++i) {
      std::error_code ignored;
      fs::remove(paths_[i], ignored);
    }
  }
  ListedFiles(const ListedFiles&) = delete;
  ListedFiles& operator=(const ListedFiles&) = delete;

  void add(const fs::path& path, const std::string& bytes) {
    paths_.push_back(path);
    files_.push_back(std::make_unique<AsideFile>(path, bytes));
    if (!files_.back()->holds(bytes)) {
      fail(path);
    }
  }
  void commit(AsideFile& index) {
    for (const std::unique_ptr<AsideFile>& file : files_) {
      file->commit();
      ++committed_;
    }
    index.commit();
    committed_ = 0;
  }

 private:
  std::vector<fs::path> paths_;
  std::vector<std::unique_ptr<AsideFile>> files_;
  std::size_t committed_ = 0;  // while the index is not
};

/// Text fit for an attribute.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

/// What all files have, and which these are.
std::string index_text(const std::vector<std::string>& files, bool have_labels, bool have_colours) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<!-- dupin -->\n"
      "<PUnstructuredGrid GhostLevel=\"0\">\n";
  if (have_labels) {
    text +=
        "<PCellData Scalars=\"label\">\n<PDataArray type=\"Int32\" Name=\"label\"/>\n"
        "<PDataArray type=\"Int32\" Name=\"part\"/>\n";
    if (have_colours) {
      text += "<PDataArray type=\"UInt8\" Name=\"colour\" NumberOfComponents=\"3\"/>\n";
    }
    text += "</PCellData>\n";
  }
  text +=
      "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
      "</PPoints>\n";
  for (const std::string& file : files) {
    text += "<Piece Source=\"" + escaped(file) + "\"/>\n";
  }
  return text + "</PUnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

PvtuStream::PvtuStream(fs::path path) : path_(std::move(path)), index_(path_) {}

void PvtuStream::append(const MeshPiece& piece, std::size_t file) {
  const std::uint64_t before = meshes_.triangles();
  meshes_.append(piece);
  if (meshes_.triangles() > before) {
    files_[file].push_back(meshes_.size() - 1);
  }
}

TriMesh PvtuStream::mesh_of(const std::vector<std::size_t>& pieces) const {
  TriMesh all;
  all.names = meshes_.names();
  for (const std::size_t piece : pieces) {
    const TriMesh mesh = meshes_.mesh(piece);
    const auto shift = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      all.triangles.push_back({a + shift, b + shift, c + shift});
    }
    for (const std::uint32_t label : mesh.labels) {
      all.labels.push_back(meshes_.numbers(piece)[label]);
    }
  }
  return all;
}

void PvtuStream::commit(const MeshHeader& header, const Normals&) {
  meshes_.number_labels();
  if (files_.empty()) {
    files_[0];  // readers want one
  }
  ListedFiles files;
  std::vector<std::string> names;
  for (const auto& [number, pieces] : files_) {
    names.push_back(path_.stem().string() + "_" + std::to_string(names.size()) + ".vtu");
    const fs::path path = path_.parent_path() / names.back();
    files.add(path,
              verified_volume_bytes({.surface = mesh_of(pieces)}, kVtu, header, path.string()));
  }
  const std::string text = index_text(names, meshes_.have_labels(), !header.colours.empty());
  index_.append(text);
  if (!index_.holds(text)) {
    fail(path_);
  }
  files.commit(index_);
}

}  // namespace dupin::streams
