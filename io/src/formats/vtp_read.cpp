#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dupin/io/vtp.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "files/xml_events.h"
#include "formats/vtk_arrays.h"
#include "text/known_unit.h"
#include "text/mesh_text.h"
#include "text/polygon.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

// The place is added where the XML is read.
[[noreturn]] void fail(const std::string& message) { throw Error(Errc::parse_failed, message); }

class VtpReader {
 public:
  VtpReader(std::string_view bytes, std::string_view file, bool only_unit)
      : file_(file), only_unit_(only_unit) {
    files::read_xml(bytes, std::string(file),
                    {[this](std::string_view element, const files::XmlAttributes& attributes) {
                       begin(element, attributes);
                       return !(only_unit_ && element == "Piece");
                     },
                     [this](std::string_view element) { end(element); },
                     [this](std::string_view text) {
                       if (array_ && nested_ == 0) {
                         array_->text += text;
                       }
                     }});
    if (!has_data_ && !only_unit_) {
      throw Error(Errc::parse_failed, "found no polygonal data, expected an element PolyData", {},
                  std::string(file_));
    }
  }

  TriMesh mesh() && {
    if (mesh_.triangles.empty() && !mesh_.points.empty()) {
      throw Error(Errc::parse_failed,
                  "found " + std::to_string(mesh_.points.size()) +
                      " points and no polygon, expected polygons",
                  {}, std::string(file_));
    }
    if (has_labels_) {
      for (const std::int64_t label : label_of_triangle_) {
        mesh_.labels.push_back(labels_.label(name_of(label)));
      }
      std::move(labels_).name_labels(mesh_);
    }
    return std::move(mesh_);
  }

  [[nodiscard]] const std::string& unit() const { return unit_; }

 private:
  struct Piece {
    std::size_t points = 0, before = 0, polygons = 0;  ///< before: cells that are no polygons
    std::vector<double> coordinates;
    std::vector<std::int64_t> corners, offsets, labels;
  };

  static constexpr std::int64_t kNone = -1;  ///< the label of what is in a piece without

  [[nodiscard]] std::string name_of(std::int64_t label) const {
    return label == kNone ? "default"
           : label < static_cast<std::int64_t>(names_.size())
               ? names_[static_cast<std::size_t>(label)]
               : "label " + std::to_string(label);
  }

  static std::string text_of(const files::XmlAttributes& attributes, std::string_view name,
                             std::string_view otherwise = {}) {
    return std::string(attributes.find(name).value_or(otherwise));
  }

