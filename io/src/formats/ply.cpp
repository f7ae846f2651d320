#include "dupin/io/ply.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/ply_header.h"
#include "formats/ply_numbers.h"
#include "formats/split_points.h"
#include "text/append_each.h"
#include "text/byte_order_mark.h"
#include "text/label_colour.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"
#include "text/polygon.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

constexpr const char* kStripsLabel = "tristrips";  // of their triangles, where faces have labels
constexpr std::int64_t kMostPoints = std::numeric_limits<std::uint32_t>::max();

/// Position of a property by its name, if it has the wanted form.
std::optional<std::size_t> find_property(const formats::PlyElement& element, std::string_view name,
                                         bool is_list, bool integers) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const formats::PlyProperty& property = element.properties[i];
    if (property.name == name && property.is_list == is_list &&
        (!integers || formats::is_integer(property.type))) {
      return i;
    }
  }
  return std::nullopt;
}

/// Fills a mesh from the elements of a file, in their order.
template <typename Numbers>
class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string_view file, const formats::PlyHeader& header)
      : header_(header), places_(bytes, file), numbers_(bytes, file, header) {}

  TriMesh read() && {
    for (const std::string& name : header_.label_names) {
      (void)labels_.label(name);
    }
    bool has_vertices = false;
    for (const formats::PlyElement& element : header_.elements) {
      demand_room(element);
      if (element.name == "vertex" && !has_vertices) {
        read_vertices(element);
        has_vertices = true;
      } else if (element.name == "face") {
        read_faces(element, has_vertices);
      } else if (element.name == "tristrips" && element.count > 0) {
        read_strips(element, has_vertices);
      } else {
        skip_all(element);
      }
    }
    numbers_.end();
    if (!has_vertices) {
      places_.fail_at(0, "found no element 'vertex', expected one");
    }
    require_faces();
    merge_vertices();
    if (!mesh_.labels.empty()) {
      std::move(labels_).name_labels(mesh_);
    }
    return std::move(mesh_);
  }

 private:
  void demand_room(const formats::PlyElement& element) const {
    const std::size_t least = element.count * element.smallest_size(header_.encoding);
    if (least > numbers_.remaining()) {
      places_.fail_at(element.place, "found a count of " + std::to_string(element.count) +
                                         " elements '" + element.name + "', expected at least " +
                                         std::to_string(least) + " bytes for them, not " +
                                         std::to_string(numbers_.remaining()));
    }
  }

  /// A cloud of points, or one with other kinds of faces, is no mesh.
  void require_faces() const {
    if (mesh_.points.empty() || !mesh_.triangles.empty()) {
      return;
    }
    std::size_t place = 0;
    for (const formats::PlyElement& element : header_.elements) {
      place = element.name == "face" || place == 0 ? element.place : place;
    }
    places_.fail_at(place, "found " + std::to_string(mesh_.points.size()) +
                               " vertices and no face, expected an element 'face' with some");
  }

  void skip_property(const formats::PlyProperty& property) {
    std::int64_t count = 1;
    if (property.is_list) {
      count =
          numbers_.integer(property.count_type, 0, kMostPoints, "the length of a list, an integer");
    }
    for (std::int64_t i = 0; i < count; ++i) {
      numbers_.skip(property.type);
    }
  }

  void skip_all(const formats::PlyElement& element) {
    // Elements without properties take no room, so their count means nothing.
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      numbers_.begin_element();
      for (const formats::PlyProperty& property : element.properties) {
        skip_property(property);
      }
      numbers_.end_element();
    }
  }

  void read_vertices(const formats::PlyElement& element) {
    std::vector<int> axis_of(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = "xyz"[axis];
      const auto found = find_property(element, {&letter, 1}, false, false);
      if (!found) {
        std::string message = "found an element 'vertex' without a number '";
        message += letter;
        places_.fail_at(element.place, message + "', expected x, y and z");
      }
      axis_of[*found] = axis;
    }
    const auto copies = find_property(element, formats::kPlyPointProperty, false, true);
    copies_place_ = element.place;
    mesh_.points.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers_.begin_element();
      Vec3 point;
      for (std::size_t k = 0; k < axis_of.size(); ++k) {
        if (k == copies) {
          point_of_.push_back(static_cast<std::uint32_t>(numbers_.integer(
              element.properties[k].type, 0, kMostPoints, "the number of a point, an integer")));
        } else if (axis_of[k] < 0) {
          skip_property(element.properties[k]);
        } else {
          point[axis_of[k]] = numbers_.number(element.properties[k].type, "a coordinate");
        }
      }
      mesh_.points.push_back(point);
      numbers_.end_element();
    }
  }

  /// Of our own files: points have their own number, and are followed by copies.
  void merge_vertices() {
    std::size_t count = 0;
    while (count < point_of_.size() && point_of_[count] == count) {
      ++count;
    }
    if (!formats::merge_copies({point_of_.begin() + std::ptrdiff_t(count), point_of_.end()},
                               mesh_)) {
      places_.fail_at(copies_place_,
                      "found other numbers as 'dupin_point' of the vertices, expected points with "
                      "their own, and copies of them behind");
    }
  }

  void read_faces(const formats::PlyElement& element, bool has_vertices) {
    auto corners = find_property(element, "vertex_indices", true, true);
    if (!corners) {
      corners = find_property(element, "vertex_index", true, true);
    }
    if (!corners || !has_vertices) {
      places_.fail_at(element.place, corners
                                         ? "found the element 'face', expected 'vertex' before it"
                                         : "found an element 'face' without a list of integers "
                                           "'vertex_indices', expected one");
    }
    const auto label = find_property(element, "label", false, true);
    if (label && !mesh_.triangles.empty() && mesh_.labels.empty()) {
      mesh_.labels.resize(mesh_.triangles.size(), labels_.label(kStripsLabel));
    }
    mesh_.triangles.reserve(mesh_.triangles.size() + element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers_.begin_element();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        if (k == *corners) {
          read_polygon(element.properties[k]);
        } else if (k == label) {
          label_ =
              numbers_.integer(element.properties[k].type, 0, kMostPoints, "a label, an integer");
        } else {
          skip_property(element.properties[k]);
        }
      }
      if (label) {
        mesh_.labels.resize(mesh_.triangles.size(), labels_.label(label_name()));
      }
      numbers_.end_element();
    }
  }

  void read_polygon(const formats::PlyProperty& property) {
    if constexpr (std::is_same_v<Numbers, formats::PlyByteNumbers>) {
      if (numbers_.at_triangle(property, mesh_.points.size())) {
        mesh_.triangles.push_back(numbers_.take_triangle());
        return;
      }
    }
    const std::size_t place = numbers_.position();
    const std::int64_t size = numbers_.integer(property.count_type, 3, kMostPoints,
                                               "the number of a face's vertices, an integer");
    corners_.clear();
    for (std::int64_t i = 0; i < size; ++i) {
      corners_.push_back(static_cast<std::uint32_t>(
          numbers_.integer(property.type, 0, static_cast<std::int64_t>(mesh_.points.size()) - 1,
                           "the index of a vertex, an integer")));
    }
    text::triangulate(corners_, mesh_.points, mesh_.triangles,
                      [&] { return numbers_.place(place); });
  }

  /// Lists of points of which three that follow each other are a triangle, every other one turned;
  /// -1 begins anew, and triangles that are none turn.
  void read_strips(const formats::PlyElement& element, bool has_vertices) {
    const auto corners = find_property(element, "vertex_indices", true, true);
    if (!corners || !has_vertices) {
      places_.fail_at(element.place,
                      corners ? "found the element 'tristrips', expected 'vertex' before it"
                              : "found an element 'tristrips' without a list of integers "
                                "'vertex_indices', expected one");
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers_.begin_element();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        k == *corners ? read_strip(element.properties[k]) : skip_property(element.properties[k]);
      }
      numbers_.end_element();
    }
    if (!mesh_.labels.empty()) {
      mesh_.labels.resize(mesh_.triangles.size(), labels_.label(kStripsLabel));
    }
  }

  void read_strip(const formats::PlyProperty& property) {
    const std::int64_t size =
        numbers_.integer(property.count_type, 0, kMostPoints, "the length of a strip, an integer");
    corners_.clear();
    for (std::int64_t i = 0; i < size; ++i) {
      const std::int64_t corner =
          numbers_.integer(property.type, -1, static_cast<std::int64_t>(mesh_.points.size()) - 1,
                           "the index of a vertex or -1, an integer");
      if (corner < 0) {
        corners_.clear();
        continue;
      }
      corners_.push_back(static_cast<std::uint32_t>(corner));
      if (corners_.size() < 3) {
        continue;
      }
      const std::size_t last = corners_.size() - 1, odd = corners_.size() % 2 == 0 ? 1 : 0;
      const Triangle t = {corners_[last - 2], corners_[last - 1 + odd], corners_[last - odd]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
        mesh_.triangles.push_back(t);
      }
    }
  }

  [[nodiscard]] std::string label_name() const {
    const auto index = static_cast<std::size_t>(label_);
    return index < header_.label_names.size() ? header_.label_names[index]
                                              : "label " + std::to_string(label_);
  }

  const formats::PlyHeader& header_;
  text::TextScanner places_;
  Numbers numbers_;
  TriMesh mesh_;
  text::LabelBuilder labels_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> point_of_;  ///< by vertex, where vertices may be copies
  std::size_t copies_place_ = 0;
  std::int64_t label_ = 0;
};

