#include "dupin/io/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "dupin/kernel/parallel.h"
#include "formats/split_points.h"
#include "text/append_each.h"
#include "text/byte_order_mark.h"
#include "text/mesh_text.h"
#include "text/polygon.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

// Statements that say nothing about the polygons.
constexpr std::array<std::string_view, 18> kSkipped = {
    "vt",     "vn",     "vp",    "s",        "l",        "p",   "mg",         "mtllib",    "usemtl",
    "maplib", "usemap", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "call"};

/// One corner of a face, "7", "7/1", "7//3", "7/1/3" or with negative numbers, as an index into the
/// points before it. Leaves a backslash right behind it, which continues the line.
std::uint32_t read_corner(text::TextScanner& scanner, std::size_t points) {
  std::string_view token = scanner.peek();
  token.remove_suffix(token.size() > 1 && token.ends_with('\\') ? 1 : 0);
  const std::string_view digits = token.substr(0, token.find('/'));
  const auto count = static_cast<std::int64_t>(points);
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument ||
      token.find_first_not_of("0123456789-/") != std::string_view::npos) {
    scanner.fail("a vertex of a face, such as 7, 7/1, 7//3 or -1");
  }
  if (error != std::errc() || index == 0 || index > count || index < -count) {
    scanner.fail("the index of one of the " + std::to_string(count) + " vertices before it");
  }
  scanner.move_to(scanner.position() + token.size());
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

/// The corners up to the line's end; a backslash continues the line.
void read_corners(text::TextScanner& scanner, std::size_t points,
                  std::vector<std::uint32_t>& corners) {
  corners.clear();
  while (!scanner.at_line_end()) {
    if (scanner.take("\\")) {
      scanner.end_line("the end of the line behind a backslash");
    } else {
      corners.push_back(read_corner(scanner, points));
    }
  }
  if (corners.size() < 3) {
    scanner.fail("a face of at least 3 vertices");
  }
}

/// Appends the face that comes next, if it is one, cut into triangles. `corners` is room for those
/// of one face.
bool read_face(text::TextScanner& scanner, std::vector<std::uint32_t>& corners, TriMesh& mesh) {
  if (scanner.take_triangle('f', 1, mesh.points.size(), mesh.triangles)) {
    return true;
  }
  const std::size_t place = scanner.position();
  if (!scanner.take("f")) {
    return false;
  }
  read_corners(scanner, mesh.points.size(), corners);
  text::triangulate(corners, mesh.points, mesh.triangles, [&] { return scanner.place(place); });
  return true;
}

/// Moves on where a backslash continues the line.
void continue_line(text::TextScanner& scanner) {
  while (scanner.take("\\")) {
    scanner.end_line("the end of the line behind a backslash");
  }
}

/// A backslash may continue its line anywhere, if the file has any.
void read_vertex(text::TextScanner& scanner, bool has_long_lines, TriMesh& mesh) {
  Vec3 point;
  for (double& coordinate : point) {
    if (has_long_lines) {
      continue_line(scanner);
    }
    coordinate = scanner.number("a coordinate");
  }
  mesh.points.push_back(point);
  // A weight, or a colour of three or four components.
  for (int extra = 0;; ++extra) {
    if (has_long_lines) {
      continue_line(scanner);
    }
    if (extra == 4 || scanner.at_line_end()) {
      break;
    }
    scanner.skip_number("a weight or a colour's component");
  }
  scanner.end_line("the end of the line behind a vertex");
}

/// The rest of the line, and of those that continue it.
std::string rest_of_long_line(text::TextScanner& scanner) {
  std::string line(scanner.rest_of_line());
  while (line.ends_with('\\')) {
    line.back() = ' ';
    line += scanner.rest_of_line();
  }
  return line;
}

void skip_statement(text::TextScanner& scanner) {
  const std::string_view keyword = scanner.peek();
  if (std::find(kSkipped.begin(), kSkipped.end(), keyword) == kSkipped.end()) {
    scanner.fail("an OBJ statement for polygons, such as v, f, g or o");
  }
  (void)rest_of_long_line(scanner);
}

/// Text that begins with one of the statements that such files begin with, or the empty set as we
/// write it.
Evidence recognise(std::string_view bytes) {
  text::TextScanner scanner(bytes, {}, '#');
  scanner.skip_space();
  const bool is_obj =
      scanner.take("v") || scanner.take("o") || scanner.take("g") || scanner.take("mtllib");
  const bool is_our_empty_set =
      bytes.substr(text::byte_order_mark(bytes)).starts_with("# dupin") && scanner.at_end();
  return is_obj || is_our_empty_set ? Evidence::first_word : Evidence::none;
}

}  // namespace