  static std::size_t count(const files::XmlAttributes& attributes, std::string_view name) {
    const std::string_view text = attributes.find(name).value_or("0");
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      fail("found " + text::quoted(text) + " as " + std::string(name) +
           ", expected an integer from 0 to 4294967295");
    }
    return value;
  }

  void begin(std::string_view element, const files::XmlAttributes& attributes) {
    if (array_) {
      ++nested_;  // what is known of an array besides
    } else if (element == "VTKFile") {
      begin_file(attributes);
    } else if (element == "PolyData") {
      has_data_ = true;
    } else if (element == "Piece") {
      piece_ = Piece{count(attributes, "NumberOfPoints"),
                     count(attributes, "NumberOfVerts") + count(attributes, "NumberOfLines"),
                     count(attributes, "NumberOfPolys")};
      if (count(attributes, "NumberOfStrips") > 0) {
        fail("found triangle strips, expected polygons");
      }
    } else if (element == "DataArray" || element == "Array") {
      array_ = formats::VtkArray{text_of(attributes, "Name"), text_of(attributes, "type"),
                                 text_of(attributes, "format", "ascii"), "",
                                 text_of(attributes, "NumberOfComponents", "1")};
    } else if (element == "AppendedData") {
      fail(
          "found appended data, expected them inside of the elements: save with the data mode "
          "ascii or binary");
    } else {
      section_ = element;
    }
  }

  void begin_file(const files::XmlAttributes& attributes) {
    if (const std::string type = text_of(attributes, "type"); type != "PolyData") {
      fail("found a VTK file of type " + text::quoted(type) + ", expected PolyData, a surface");
    }
    encoding_.is_little_endian =
        text_of(attributes, "byte_order", "LittleEndian") == "LittleEndian";
    encoding_.is_compressed = !text_of(attributes, "compressor").empty();
    encoding_.header_size = text_of(attributes, "header_type", "UInt32") == "UInt64" ? 8 : 4;
  }

  void end(std::string_view element) {
    if (nested_ > 0) {
      --nested_;
    } else if ((element == "DataArray" || element == "Array") && array_) {
      take(*std::exchange(array_, std::nullopt));
    } else if (element == "Piece" && piece_) {
      append(*std::exchange(piece_, std::nullopt));
    }
  }

  void take(const formats::VtkArray& array) {
    if (section_ == "FieldData") {
      take_field(array);
    } else if (!piece_) {
      return;
    } else if (section_ == "Points") {
      piece_->coordinates = formats::vtk_numbers<double>(array, encoding_);
    } else if (section_ == "Polys" && array.name == "connectivity") {
      piece_->corners = formats::vtk_numbers<std::int64_t>(array, encoding_);
    } else if (section_ == "Polys" && array.name == "offsets") {
      piece_->offsets = formats::vtk_numbers<std::int64_t>(array, encoding_);
    } else if (section_ == "CellData" && array.name == "label" && array.is_of_integers()) {
      piece_->labels = formats::vtk_numbers<std::int64_t>(array, encoding_);
    }
  }

  void take_field(const formats::VtkArray& array) {
    if (array.type != "String" || (array.name != "label_names" && array.name != "unit")) {
      return;
    }
    std::vector<std::string> strings(1);
    for (const std::int64_t byte : formats::vtk_numbers<std::int64_t>(array, encoding_)) {
      if (byte < 0 || byte > 255) {
        fail("found " + std::to_string(byte) + " in a text, expected a byte");
      }
      if (byte == 0) {
        strings.emplace_back();
      } else {
        strings.back() += static_cast<char>(byte);
      }
    }
    strings.pop_back();
    for (std::string& string : strings) {
      string = text::clean_line(string);
    }
    if (array.name == "unit") {
      unit_ = !strings.empty() && text::metres_in(strings.front()) ? strings.front() : "";
    } else {
      names_ = std::move(strings);
    }
  }

  void append(const Piece& piece) {
    if (piece.coordinates.size() != 3 * piece.points) {
      fail("found " + std::to_string(piece.coordinates.size()) +
           " coordinates, expected 3 for each of " + std::to_string(piece.points) + " points");
    }
    if (piece.offsets.size() != piece.polygons) {
      fail("found " + std::to_string(piece.offsets.size()) + " offsets, expected one for each of " +
           std::to_string(piece.polygons) + " polygons");
    }
    if (!piece.labels.empty() && piece.labels.size() != piece.before + piece.polygons) {
      fail("found " + std::to_string(piece.labels.size()) + " labels, expected one for each of " +
           std::to_string(piece.before + piece.polygons) + " cells");
    }
    has_labels_ = has_labels_ || !piece.labels.empty();
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::size_t i = 0; i < piece.coordinates.size(); i += 3) {
      const Vec3 point(piece.coordinates[i], piece.coordinates[i + 1], piece.coordinates[i + 2]);
      if (!point.allFinite()) {
        fail("found point " + std::to_string(i / 3) + " not finite, expected finite coordinates");
      }
      mesh_.points.emplace_back(point.array() + 0.0);  // -0 becomes 0
    }
    append_polygons(piece, first);
  }

  void append_polygons(const Piece& piece, std::uint32_t first) {
    std::vector<std::uint32_t> corners;
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < piece.offsets.size(); ++i) {
      const std::int64_t end = piece.offsets[i];
      if (end < begin + 3 || end > static_cast<std::int64_t>(piece.corners.size())) {
        fail("found the offset " + std::to_string(end) + " behind " + std::to_string(begin) +
             ", expected a polygon of 3 corners or more, of " +
             std::to_string(piece.corners.size()));
      }
      corners.clear();
      for (; begin < end; ++begin) {
        const std::int64_t corner = piece.corners[static_cast<std::size_t>(begin)];
        if (corner < 0 || corner >= static_cast<std::int64_t>(piece.points)) {
          fail("found the corner " + std::to_string(corner) + ", expected one of " +
               std::to_string(piece.points) + " points");
        }
        corners.push_back(first + static_cast<std::uint32_t>(corner));
      }
      text::triangulate(corners, mesh_.points, mesh_.triangles, [] { return std::string(); });
      label_of_triangle_.resize(
          mesh_.triangles.size(),
          piece.labels.empty() ? kNone : label(piece.labels[piece.before + i]));
    }
  }

  static std::int64_t label(std::int64_t label) {
    if (label < 0 || label > std::int64_t{0xFFFFFFFF}) {
      fail("found the label " + std::to_string(label) +
           ", expected an integer from 0 to 4294967295");
    }
    return label;
  }

  std::string_view file_;
  bool only_unit_ = false, has_data_ = false, has_labels_ = false;
  std::size_t nested_ = 0;
  formats::VtkEncoding encoding_;
  std::string section_, unit_;
  std::optional<formats::VtkArray> array_;
  std::optional<Piece> piece_;
  std::vector<std::string> names_;
  std::vector<std::int64_t> label_of_triangle_;
  text::LabelBuilder labels_;
  TriMesh mesh_;
};

}  // namespace

TriMesh read_vtp(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  return VtpReader(bytes, file, false).mesh();
}

std::string unit_of_vtp(std::string_view bytes, std::string_view file) {
  return VtpReader(bytes, file, true).unit();
}

}  // namespace dupin
