#include "formats/vtk_arrays.h"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>

#include "dupin/kernel/error.h"
#include "text/base64.h"
#include "text/label_colour.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin::formats {
namespace {

// The place is added where the XML is read.
[[noreturn]] void fail(const std::string& message) { throw Error(Errc::parse_failed, message); }

constexpr std::string_view kBlanks = " \t\r\n";

/// Calls visit(token) for what stands between blanks.
template <class Visit>
void for_each_token(std::string_view text, const Visit& visit) {
  for (std::size_t begin = 0;
       (begin = text.find_first_not_of(kBlanks)) != std::string_view::npos;) {
    text.remove_prefix(begin);
    const std::string_view token = text.substr(0, text.find_first_of(kBlanks));
    visit(token);
    text.remove_prefix(token.size());
  }
}

/// Of a decimal that is no double: whether it is as good as 0.
bool is_tiny(std::string_view decimal) {
  const std::size_t exponent = decimal.find_first_of("eE");
  const std::string_view digits = decimal.substr(0, exponent);
  const bool has_small_exponent =
      exponent != std::string_view::npos && decimal.substr(exponent + 1).starts_with('-');
  const std::string_view whole = digits.substr(0, digits.find('.'));
  return exponent == std::string_view::npos
             ? whole.find_first_of("123456789") == std::string_view::npos
             : has_small_exponent;
}

/// As programs print numbers: with a plus, as 1e-400, whole ones as 1.0.
template <class Number>
std::optional<Number> number_of(std::string_view token) {
  if (token.size() > 1 && token.front() == '+' && token[1] != '-') {
    token.remove_prefix(1);
  }
  const char* const end = token.data() + token.size();
  if constexpr (std::is_integral_v<Number>) {
    Number number{};
    const auto [stop, error] = std::from_chars(token.data(), end, number);
    if (error == std::errc() && stop == end) {
      return number;
    }
    constexpr double kLargest = 0x1p53;
    const std::optional<double> value = number_of<double>(token);
    return value && std::abs(*value) <= kLargest && *value == std::floor(*value)
               ? std::optional(static_cast<Number>(*value))
               : std::nullopt;
  } else {
    Number number{};
    const auto [stop, error] = std::from_chars(token.data(), end, number);
    if (stop != end || (error == std::errc::result_out_of_range && !is_tiny(token))) {
      return std::nullopt;
    }
    return error == std::errc::invalid_argument ? std::nullopt : std::optional(number);
  }
}

template <class Number>
std::vector<Number> from_text(const VtkArray& array) {
  std::vector<Number> numbers;
  for_each_token(array.text, [&](std::string_view token) {
    const std::optional<Number> number = number_of<Number>(token);
    if (!number) {
      fail("found " + text::quoted(token) + " in the array " + text::quoted(array.name) +
           ", expected a number");
    }
    numbers.push_back(*number);
  });
  return numbers;
}

template <class Number, class Stored>
std::vector<Number> converted(std::string_view bytes, const VtkArray& array) {
  if (bytes.size() % sizeof(Stored) != 0) {
    fail("found " + std::to_string(bytes.size()) + " bytes in the array " +
         text::quoted(array.name) + ", expected a multiple of " + std::to_string(sizeof(Stored)));
  }
  std::vector<Number> numbers(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto stored = text::load<Stored>(bytes, i * sizeof(Stored));
    if constexpr (std::is_integral_v<Number> && std::is_floating_point_v<Stored>) {
      fail("found the type " + array.type + " of the array " + text::quoted(array.name) +
           ", expected integers");
    } else {
      // NOLINTNEXTLINE(bugprone-signed-char-misuse): of Int8, numbers and not characters
      numbers[i] = static_cast<Number>(stored);
    }
  }
  return numbers;
}

// The size of what follows, then that; both in one text of base64.
std::string decoded(const VtkArray& array, const VtkEncoding& encoding) {
  std::string text = array.text;
  std::erase_if(text, [](char c) { return kBlanks.find(c) != std::string_view::npos; });
  auto bytes = text::from_base64(text);
  if (!bytes || bytes->size() < encoding.header_size) {
    fail("found no base64 in the array " + text::quoted(array.name) +
         ", expected a size and its bytes");
  }
  const std::uint64_t size = encoding.header_size == 8 ? text::load<std::uint64_t>(*bytes, 0)
                                                       : text::load<std::uint32_t>(*bytes, 0);
  if (size != bytes->size() - encoding.header_size) {
    fail("found " + std::to_string(bytes->size() - encoding.header_size) + " bytes in the array " +
         text::quoted(array.name) + ", expected the " + std::to_string(size) + " that it says");
  }
  bytes->erase(0, encoding.header_size);
  return std::move(*bytes);
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

}  // namespace

bool VtkArray::is_of_integers() const {
  return (type.starts_with("Int") || type.starts_with("UInt")) && components == "1";
}

template <class Number>
std::vector<Number> vtk_numbers(const VtkArray& array, const VtkEncoding& encoding) {
  if (array.format == "ascii") {
    return from_text<Number>(array);
  }
  if (array.format != "binary" || encoding.is_compressed) {
    fail("found the array " + text::quoted(array.name) +
         (array.format == "binary" ? std::string(" compressed")
                                   : " in the format " + text::quoted(array.format)) +
         ", expected it inside of its element and not compressed: save with the data mode ascii "
         "or binary, without a compressor");
  }
  if (!encoding.is_little_endian) {
    fail("found another order of bytes in the array " + text::quoted(array.name) +
         ", expected LittleEndian, or the data mode ascii");
  }
  const std::string bytes = decoded(array, encoding);
  const std::pair<std::string_view, std::vector<Number> (*)(std::string_view, const VtkArray&)>
      types[] = {
          {"Float32", converted<Number, float>},      {"Float64", converted<Number, double>},
          {"Int8", converted<Number, std::int8_t>},   {"UInt8", converted<Number, std::uint8_t>},
          {"Int16", converted<Number, std::int16_t>}, {"UInt16", converted<Number, std::uint16_t>},
          {"Int32", converted<Number, std::int32_t>}, {"UInt32", converted<Number, std::uint32_t>},
          {"Int64", converted<Number, std::int64_t>}, {"UInt64", converted<Number, std::uint64_t>},
          {"String", converted<Number, std::uint8_t>}};  // of their bytes
  for (const auto& [type, convert] : types) {
    if (type == array.type) {
      return convert(bytes, array);
    }
  }
  fail("found the type " + text::quoted(array.type) + " of the array " + text::quoted(array.name) +
       ", expected a number's, such as Float64");
}

template std::vector<double> vtk_numbers<double>(const VtkArray&, const VtkEncoding&);
template std::vector<std::int64_t> vtk_numbers<std::int64_t>(const VtkArray&, const VtkEncoding&);

template <class Number>
void append_vtk_array(std::string& text, std::string_view attributes, const std::string& bytes) {
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

template void append_vtk_array<double>(std::string&, std::string_view, const std::string&);
template void append_vtk_array<std::int32_t>(std::string&, std::string_view, const std::string&);
template void append_vtk_array<std::uint8_t>(std::string&, std::string_view, const std::string&);

VtkParts::VtkParts(const std::vector<std::string>& labels) {
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

void append_vtk_field_data(std::string& text, const TriMesh& mesh, const MeshHeader& header,
                           const VtkParts& parts) {
  text += "<FieldData>\n";
  if (!mesh.labels.empty()) {
    append_strings(text, "label_names", text::written_names(mesh.names));
    append_strings(text, "part_names", text::written_names(parts.names));
  }
  if (!header.unit.empty()) {
    append_strings(text, "unit", {header.unit});
  }
  if (!header.note.empty()) {
    append_strings(text, "note", {header.note});
  }
  text += "</FieldData>\n";
}

void append_vtk_cell_data(std::string& text, const TriMesh& mesh, const MeshHeader& header,
                          const VtkParts& parts, std::size_t others) {
  const std::vector<text::Colour> of_label = text::label_colours(mesh.names, header.colours);
  std::string labels, of_parts, colours;
  for (const std::uint32_t label : mesh.labels) {
    text::store(labels, label);
    text::store(of_parts, parts.of_label[label]);
    text::store(colours, of_label[label]);
  }
  for (std::size_t i = 0; i < others; ++i) {
    text::store(labels, std::int32_t{-1});
    text::store(of_parts, std::int32_t{-1});
    text::store(colours, text::Colour{255, 255, 255});
  }
  text += "<CellData Scalars=\"label\">\n";
  append_vtk_array<std::int32_t>(text, "Name=\"label\"", labels);
  append_vtk_array<std::int32_t>(text, "Name=\"part\"", of_parts);
  if (!header.colours.empty()) {
    append_vtk_array<std::uint8_t>(text, "Name=\"colour\" NumberOfComponents=\"3\"", colours);
  }
  text += "</CellData>\n";
}

}  // namespace dupin::formats
