#include <string>

#include "dupin/io/volume_mesh.h"
#include "dupin/kernel/decimal.h"

namespace dupin {
namespace {

std::uint32_t label_of(const TriMesh& mesh, std::size_t triangle) {
  return mesh.labels.empty() ? 0 : mesh.labels[triangle];
}

std::vector<std::string> patch_names(const TriMesh& mesh) {
  return mesh.labels.empty() ? std::vector<std::string>{"surface"} : mesh.names;
}

/// Quotes would end a name.
std::string quoted(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) {
    text += c == '"' || c == '\n' || c == '\r' ? '_' : c;
  }
  return text + "\"";
}

void append_numbers(std::string& text, std::initializer_list<std::size_t> numbers) {
  char separator = '\0';
  for (const std::size_t number : numbers) {
    if (separator != '\0') {
      text += separator;
    }
    text += std::to_string(number);
    separator = ' ';
  }
  text += '\n';
}

void append_place(std::string& text, const Vec3& place) {
  append_decimal(text, place.x());
  text += ' ';
  append_decimal(text, place.y());
  text += ' ';
  append_decimal(text, place.z());
  text += '\n';
}

void begin_array(std::string& text, std::string_view type, std::string_view name,
                 std::string_view more = {}) {
  text += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + std::string(name) +
          "\" format=\"ascii\"" + std::string(more) + ">\n";
}

constexpr std::string_view kEndArray = "</DataArray>\n";

/// Texts are written as the numbers of their bytes, each ended by 0.
void append_names(std::string& text, const TriMesh& mesh, std::string_view volume_name) {
  std::vector<std::string> names = patch_names(mesh);
  names.insert(names.begin(), std::string(volume_name));
  text += "<FieldData>\n<Array type=\"String\" Name=\"patch_names\" NumberOfTuples=\"" +
          std::to_string(names.size()) + "\" format=\"ascii\">\n";
  for (const std::string& name : names) {
    for (const char c : name) {
      text += std::to_string(static_cast<unsigned char>(c)) + " ";
    }
    text += "0\n";
  }
  text += "</Array>\n</FieldData>\n";
}

void append_cells(std::string& text, const VolumeMesh& mesh) {
  const std::size_t tetrahedra = mesh.tetrahedra.size(), triangles = mesh.surface.triangles.size();
  text += "<Cells>\n";
  begin_array(text, "Int64", "connectivity");
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    append_numbers(text, {a, b, c, d});
  }
  for (const auto& [a, b, c] : mesh.surface.triangles) {
    append_numbers(text, {a, b, c});
  }
  text += kEndArray;
  begin_array(text, "Int64", "offsets");
  for (std::size_t i = 1; i <= tetrahedra; ++i) {
    append_numbers(text, {4 * i});
  }
  for (std::size_t i = 1; i <= triangles; ++i) {
    append_numbers(text, {4 * tetrahedra + 3 * i});
  }
  text += kEndArray;
  begin_array(text, "UInt8", "types");
  for (std::size_t i = 0; i < tetrahedra + triangles; ++i) {
    text += i < tetrahedra ? "10\n" : "5\n";
  }
  text += kEndArray;
  text += "</Cells>\n";
}

}  // namespace

std::string msh_text(const VolumeMesh& mesh, std::string_view volume_name) {
  const std::vector<std::string> names = patch_names(mesh.surface);
  const std::size_t volume = names.size() + 1;
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" +
                     std::to_string(names.size() + 1) + "\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "2 " + std::to_string(i + 1) + " " + quoted(names[i]) + "\n";
  }
  text += "3 " + std::to_string(volume) + " " + quoted(volume_name) +
          "\n$EndPhysicalNames\n$Nodes\n" + std::to_string(mesh.points.size()) + "\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    text += std::to_string(i + 1) + " ";
    append_place(text, mesh.points[i]);
  }
  const std::size_t triangles = mesh.surface.triangles.size();
  text += "$EndNodes\n$Elements\n" + std::to_string(triangles + mesh.tetrahedra.size()) + "\n";
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto& [a, b, c] = mesh.surface.triangles[i];
    const std::size_t patch = label_of(mesh.surface, i) + 1;
    append_numbers(text, {i + 1, 2, 2, patch, patch, a + 1, b + 1, c + 1});
  }
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const auto& [a, b, c, d] = mesh.tetrahedra[i];
    append_numbers(text, {triangles + i + 1, 4, 2, volume, volume, a + 1, b + 1, c + 1, d + 1});
  }
  return text + "$EndElements\n";
}

std::string vtu_text(const VolumeMesh& mesh, std::string_view volume_name) {
  const std::size_t tetrahedra = mesh.tetrahedra.size(), triangles = mesh.surface.triangles.size();
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  append_names(text, mesh.surface, volume_name);
  text += "<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
          std::to_string(tetrahedra + triangles) + "\">\n<Points>\n";
  begin_array(text, "Float64", "points", " NumberOfComponents=\"3\"");
  for (const Vec3& place : mesh.points) {
    append_place(text, place);
  }
  text += kEndArray;
  text += "</Points>\n";
  append_cells(text, mesh);
  text += "<CellData Scalars=\"patch\">\n";
  begin_array(text, "Int32", "patch");
  for (std::size_t i = 0; i < tetrahedra + triangles; ++i) {
    append_numbers(text, {i < tetrahedra ? 0 : label_of(mesh.surface, i - tetrahedra) + 1U});
  }
  text += kEndArray;
  return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace dupin
