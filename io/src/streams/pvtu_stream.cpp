#include "streams/pvtu_stream.h"

#include <limits>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "dupin/io/atomic_file.h"
#include "dupin/io/vtu.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "files/placed_file.h"
#include "streams/point_numbers.h"

namespace dupin::streams {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path) {
  throw Error(Errc::io_failed, "what was written is not what is read back", {}, path.string());
}

/// Files that take their places together with the one that lists them, or not at all.
class ListedFiles {
 public:
  /// Those that are own are made, and the others learned of: whichever process ends early removes
  /// all.
  ListedFiles(std::vector<fs::path> paths, const std::vector<bool>& are_own,
              const Processes* processes)
      : paths_(std::move(paths)), files_(paths_.size()) {
    std::string own;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (are_own[i]) {
        files_[i] = std::make_unique<AsideFile>(paths_[i]);
        own += std::to_string(i) + " " + files_[i]->path().string() + '\0';
      }
    }
    if (processes != nullptr) {
      for (const std::string& made : processes->exchanged(own)) {
        learn_of(made);
      }
    }
  }
  ~ListedFiles() {
    for (std::size_t i = 0; i < committed_; ++i) {
      std::error_code ignored;
      fs::remove(paths_[i], ignored);
    }
  }
  ListedFiles(const ListedFiles&) = delete;
  ListedFiles& operator=(const ListedFiles&) = delete;

  void write(std::size_t i, const std::string& bytes) {
    files_[i]->append(bytes);
    if (!files_[i]->holds(bytes)) {
      fail(paths_[i]);
    }
    files_[i]->sync();
  }
  /// Else another process has removed it, as it could not write its own.
  [[nodiscard]] bool is_there(std::size_t i) const { return fs::exists(files_[i]->path()); }
  void commit(AsideFile& index) {
    for (const std::unique_ptr<AsideFile>& file : files_) {
      file->commit();
      ++committed_;
    }
    index.commit();
    committed_ = 0;
  }

 private:
  /// Numbers of files, and where these are aside.
  void learn_of(std::string_view made) {
    while (!made.empty()) {
      const std::size_t space = made.find(' '), end = made.find('\0');
      const std::size_t i = std::stoul(std::string(made.substr(0, space)));
      if (!files_[i]) {
        files_[i] = std::make_unique<AsideFile>(
            paths_[i], AsidePath{std::string(made.substr(space + 1, end - space - 1))});
      }
      made.remove_prefix(end + 1);
    }
  }

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

std::string listed_name(const fs::path& pvtu, std::size_t number) {
  return pvtu.stem().string() + "_" + std::to_string(number) + ".vtu";
}

PvtuStream::PvtuStream(fs::path path, const Processes* processes)
    : path_(std::move(path)),
      processes_(processes != nullptr && processes->count() > 1 ? processes : nullptr),
      meshes_(path_.string()) {
  index_ = files::joint_aside(path_, processes_);
}

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
  const NumberedPoints points = numbered_points(meshes_, pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TriMesh mesh = meshes_.mesh(pieces[i]);
    std::vector<std::uint32_t> numbers;
    numbers.reserve(mesh.points.size());
    for (const Vec3& point : mesh.points) {
      numbers.push_back(points.pieces[i].of(static_cast<std::uint32_t>(numbers.size())));
      if (numbers.back() == all.points.size()) {
        all.points.push_back(point);
      }
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      all.triangles.push_back({numbers[a], numbers[b], numbers[c]});
    }
    for (const std::uint32_t label : mesh.labels) {
      all.labels.push_back(meshes_.numbers(pieces[i])[label]);
    }
  }
  return all;
}

bool PvtuStream::is_own(const std::vector<std::size_t>& pieces) const {
  return pieces.empty() ? processes_ == nullptr || processes_->is_first()
                        : !meshes_.is_elsewhere(pieces.front());
}

void PvtuStream::commit(const MeshHeader& header, const Normals&) {
  const UsualArithmetic usual;
  meshes_.number_labels();
  if (files_.empty()) {
    files_[0];  // readers want one
  }
  std::vector<std::string> names;
  std::vector<fs::path> paths;
  std::vector<bool> are_own;
  for (const auto& [file, pieces] : files_) {
    names.push_back(listed_name(path_, names.size()));
    paths.push_back(path_.parent_path() / names.back());
    are_own.push_back(is_own(pieces));
  }
  ListedFiles files(paths, are_own, processes_);
  std::size_t number = 0;
  for (const auto& [file, pieces] : files_) {
    if (are_own[number]) {
      const std::string bytes =
          verified_volume_bytes({.surface = mesh_of(pieces)}, kVtu, header, paths[number].string());
      try {
        files.write(number, bytes);
      } catch (const Error&) {
        if (processes_ != nullptr && !files.is_there(number)) {
          processes_->let_another_speak();
        }
        throw;
      }
    }
    ++number;
  }
  if (processes_ != nullptr) {
    (void)processes_->exchanged({});  // all are written
  }
  if (processes_ == nullptr || processes_->is_first()) {
    const std::string text = index_text(names, meshes_.have_labels(), !header.colours.empty());
    index_->append(text);
    if (!index_->holds(text)) {
      fail(path_);
    }
    files.commit(*index_);
  }
  if (processes_ != nullptr) {
    (void)processes_->exchanged({});  // and in their places
  }
}

}  // namespace dupin::streams
