#include "dupin/io/vtp.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/vtk_arrays.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"

namespace dupin {
namespace {

Evidence recognise(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 1000);
  return head.find("<VTKFile") != std::string_view::npos &&
                 head.find("PolyData") != std::string_view::npos
             ? Evidence::text_signature
             : Evidence::none;
}

}  // namespace

std::string vtp_text(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary64);
  if (3 * mesh.triangles.size() > std::numeric_limits<std::int32_t>::max()) {
    throw Error(Errc::limit_exceeded, "VTK files of ours hold at most 2^31 corners");
  }
  const formats::VtkParts parts(mesh.names);
  std::string coordinates, corners, offsets;
  for (const Vec3& point : points) {
    text::store(coordinates, point.x());
    text::store(coordinates, point.y());
    text::store(coordinates, point.z());
  }
  std::int32_t offset = 0;
  for (const Triangle& triangle : mesh.triangles) {
    text::store(corners, triangle);
    text::store(offsets, offset += 3);
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<!-- dupin -->\n<PolyData>\n";
  formats::append_vtk_field_data(text, mesh, header, parts);
  text += "<Piece NumberOfPoints=\"" + std::to_string(points.size()) +
          "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
          std::to_string(mesh.triangles.size()) + "\">\n";
  if (!mesh.labels.empty()) {
    formats::append_vtk_cell_data(text, mesh, header, parts);
  }
  text += "<Points>\n";
  formats::append_vtk_array<double>(text, "Name=\"Points\" NumberOfComponents=\"3\"", coordinates);
  text += "</Points>\n<Polys>\n";
  formats::append_vtk_array<std::int32_t>(text, "Name=\"connectivity\"", corners);
  formats::append_vtk_array<std::int32_t>(text, "Name=\"offsets\"", offsets);
  return text + "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

constinit const MeshFormat kVtp = {.key = "vtp",
                                   .name = "VTK PolyData",
                                   .extension = ".vtp",
                                   .coordinates = Coordinates::binary64,
                                   .read = read_vtp,
                                   .write = vtp_text,
                                   .recognises = recognise,
                                   .unit = unit_of_vtp};

}  // namespace dupin
