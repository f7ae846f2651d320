#include "formats/stl_binary.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/stl_facet.h"
#include "text/append_each.h"
#include "text/known_unit.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

using formats::kStlHeader, formats::kStlPreamble, formats::kStlVector, formats::kStlFacet;

constexpr std::string_view kNameMark = "solid ";
constexpr std::string_view kWriter = "dupin binary STL";
constexpr std::string_view kUnitMark = "; unit: ";

[[noreturn]] void fail(std::string_view file, std::uint64_t place, const std::string& message) {
  throw Error(Errc::parse_failed, message, {},
              std::string(file) + ":byte " + std::to_string(place));
}

/// What follows "solid " at the header's start or behind a semicolon.
std::string name_in(std::string_view header) {
  header = header.substr(0, header.find('\0'));
  const std::size_t behind = header.find("; solid ");
  if (behind != std::string_view::npos) {
    return text::clean_line(header.substr(behind + 2 + kNameMark.size()));
  }
  return header.starts_with(kNameMark) ? text::clean_line(header.substr(kNameMark.size()))
                                       : std::string();
}

/// The coordinates of the three corners of the facet that begins at `place`.
std::array<float, 9> corners_at(std::string_view bytes, std::size_t place) {
  return text::load<std::array<float, 9>>(bytes, place + kStlVector);
}

Vec3 point_of(const std::array<float, 9>& corners, std::size_t corner) {
  return {corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2]};
}

}  // namespace

std::uint32_t formats::stl_triangles(std::string_view preamble, std::uint64_t size,
                                     std::string_view file) {
  if (size < kStlPreamble) {
    fail(file, 0,
         "found a file of " + std::to_string(size) +
             " bytes, expected at least the 84 that begin a binary STL, or the word 'solid'");
  }
  const auto count = text::load<std::uint32_t>(preamble, kStlHeader);
  if (size != kStlPreamble + std::uint64_t{count} * kStlFacet) {
    fail(file, kStlHeader,
         "found a count of " + std::to_string(count) + " triangles in a file of " +
             std::to_string(size) + " bytes, expected " +
             std::to_string(kStlPreamble + std::uint64_t{count} * kStlFacet) + " bytes");
  }
  return count;
}

Facet formats::stl_facet(std::string_view bytes, std::size_t at, std::uint64_t place,
                         std::string_view file) {
  Facet corners = corners_at(bytes, at);
  for (std::size_t k = 0; k < 3; ++k) {
    if (const Vec3 point = point_of(corners, k); !point.allFinite()) {
      std::string found;
      text::append_point(found, point);
      fail(file, place + (k + 1) * kStlVector,
           "found the point (" + found + "), expected finite coordinates");
    }
  }
  for (float& coordinate : corners) {
    coordinate += 0.0F;  // -0 becomes 0
  }
  return corners;
}

// Cut between characters; must not begin with "solid".
std::string formats::stl_binary_preamble(const std::string& name, const MeshHeader& header,
                                         std::uint32_t triangles) {
  std::string text(kWriter);
  if (!header.unit.empty()) {
    text += std::string(kUnitMark) + text::clean_line(header.unit);
  }
  if (!header.note.empty()) {
    text += "; " + text::clean_line(header.note);
  }
  if (!name.empty()) {
    text += "; " + std::string(kNameMark) + text::clean_line(name);
  }
  std::size_t end = std::min(text.size(), kStlHeader);
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  text.resize(end);
  text.resize(kStlHeader, '\0');
  text::store(text, triangles);
  return text;
}

std::string formats::stl_unit(std::string_view header) {
  const std::string mark = std::string(kWriter) + std::string(kUnitMark);
  if (!header.starts_with(mark)) {
    return {};
  }
  header = header.substr(mark.size(), kStlHeader - mark.size());
  const std::string_view unit = header.substr(0, header.find_first_of(std::string_view(";\0", 2)));
  return text::metres_in(unit) ? std::string(unit) : std::string();
}

formats::StlMesh::StlMesh(std::size_t facets) : points_(facets / 2) {
  mesh_.triangles.reserve(facets);
}

void formats::StlMesh::add(const Facet& facet) {
  Triangle& triangle = mesh_.triangles.emplace_back();
  for (std::size_t corner = 0; corner < 3; ++corner) {
    triangle[corner] = points_.index_of(point_of(facet, corner));
  }
}

TriMesh formats::StlMesh::take(std::string_view header) && {
  mesh_.points = std::move(points_).take_points();
  const std::string name = name_in(header);
  if (!name.empty() && !mesh_.triangles.empty()) {
    mesh_.names = {name};
    mesh_.labels.assign(mesh_.triangles.size(), 0);
  }
  return std::move(mesh_);
}

bool has_size_of_binary_stl(std::string_view bytes) {
  return bytes.size() >= kStlPreamble &&
         bytes.size() ==
             kStlPreamble + std::size_t{text::load<std::uint32_t>(bytes, kStlHeader)} * kStlFacet;
}

bool is_binary_stl(std::string_view bytes) {
  if (has_size_of_binary_stl(bytes)) {
    return true;
  }
  const std::string_view start = bytes.substr(0, 1024);
  text::TextScanner scanner(start, {});
  scanner.skip_space();
  return !scanner.take("solid") || start.find('\0') != std::string_view::npos;
}

TriMesh read_stl_binary(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  const std::size_t count = formats::stl_triangles(bytes, bytes.size(), file);
  formats::StlMesh mesh(count);
  for (std::size_t facet = kStlPreamble; facet < bytes.size(); facet += kStlFacet) {
    mesh.add(formats::stl_facet(bytes, facet, facet, file));
  }
  return std::move(mesh).take(bytes.substr(0, kStlHeader));
}

bool formats::stl_binary_lists(const TriMesh& mesh, std::string_view bytes) {
  if (!has_size_of_binary_stl(bytes) ||
      bytes.size() != kStlPreamble + mesh.triangles.size() * kStlFacet) {
    return false;
  }
  std::size_t facet = kStlPreamble;
  for (const Triangle& triangle : mesh.triangles) {
    const auto corners = corners_at(bytes, facet);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (mesh.points[triangle[corner]] != point_of(corners, corner)) {
        return false;
      }
    }
    facet += kStlFacet;
  }
  return true;
}

std::string stl_binary_bytes(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary32);
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Errc::limit_exceeded, "binary STL holds at most 4294967295 triangles");
  }
  const bool is_named = mesh.names.size() == 1 && !mesh.labels.empty();
  std::string bytes =
      formats::stl_binary_preamble(is_named ? mesh.names.front() : std::string(), header,
                                   static_cast<std::uint32_t>(mesh.triangles.size()));
  bytes.reserve(kStlPreamble + mesh.triangles.size() * kStlFacet);
  text::append_each(bytes, mesh.triangles.size(), [&](std::string& end, std::size_t i) {
    const Triangle& triangle = mesh.triangles[i];
    std::array<float, 12> numbers;
    Eigen::Map<Eigen::Matrix<float, 3, 4>> columns(numbers.data());
    columns.col(0) = formats::facet_normal(triangle, points);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      columns.col(static_cast<Eigen::Index>(corner) + 1) = points[triangle[corner]].cast<float>();
    }
    text::store(end, numbers);
    text::store(end, std::uint16_t{0});
  });
  return bytes;
}

}  // namespace dupin
