#include "dupin/io/vtu.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "files/xml_events.h"
#include "formats/volume_points.h"
#include "formats/vtk_arrays.h"
#include "text/little_endian.h"

namespace dupin {
namespace {

constexpr std::uint8_t kVtkTriangle = 5, kVtkTetrahedron = 10;

/// Takes what `vtu_text` writes.
class VtuReader {
 public:
  VtuReader(std::string_view bytes, std::string_view file) : file_(file) {
    files::read_xml(bytes, std::string(file),
                    {[this](std::string_view element, const files::XmlAttributes& attributes) {
                       if (element == "DataArray") {
                         const auto text = [&](std::string_view name) {
                           return std::string(attributes.find(name).value_or(""));
                         };
                         array_ = formats::VtkArray{text("Name"), text("type"), text("format"), {}};
                       }
                       return true;
                     },
                     [this](std::string_view element) {
                       if (element == "DataArray" && array_) {
                         take(*std::exchange(array_, std::nullopt));
                       }
                     },
                     [this](std::string_view text) {
                       if (array_) {
                         array_->text += text;
                       }
                     }});
  }

  VolumeMesh mesh() && {
    VolumeMesh mesh;
    std::size_t begin = 0, on_surface = 0;
    for (const std::int64_t offset : offsets_) {
      const auto end = static_cast<std::size_t>(offset);
      if (offset < 0 || end > corners_.size() || (end != begin + 3 && end != begin + 4)) {
        fail("triangles and tetrahedra");
      }
      const auto corner = [&](std::size_t k) {
        const auto v = static_cast<std::uint64_t>(corners_[begin + k]);
        if (v >= coordinates_.size() / 3) {
          fail("corners that are points");
        }
        return static_cast<std::uint32_t>(v);
      };
      if (end == begin + 3) {
        mesh.surface.triangles.push_back({corner(0), corner(1), corner(2)});
        for (const std::uint32_t v : mesh.surface.triangles.back()) {
          on_surface = std::max<std::size_t>(on_surface, v + 1);
        }
      } else {
        mesh.tetrahedra.push_back({corner(0), corner(1), corner(2), corner(3)});
      }
      begin = end;
    }
    for (std::size_t i = 0; i + 2 < coordinates_.size(); i += 3) {
      (i / 3 < on_surface ? mesh.surface.points : mesh.inner_points)
          .emplace_back(coordinates_[i], coordinates_[i + 1], coordinates_[i + 2]);
    }
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw Error(Errc::parse_failed, "expected " + expected, {}, std::string(file_));
  }

  void take(const formats::VtkArray& array) {
    constexpr formats::VtkEncoding kOurs{false, sizeof(std::uint64_t)};
    if (array.name == "Points") {
      coordinates_ = formats::vtk_numbers<double>(array, kOurs);
    } else if (array.name == "connectivity") {
      corners_ = formats::vtk_numbers<std::int64_t>(array, kOurs);
    } else if (array.name == "offsets") {
      offsets_ = formats::vtk_numbers<std::int64_t>(array, kOurs);
    }
  }

  std::string_view file_;
  std::optional<formats::VtkArray> array_;
  std::vector<double> coordinates_;
  std::vector<std::int64_t> corners_, offsets_;
};

}  // namespace

std::string vtu_text(const VolumeMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const TriMesh& surface = mesh.surface;
  const std::vector<Vec3> points = formats::writable_points(mesh);
  const std::size_t cells = surface.triangles.size() + mesh.tetrahedra.size();
  if (3 * surface.triangles.size() + 4 * mesh.tetrahedra.size() >
      std::numeric_limits<std::int32_t>::max()) {
    throw Error(Errc::limit_exceeded, "VTK files of ours hold at most 2^31 corners");
  }
  std::string coordinates, corners, offsets, types;
  for (const Vec3& point : points) {
    for (const double coordinate : {point.x(), point.y(), point.z()}) {
      text::store(coordinates, coordinate);
    }
  }
  std::int32_t offset = 0;
  for (const Triangle& triangle : surface.triangles) {
    text::store(corners, triangle);
    text::store(offsets, offset += 3);
    text::store(types, kVtkTriangle);
  }
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
    text::store(corners, tetrahedron);
    text::store(offsets, offset += 4);
    text::store(types, kVtkTetrahedron);
  }
  const formats::VtkParts parts(surface.names);
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<!-- dupin -->\n<UnstructuredGrid>\n";
  formats::append_vtk_field_data(text, surface, header, parts);
  text += "<Piece NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\"" +
          std::to_string(cells) + "\">\n";
  if (!surface.labels.empty()) {
    formats::append_vtk_cell_data(text, surface, header, parts, mesh.tetrahedra.size());
  }
  text += "<Points>\n";
  formats::append_vtk_array<double>(text, "Name=\"Points\" NumberOfComponents=\"3\"", coordinates);
  text += "</Points>\n<Cells>\n";
  formats::append_vtk_array<std::int32_t>(text, "Name=\"connectivity\"", corners);
  formats::append_vtk_array<std::int32_t>(text, "Name=\"offsets\"", offsets);
  formats::append_vtk_array<std::uint8_t>(text, "Name=\"types\"", types);
  return text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

VolumeMesh read_vtu(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  return VtuReader(bytes, file).mesh();
}

constinit const VolumeFormat kVtu = {.key = "vtu",
                                     .name = "VTK unstructured grid",
                                     .extension = ".vtu",
                                     .write = vtu_text,
                                     .read = read_vtu};

}  // namespace dupin
