#include "formats/ply_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "dupin/kernel/error.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin::formats {
namespace {

struct TypeRow {
  std::string_view name;
  std::string_view modern_name;
  std::size_t size;
};

// In the order of PlyType.
constexpr std::array<TypeRow, 8> kTypes = {{{"char", "int8", 1},
                                            {"uchar", "uint8", 1},
                                            {"short", "int16", 2},
                                            {"ushort", "uint16", 2},
                                            {"int", "int32", 4},
                                            {"uint", "uint32", 4},
                                            {"float", "float32", 4},
                                            {"double", "float64", 8}}};

PlyType read_type(text::TextScanner& scanner) {
  const std::string_view token = scanner.peek();
  for (std::size_t i = 0; i < kTypes.size(); ++i) {
    if (token == kTypes[i].name || token == kTypes[i].modern_name) {
      (void)scanner.token();
      return static_cast<PlyType>(i);
    }
  }
  scanner.fail("a type, such as uchar, int, float or double");
}

std::string read_name(text::TextScanner& scanner, std::string_view expected) {
  if (scanner.at_line_end()) {
    scanner.fail(expected);
  }
  return std::string(scanner.token());
}

PlyProperty read_property(text::TextScanner& scanner) {
  PlyProperty property;
  property.is_list = scanner.take("list");
  if (property.is_list) {
    scanner.skip_blanks();
    const std::size_t place = scanner.position();
    property.count_type = read_type(scanner);
    if (!is_integer(property.count_type)) {
      scanner.fail_at(place, "found a list whose length is no integer, expected an integer type");
    }
  }
  property.type = read_type(scanner);
  property.name = read_name(scanner, "the name of a property");
  return property;
}

// Of two of one name, nobody could tell which is meant.
void add_property(PlyElement& element, text::TextScanner& scanner) {
  const std::size_t place = scanner.position();
  PlyProperty property = read_property(scanner);
  if (std::ranges::find(element.properties, property.name, &PlyProperty::name) !=
      element.properties.end()) {
    scanner.fail_at(
        place, "the element '" + element.name + "' has the property '" + property.name + "' twice");
  }
  element.properties.push_back(std::move(property));
}

PlyEncoding read_encoding(text::TextScanner& scanner) {
  PlyEncoding encoding = PlyEncoding::ascii;
  if (!scanner.take("format")) {
    scanner.fail("'format'");
  }
  if (scanner.take("binary_little_endian")) {
    encoding = PlyEncoding::little_endian;
  } else if (scanner.take("binary_big_endian")) {
    encoding = PlyEncoding::big_endian;
  } else if (!scanner.take("ascii")) {
    scanner.fail("ascii, binary_little_endian or binary_big_endian");
  }
  if (!scanner.take("1.0")) {
    scanner.fail("the version 1.0");
  }
  scanner.end_line("the end of the line behind the version");
  return encoding;
}

PlyElement read_element(text::TextScanner& scanner, std::size_t place) {
  PlyElement element;
  element.place = place;
  element.name = read_name(scanner, "the name of an element");
  element.count = static_cast<std::uint64_t>(
      scanner.integer(0, std::numeric_limits<std::uint32_t>::max(), "a count, an integer"));
  return element;
}

}  // namespace

std::size_t size_of(PlyType type) { return kTypes[static_cast<std::size_t>(type)].size; }

std::size_t PlyElement::smallest_size(PlyEncoding encoding) const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties) {
    // As text a number takes at least a digit and a blank.
    size += encoding == PlyEncoding::ascii
                ? 2
                : size_of(property.is_list ? property.count_type : property.type);
  }
  return size;
}

std::string ply_header_text(const PlyContents& contents,
                            const std::vector<std::string>& label_names, const MeshHeader& header,
                            PlyEncoding encoding) {
  if (contents.vertices > std::numeric_limits<std::int32_t>::max()) {
    throw Error(Errc::limit_exceeded, "PLY files hold at most 2147483647 points");
  }
  std::string text = std::string("ply\nformat ") +
                     (encoding == PlyEncoding::ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
  text += text::header_lines(header, "comment ");
  for (const std::string& name : text::written_names(label_names)) {
    text += "comment label " + name + '\n';
  }
  text += "element vertex " + std::to_string(contents.vertices) +
          "\nproperty double x\nproperty double y\nproperty double z\n";
  if (contents.has_normals) {
    text += "property float nx\nproperty float ny\nproperty float nz\n";
  }
  if (contents.has_copies) {
    text += "property int " + std::string(kPlyPointProperty) + '\n';
  }
  text += "element face " + std::to_string(contents.triangles) +
          "\nproperty list uchar int vertex_indices\n";
  if (contents.has_labels) {
    text += "property int label\n";
  }
  if (contents.has_colours) {
    text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  return text + "end_header\n";
}

PlyHeader read_ply_header(std::string_view bytes, std::string_view file) {
  text::TextScanner scanner(bytes, file);
  if (!scanner.take("ply")) {
    scanner.fail("'ply'");
  }
  scanner.end_line("the end of the line behind 'ply'");
  PlyHeader header;
  header.encoding = read_encoding(scanner);
  for (;;) {
    scanner.skip_blanks();
    const std::size_t place = scanner.position();
    if (scanner.take("end_header")) {
      break;
    }
    if (scanner.take("comment") || scanner.take("obj_info")) {
      if (scanner.take("label")) {
        header.label_names.push_back(text::clean_line(scanner.rest_of_line()));
      } else {
        (void)scanner.rest_of_line();
      }
      continue;
    }
    if (scanner.take("element")) {
      header.elements.push_back(read_element(scanner, place));
    } else if (!header.elements.empty() && scanner.take("property")) {
      add_property(header.elements.back(), scanner);
    } else {
      scanner.fail(header.elements.empty() ? "'element', 'comment' or 'end_header'"
                                           : "'element', 'property', 'comment' or 'end_header'");
    }
    scanner.end_line("the end of the line");
  }
  scanner.end_line("the end of the line behind 'end_header'");
  header.size = scanner.position();
  return header;
}

}  // namespace dupin::formats