/// The vertices of a mesh, which are its points if it has no normals.
struct Vertices {
  Vertices(const TriMesh& mesh, const MeshHeader& header)
      : points(text::surface_points(mesh, Coordinates::binary64)), own_points(points.size()) {
    if (header.normals.empty()) {
      return;
    }
    split = formats::split_points(mesh, header.normals);
    for (const std::uint32_t point : split.copied) {
      points.push_back(points[point]);
    }
  }

  [[nodiscard]] bool have_normals() const { return !split.normals.empty(); }
  [[nodiscard]] bool have_copies() const { return !split.copied.empty(); }
  [[nodiscard]] const std::vector<Triangle>& triangles(const TriMesh& mesh) const {
    return have_normals() ? split.triangles : mesh.triangles;
  }
  [[nodiscard]] std::uint32_t point_of(std::size_t vertex) const {
    return vertex < own_points ? std::uint32_t(vertex) : split.copied[vertex - own_points];
  }

  std::vector<Vec3> points;
  std::size_t own_points;
  formats::SplitPoints split;
};

formats::PlyContents contents_of(const TriMesh& mesh, const MeshHeader& header,
                                 const Vertices& vertices) {
  return {.vertices = vertices.points.size(),
          .triangles = mesh.triangles.size(),
          .has_normals = vertices.have_normals(),
          .has_copies = vertices.have_copies(),
          .has_labels = !mesh.labels.empty(),
          .has_colours = !mesh.labels.empty() && !header.colours.empty()};
}

