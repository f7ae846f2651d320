#include "dupin/io/msh.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/volume_points.h"
#include "text/append_each.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

/// The physical group of tetrahedra: that after those of the labels.
std::size_t volume_group(const TriMesh& surface) {
  return (surface.labels.empty() ? 0 : surface.names.size()) + 1;
}

std::string without_quotes(std::string_view name) {
  std::string result = text::clean_line(name);
  std::ranges::replace(result, '"', '\'');  // there is no way to write it
  return result;
}

/// Format, names and nodes: `points`, those of the mesh and, of a volume, others.
std::string text_before_elements(const TriMesh& mesh, const std::vector<Vec3>& points,
                                 const MeshHeader& header, bool has_volume) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n" +
                     text::header_lines(header, "# ") + "$EndComments\n";
  const std::size_t labels = mesh.labels.empty() ? 0 : mesh.names.size();
  if (labels + (has_volume ? 1 : 0) > 0) {
    text += "$PhysicalNames\n" + std::to_string(labels + (has_volume ? 1 : 0)) + '\n';
    const std::vector<std::string> names = text::written_names(mesh.names, without_quotes);
    for (std::size_t i = 0; i < labels; ++i) {
      text += "2 " + std::to_string(i + 1) + " \"" + names[i] + "\"\n";
    }
    if (has_volume) {
      text += "3 " + std::to_string(volume_group(mesh)) + " \"" +
              without_quotes(header.name.empty() ? "volume" : header.name) + "\"\n";
    }
    text += "$EndPhysicalNames\n";
  }
  text += "$Nodes\n" + std::to_string(points.size()) + '\n';
  text::append_each(text, points.size(), [&](std::string& end, std::size_t i) {
    append_decimal(end, static_cast<std::uint32_t>(i + 1));
    end += ' ';
    text::append_point(end, points[i]);
    end += '\n';
  });
  return text + "$EndNodes\n";
}

template <class Corners>
void append_corners(std::string& text, const Corners& corners) {
  for (const std::uint32_t corner : corners) {
    text += ' ';
    append_decimal(text, corner + 1);
  }
  text += '\n';
}

void append_triangles(std::string& text, const TriMesh& mesh) {
  text::append_each(text, mesh.triangles.size(), [&](std::string& end, std::size_t i) {
    append_decimal(end, static_cast<std::uint32_t>(i + 1));
    const std::uint32_t physical = mesh.labels.empty() ? 0 : mesh.labels[i] + 1;
    end += " 2 2 " + std::to_string(physical) + ' ' + std::to_string(std::max(1U, physical));
    append_corners(end, mesh.triangles[i]);
  });
}

Evidence recognise(std::string_view bytes) {
  text::TextScanner scanner(bytes, {});
  scanner.skip_space();
  const std::string_view word = scanner.peek();
  return word == "$MeshFormat" ||
                 (word == "$Comments" &&
                  bytes.substr(0, 2000).find("$MeshFormat") != std::string_view::npos)
             ? Evidence::text_signature
             : Evidence::none;
}

}  // namespace

std::string msh_text(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  std::string text =
      text_before_elements(mesh, text::surface_points(mesh, Coordinates::binary64), header, false);
  text += "$Elements\n" + std::to_string(mesh.triangles.size()) + '\n';
  append_triangles(text, mesh);
  return text + "$EndElements\n";
}

std::string msh_volume_text(const VolumeMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const TriMesh& surface = mesh.surface;
  if (mesh.point_count() > 0 && (mesh.tetrahedra.empty() || surface.triangles.empty())) {
    throw Error(Errc::invalid_argument,
                "the mesh has " + std::to_string(mesh.point_count()) + " points and " +
                    std::to_string(mesh.tetrahedra.size()) + " tetrahedra within " +
                    std::to_string(surface.triangles.size()) +
                    " triangles; a gmsh volume needs some of both");
  }
  std::string text = text_before_elements(surface, formats::writable_points(mesh), header, true);
  text += "$Elements\n" + std::to_string(surface.triangles.size() + mesh.tetrahedra.size()) + '\n';
  append_triangles(text, surface);
  const std::string number = std::to_string(volume_group(surface));
  const std::string group = " 4 2 " + number + ' ' + number;
  text::append_each(text, mesh.tetrahedra.size(), [&](std::string& end, std::size_t i) {
    append_decimal(end, static_cast<std::uint32_t>(surface.triangles.size() + i + 1));
    end += group;
    append_corners(end, mesh.tetrahedra[i]);
  });
  return text + "$EndElements\n";
}

constinit const MeshFormat kMshSurface = {.key = "msh-surface",
                                          .name = "gmsh surface",
                                          .extension = {},
                                          .coordinates = Coordinates::binary64,
                                          .read = read_msh,
                                          .write = msh_text,
                                          .recognises = recognise,
                                          .unit = text::unit_behind_hash};

constinit const VolumeFormat kMshVolume = {.key = "msh",
                                           .name = "gmsh volume",
                                           .extension = ".msh",
                                           .write = msh_volume_text,
                                           .read = read_msh_volume};

}  // namespace dupin
