#include "dupin/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "dupin/io/atomic_file.h"
#include "dupin/io/glb.h"
#include "dupin/io/obj.h"
#include "dupin/io/off.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/three_mf.h"
#include "dupin/kernel/error.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

/// One row per format, in the order of the enumerators.
struct FormatRow {
  MeshFormat format;
  std::string_view name;
  std::string_view extension;
  Coordinates coordinates;
  TriMesh (*read)(std::string_view bytes, std::string_view file);
  std::string (*write)(const TriMesh& mesh, const MeshHeader& header);
};

std::string stl_ascii_without_header(const TriMesh& mesh, const MeshHeader&) {
  return stl_ascii_text(mesh);
}

// Of formats that share an extension, the first is the one to write.
constexpr std::array kFormats = {
    FormatRow{MeshFormat::off, "OFF", ".off", Coordinates::binary64, read_off, off_text},
    FormatRow{MeshFormat::stl_binary, "binary STL", ".stl", Coordinates::binary32, read_stl_binary,
              stl_binary_bytes},
    FormatRow{MeshFormat::stl_ascii, "ASCII STL", ".stl", Coordinates::binary32, read_stl_ascii,
              stl_ascii_without_header},
    FormatRow{MeshFormat::ply_binary, "binary PLY", ".ply", Coordinates::binary64, read_ply,
              ply_binary_bytes},
    FormatRow{MeshFormat::ply_ascii, "ASCII PLY", ".ply", Coordinates::binary64, read_ply,
              ply_ascii_text},
    FormatRow{MeshFormat::obj, "OBJ", ".obj", Coordinates::binary64, read_obj, obj_text},
    FormatRow{MeshFormat::three_mf, "3MF", ".3mf", Coordinates::binary32, read_3mf, three_mf_bytes},
    FormatRow{MeshFormat::glb, "binary glTF", ".glb", Coordinates::binary32, read_glb, glb_bytes},
};
static_assert(kFormats.size() == kMeshFormats.size());

const FormatRow& row(MeshFormat format) {
  return *std::find_if(kFormats.begin(), kFormats.end(),
                       [&](const FormatRow& candidate) { return candidate.format == format; });
}

/// The format to write for an extension.
std::optional<MeshFormat> format_by_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  for (const FormatRow& candidate : kFormats) {
    if (candidate.extension == extension) {
      return candidate.format;
    }
  }
  return std::nullopt;
}

std::string known_extensions() {
  std::string known;
  std::string_view last;
  for (const FormatRow& format : kFormats) {
    if (format.extension != last) {
      known += (known.empty() ? "" : ", ") + std::string(format.extension);
    }
    last = format.extension;
  }
  return known;
}

bool is_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

bool is_three_mf(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

bool is_off(std::string_view bytes) {
  text::TextScanner scanner(bytes, {}, '#');
  scanner.skip_space();
  const std::string_view token = scanner.peek().substr(0, 8);
  return token.substr(0, token.find("OFF")).size() < token.size();
}

/// Text that begins with one of the statements that OBJ files begin with.
bool is_obj(std::string_view bytes) {
  text::TextScanner scanner(bytes, {}, '#');
  scanner.skip_space();
  return scanner.take("v") || scanner.take("o") || scanner.take("g") || scanner.take("mtllib");
}

bool is_stl_ascii(std::string_view bytes) {
  text::TextScanner scanner(bytes, {});
  scanner.skip_space();
  return scanner.take("solid");
}

MeshFormat format_of_content(std::string_view bytes, std::string_view file) {
  const std::optional<MeshFormat> by_extension = format_by_extension(file);
  if (is_glb(bytes)) {
    return MeshFormat::glb;
  }
  if (is_three_mf(bytes)) {
    return MeshFormat::three_mf;
  }
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) {
    return MeshFormat::ply_binary;  // its reader tells the encodings apart
  }
  if (is_off(bytes)) {
    return MeshFormat::off;
  }
  if (has_size_of_binary_stl(bytes)) {
    return MeshFormat::stl_binary;
  }
  if (is_obj(bytes)) {
    return MeshFormat::obj;
  }
  if (is_stl_ascii(bytes) || by_extension == MeshFormat::stl_binary) {
    return is_binary_stl(bytes) ? MeshFormat::stl_binary : MeshFormat::stl_ascii;
  }
  if (by_extension) {
    return *by_extension;
  }
  throw Error(Errc::parse_failed,
              "found " + text::quoted(bytes.substr(0, 16)) + " at the start, expected a mesh (" +
                  known_extensions() + ")",
              {}, std::string(file) + ":byte 0");
}

}  // namespace

std::string_view name(MeshFormat format) { return row(format).name; }

Coordinates coordinates(MeshFormat format) { return row(format).coordinates; }

MeshFormat format_of(const std::filesystem::path& path) {
  const std::optional<MeshFormat> format = format_by_extension(path);
  if (!format) {
    throw Error(Errc::invalid_argument,
                "the extension '" + path.extension().string() +
                    "' names no mesh format; known are " + known_extensions(),
                {}, path.string());
  }
  return *format;
}

TriMesh read_mesh(const std::filesystem::path& path) {
  return read_mesh(read_file(path), path.string());
}

TriMesh read_mesh(std::string_view bytes, std::string_view file, std::optional<MeshFormat> format) {
  return row(format ? *format : format_of_content(bytes, file)).read(bytes, file);
}

std::string mesh_unit(std::string_view bytes, std::string_view file) {
  if (is_three_mf(bytes)) {
    return unit_of_3mf(bytes, file);
  }
  if (is_glb(bytes)) {
    return unit_of_glb(bytes, file);
  }
  constexpr std::string_view kMark = "unit: ";
  constexpr std::size_t kHead = 512;  // our writers note it in the first lines
  const std::string_view head = bytes.substr(0, kHead);
  const std::size_t mark = head.find(kMark);
  if (mark == std::string_view::npos) {
    return {};
  }
  const std::string_view rest = head.substr(mark + kMark.size());
  return std::string(rest.substr(0, rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz")));
}

std::string mesh_bytes(const TriMesh& mesh, MeshFormat format, const MeshHeader& header) {
  return row(format).write(mesh, header);
}

void write_mesh(const std::filesystem::path& path, const TriMesh& mesh, MeshFormat format,
                const MeshHeader& header) {
  write_file(path, mesh_bytes(mesh, format, header));
}

void write_mesh(const std::filesystem::path& path, const TriMesh& mesh) {
  write_mesh(path, mesh, format_of(path));
}

}  // namespace dupin