/// Of every label; empty where faces have no colours.
std::vector<text::Colour> face_colours(const TriMesh& mesh, const MeshHeader& header) {
  return mesh.labels.empty() || header.colours.empty()
             ? std::vector<text::Colour>()
             : text::label_colours(mesh.names, header.colours);
}

void append_vertex(std::string& text, const Vertices& vertices, std::size_t vertex) {
  text::append_point(text, vertices.points[vertex]);
  if (vertices.have_normals()) {
    for (const float coordinate : vertices.split.normals[vertex]) {
      text += ' ';
      append_decimal(text, coordinate);
    }
  }
  if (vertices.have_copies()) {
    text += ' ';
    append_decimal(text, vertices.point_of(vertex));
  }
  text += '\n';
}

/// The reader tells the encodings apart.
Evidence recognise(std::string_view bytes) {
  const std::string_view text = bytes.substr(text::byte_order_mark(bytes));
  return text.starts_with("ply\n") || text.starts_with("ply\r") ? Evidence::text_signature
                                                                : Evidence::none;
}

}  // namespace

TriMesh read_ply(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  const formats::PlyHeader header = formats::read_ply_header(bytes, file);
  return header.encoding == formats::PlyEncoding::ascii
             ? PlyReader<formats::PlyTextNumbers>(bytes, file, header).read()
             : PlyReader<formats::PlyByteNumbers>(bytes, file, header).read();
}

