#include "dupin/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "dupin/io/atomic_file.h"
#include "dupin/io/glb.h"
#include "dupin/io/msh.h"
#include "dupin/io/obj.h"
#include "dupin/io/off.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/three_mf.h"
#include "dupin/io/vtp.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "text/lower_case.h"
#include "text/text_scanner.h"
#include "text/utf16.h"

namespace dupin {
namespace {

const MeshFormat* find_by_extension(const std::filesystem::path& path) {
  const std::string extension = text::lower_case(path.extension().string());
  for (const MeshFormat& format : mesh_formats()) {
    if (!extension.empty() && format.extension == extension) {
      return &format;
    }
  }
  return nullptr;
}

std::string known_extensions() {
  std::string known;
  for (const MeshFormat& format : mesh_formats()) {
    if (!format.extension.empty()) {
      known += (known.empty() ? "" : ", ") + std::string(format.extension);
    }
  }
  return known;
}

/// Of what is read. That of gmsh writes volumes, but is read as their surface.
std::string readable_extensions() {
  return known_extensions() + ", " + std::string(kMshVolume.extension);
}

Error unknown_content(std::string_view bytes, std::string_view file) {
  constexpr std::size_t kHead = 1000, kQuoted = 16;
  const std::string_view head = bytes.substr(0, kHead);
  const bool is_vtu = head.find("<VTKFile") != std::string_view::npos &&
                      head.find("UnstructuredGrid") != std::string_view::npos;
  const std::string found = is_vtu
                                ? "a VTK UnstructuredGrid, which is written but not read (" +
                                      std::string(kMshVolume.extension) + " holds the same, and is)"
                                : text::quoted(bytes.substr(0, kQuoted)) + " at the start";
  return Error(Errc::parse_failed,
               "found " + found + ", expected a mesh (" + readable_extensions() + ")", {},
               std::string(file) + ":byte 0");
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
  static const std::array formats = {kOff, kStlAscii, kStlBinary, kPlyAscii, kPlyBinary,
                                     kObj, kThreeMf,  kGlb,       kVtp,      kMshSurface};
  return formats;
}

const MeshFormat* find_mesh_format(std::string_view key) {
  const std::span<const MeshFormat> formats = mesh_formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const MeshFormat& format) { return format.key == key; });
  return found == formats.end() ? nullptr : &*found;
}

const MeshFormat& format_of(const std::filesystem::path& path) {
  const MeshFormat* const format = find_by_extension(path);
  if (format == nullptr) {
    throw Error(Errc::invalid_argument,
                "the extension '" + path.extension().string() +
                    "' names no mesh format; known are " + known_extensions(),
                {}, path.string());
  }
  return *format;
}

namespace {

// None if nothing in it tells.
const MeshFormat* recognised(std::string_view bytes) {
  const MeshFormat* found = nullptr;
  Evidence strongest = Evidence::none;
  for (const MeshFormat& format : mesh_formats()) {
    const Evidence evidence = format.recognises(bytes);
    if (evidence > strongest) {
      strongest = evidence;
      found = &format;
    }
  }
  return found;
}

// What is XML may be in UTF-16, and says so.
void refuse_other_encodings(const MeshFormat* format, std::string_view bytes,
                            std::string_view file) {
  if (format == nullptr || format->key != kVtp.key) {
    text::refuse_utf16(bytes, std::string(file));
  }
}

}  // namespace

const MeshFormat* format_of_content(std::string_view bytes, std::string_view file) {
  const MeshFormat* const found = recognised(bytes);
  return found != nullptr ? found : find_by_extension(file);
}

TriMesh read_mesh(const std::filesystem::path& path) {
  return read_mesh(read_file(path), path.string());
}

TriMesh read_mesh(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  const MeshFormat* format = recognised(bytes);
  if (format == nullptr) {
    format = find_by_extension(file);
    refuse_other_encodings(format, bytes, file);
  }
  if (format == nullptr) {
    throw unknown_content(bytes, file);
  }
  try {
    return format->read(bytes, file);
  } catch (const Error& error) {  // of a limit, which is not one place's
    throw Error(error.code(), error.message(), error.part(),
                error.where().empty() ? std::string(file) : error.where());
  }
}

std::string mesh_unit(std::string_view bytes, std::string_view file) {
  const MeshFormat* const format = format_of_content(bytes, file);
  return format != nullptr ? format->unit(bytes, file) : std::string();
}

std::string mesh_bytes(const TriMesh& mesh, const MeshFormat& format, const MeshHeader& header) {
  const UsualArithmetic usual;
  return format.write(mesh, header);
}

void write_mesh(const std::filesystem::path& path, const TriMesh& mesh, const MeshFormat& format,
                const MeshHeader& header) {
  const UsualArithmetic usual;
  write_file(path, mesh_bytes(mesh, format, header));
}

void write_mesh(const std::filesystem::path& path, const TriMesh& mesh) {
  write_mesh(path, mesh, format_of(path));
}

}  // namespace dupin
