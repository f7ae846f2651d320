#include "dupin/io/vtp.h"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "dupin/kernel/error.h"
#include "text/base64.h"
#include "text/label_colour.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"

namespace dupin {
namespace {

template <class Number>
void append_array(std::string& text, std::string_view attributes, const std::string& bytes) {
  std::string all;
  all.reserve(bytes.size() + sizeof(std::uint64_t));
  text::store(all, std::uint64_t{bytes.size()});
  all += bytes;
  text += "<DataArray type=\"";
  text += std::is_same_v<Number, double>         ? "Float64"
          : std::is_same_v<Number, std::uint8_t> ? "UInt8"
                                                 : "Int32";
  text += "\" " + std::string(attributes) + " format=\"binary\">" + text::base64(all) +
          "</DataArray>\n";
}

// As VTK has texts in XML: the numbers of their bytes, each text ended by a zero.
void append_strings(std::string& text, std::string_view name,
                    const std::vector<std::string>& strings) {
  text += "<Array type=\"String\" Name=\"" + std::string(name) + "\" NumberOfTuples=\"" +
          std::to_string(strings.size()) + "\" format=\"ascii\">\n";
  for (const std::string& string : strings) {
    for (const char c : text::clean_line(string)) {
      text += std::to_string(static_cast<unsigned char>(c)) + ' ';
    }
    text += "0\n";
  }
  text += "</Array>\n";
}

// What names begin with, up to their first dots, and which of these each is of.
struct Parts {
  explicit Parts(const std::vector<std::string>& labels) {
    std::map<std::string, std::int32_t> known;
    for (const std::string& label : labels) {
      const auto [part, is_new] =
          known.try_emplace(label.substr(0, label.find('.')), std::int32_t(names.size()));
      if (is_new) {
        names.push_back(part->first);
      }
      of_label.push_back(part->second);
    }
  }

  std::vector<std::string> names;
  std::vector<std::int32_t> of_label;
};

void append_field_data(std::string& text, const TriMesh& mesh, const MeshHeader& header,
                       const Parts& parts) {
  text += "<FieldData>\n";
  if (!mesh.labels.empty()) {
    append_strings(text, "label_names", mesh.names);
    append_strings(text, "part_names", parts.names);
  }
  if (!header.unit.empty()) {
    append_strings(text, "unit", {header.unit});
  }
  if (!header.note.empty()) {
    append_strings(text, "note", {header.note});
  }
  text += "</FieldData>\n";
}

void append_cell_data(std::string& text, const TriMesh& mesh, const MeshHeader& header,
                      const Parts& parts) {
  const std::vector<text::Colour> of_label = text::label_colours(mesh.names, header.colours);
  std::string labels, of_parts, colours;
  for (const std::uint32_t label : mesh.labels) {
    text::store(labels, label);
    text::store(of_parts, parts.of_label[label]);
    text::store(colours, of_label[label]);
  }
  text += "<CellData Scalars=\"label\">\n";
  append_array<std::int32_t>(text, "Name=\"label\"", labels);
  append_array<std::int32_t>(text, "Name=\"part\"", of_parts);
  if (!header.colours.empty()) {
    append_array<std::uint8_t>(text, "Name=\"colour\" NumberOfComponents=\"3\"", colours);
  }
  text += "</CellData>\n";
}

Evidence recognise(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 1000);
  return head.find("<VTKFile") != std::string_view::npos &&
                 head.find("PolyData") != std::string_view::npos
             ? Evidence::signature
             : Evidence::none;
}

}  // namespace

std::string vtp_text(const TriMesh& mesh, const MeshHeader& header) {
  const std::vector<Vec3> points = text::writable_points(mesh, Coordinates::binary64);
  if (3 * mesh.triangles.size() > std::numeric_limits<std::int32_t>::max()) {
    throw Error(Errc::limit_exceeded, "VTK files of ours hold at most 2^31 corners");
  }
  const Parts parts(mesh.names);
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
  append_field_data(text, mesh, header, parts);
  text += "<Piece NumberOfPoints=\"" + std::to_string(points.size()) +
          "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
          std::to_string(mesh.triangles.size()) + "\">\n";
  if (!mesh.labels.empty()) {
    append_cell_data(text, mesh, header, parts);
  }
  text += "<Points>\n";
  append_array<double>(text, "Name=\"Points\" NumberOfComponents=\"3\"", coordinates);
  text += "</Points>\n<Polys>\n";
  append_array<std::int32_t>(text, "Name=\"connectivity\"", corners);
  append_array<std::int32_t>(text, "Name=\"offsets\"", offsets);
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