TriMesh read_obj(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  text::TextScanner scanner(bytes, file, '#');
  text::LabelBuilder labels;
  TriMesh mesh;
  std::string group;
  std::optional<std::uint32_t> label;  // of this group, which may be without faces
  bool named = false;
  std::vector<std::uint32_t> corners;
  bool has_statements = false;
  const bool has_long_lines = bytes.find('\\') != std::string_view::npos;
  for (; !scanner.at_end(); has_statements = true) {
    if (scanner.take("v")) {
      read_vertex(scanner, has_long_lines, mesh);
    } else if (read_face(scanner, corners, mesh)) {
      if (!label) {
        label = labels.label(group.empty() ? "default" : group);
      }
      mesh.labels.resize(mesh.triangles.size(), *label);
      named = named || !group.empty();
    } else if (scanner.take("g") || scanner.take("o")) {
      group = text::clean_line(rest_of_long_line(scanner));
      label.reset();
    } else {
      skip_statement(scanner);
    }
  }
  if (mesh.triangles.empty() && !mesh.points.empty()) {
    scanner.fail("a face behind the " + std::to_string(mesh.points.size()) + " vertices");
  }
  if (mesh.triangles.empty() && (has_statements || bytes.find('#') == std::string_view::npos)) {
    scanner.fail("a face; the empty set is written as comments alone");
  }
  if (named) {
    std::move(labels).name_labels(mesh);
  } else {
    mesh.labels.clear();
  }
  return mesh;
}

namespace {

void append_normals(std::string& text, const std::vector<Direction>& normals) {
  text::append_each(text, normals.size(), [&](std::string& end, std::size_t i) {
    const auto& [x, y, z] = normals[i];
    end += "vn ";
    append_decimal(end, x);
    end += ' ';
    append_decimal(end, y);
    end += ' ';
    append_decimal(end, z);
    end += '\n';
  });
}

/// What no reader takes for the beginning of a longer line.
std::string closed_line(std::string_view name) {
  std::string line = text::clean_line(name);
  if (line.ends_with('\\')) {
    line.back() = '/';  // there is no way to write it
  }
  return line;
}

// A vertex of `normals`, if there are any, has the normal of its number.
void append_face(std::string& text, const Triangle& face, const Triangle* normals) {
  text += 'f';
  for (std::size_t k = 0; k < 3; ++k) {
    text += ' ';
    append_decimal(text, face.at(k) + 1);
    if (normals != nullptr) {
      text += "//";
      append_decimal(text, normals->at(k) + 1);
    }
  }
  text += '\n';
}

}  // namespace

std::string obj_text(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary64);
  std::string text = text::header_lines(header, "# ");
  const formats::SplitPoints shaded =
      header.normals.empty() ? formats::SplitPoints() : formats::split_points(mesh, header.normals);
  text.reserve(text.size() + points.size() * 62 + shaded.normals.size() * 40 +
               mesh.triangles.size() * (shaded.normals.empty() ? 26 : 52));
  text::append_each(text, points.size(), [&](std::string& end, std::size_t i) {
    end += "v ";
    text::append_point(end, points[i]);
    end += '\n';
  });
  append_normals(text, shaded.normals);
  const auto groups = text::triangles_by_label(mesh);
  const std::vector<std::string> names = text::written_names(mesh.names, closed_line);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    if (!mesh.labels.empty() && !groups[group].empty()) {
      text += "g " + names[group] + '\n';
    }
    text::append_each(text, groups[group].size(), [&](std::string& end, std::size_t i) {
      const std::uint32_t index = groups[group][i];
      append_face(end, mesh.triangles[index],
                  shaded.normals.empty() ? nullptr : &shaded.triangles[index]);
    });
  }
  return text;
}

constinit const MeshFormat kObj = {.key = "obj",
                                   .name = "OBJ",
                                   .extension = ".obj",
                                   .coordinates = Coordinates::binary64,
                                   .has_normals = true,
                                   .read = read_obj,
                                   .write = obj_text,
                                   .recognises = recognise,
                                   .unit = text::unit_behind_hash};

}  // namespace dupin