std::string ply_ascii_text(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const Vertices vertices(mesh, header);
  const std::vector<text::Colour> colours = face_colours(mesh, header);
  std::string text = formats::ply_header_text(contents_of(mesh, header, vertices), mesh.names,
                                              header, formats::PlyEncoding::ascii);
  text.reserve(text.size() + vertices.points.size() * (vertices.have_normals() ? 110 : 60) +
               mesh.triangles.size() * 32);
  text::append_each(text, vertices.points.size(),
                    [&](std::string& end, std::size_t i) { append_vertex(end, vertices, i); });
  text::append_each(text, mesh.triangles.size(), [&](std::string& end, std::size_t i) {
    end += '3';
    for (const std::uint32_t corner : vertices.triangles(mesh)[i]) {
      end += ' ';
      append_decimal(end, corner);
    }
    if (!mesh.labels.empty()) {
      end += ' ';
      append_decimal(end, mesh.labels[i]);
    }
    if (!colours.empty()) {
      for (const std::uint8_t channel : colours[mesh.labels[i]]) {
        end += ' ';
        append_decimal(end, std::uint32_t{channel});
      }
    }
    end += '\n';
  });
  return text;
}

std::string ply_binary_bytes(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const Vertices vertices(mesh, header);
  const std::vector<text::Colour> colours = face_colours(mesh, header);
  std::string bytes = formats::ply_header_text(contents_of(mesh, header, vertices), mesh.names,
                                               header, formats::PlyEncoding::little_endian);
  bytes.reserve(bytes.size() + vertices.points.size() * (vertices.have_normals() ? 40 : 24) +
                mesh.triangles.size() * 17);
  text::append_each(bytes, vertices.points.size(), [&](std::string& end, std::size_t i) {
    const std::uint32_t number = vertices.point_of(i);
    formats::store_ply_vertex(end, vertices.points[i],
                              vertices.have_normals() ? &vertices.split.normals[i] : nullptr,
                              vertices.have_copies() ? &number : nullptr);
  });
  text::append_each(bytes, mesh.triangles.size(), [&](std::string& end, std::size_t i) {
    formats::store_ply_face(end, vertices.triangles(mesh)[i],
                            mesh.labels.empty() ? nullptr : &mesh.labels[i],
                            colours.empty() ? nullptr : &colours[mesh.labels[i]]);
  });
  return bytes;
}

namespace {

std::string unit_of(std::string_view bytes, std::string_view /*file*/) {
  return text::noted_unit(bytes, "comment ");
}

}  // namespace

constinit const MeshFormat kPlyAscii = {.key = "ply-ascii",
                                        .name = "ASCII PLY",
                                        .extension = {},
                                        .coordinates = Coordinates::binary64,
                                        .has_normals = true,
                                        .read = read_ply,
                                        .write = ply_ascii_text,
                                        .recognises = recognise,
                                        .unit = unit_of};

constinit const MeshFormat kPlyBinary = {.key = "ply",
                                         .name = "binary PLY",
                                         .extension = ".ply",
                                         .coordinates = Coordinates::binary64,
                                         .has_normals = true,
                                         .read = read_ply,
                                         .write = ply_binary_bytes,
                                         .recognises = recognise,
                                         .unit = unit_of};

}  // namespace dupin
