#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "dupin/kernel/crease.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh.h"
#include "formats/ply_header.h"
#include "text/label_colour.h"
#include "text/little_endian.h"
#include "text/text_scanner.h"

namespace dupin::formats {

/// The numbers of a PLY body that is text: one element per line.
class PlyTextNumbers {
 public:
  PlyTextNumbers(std::string_view bytes, std::string_view file, const PlyHeader& header)
      : scanner_(bytes, file) {
    scanner_.move_to(header.size);
  }

  void begin_element() { scanner_.skip_space(); }
  void end_element() { scanner_.end_line("the end of the element's line"); }
  double number(PlyType, std::string_view what) { return scanner_.number(what); }
  std::int64_t integer(PlyType, std::int64_t lowest, std::int64_t highest, std::string_view what) {
    return scanner_.integer(lowest, highest, what);
  }
  /// Normals and colours may be anything.
  void skip(PlyType) {
    if (scanner_.at_line_end()) {
      scanner_.fail("a number");
    }
    (void)scanner_.token();
  }
  void end() {
    if (!scanner_.at_end()) {
      scanner_.fail("the end of the file behind the last element");
    }
  }
  [[nodiscard]] std::size_t remaining() const { return scanner_.remaining() + 1; }
  [[nodiscard]] std::size_t position() const { return scanner_.position(); }
  [[nodiscard]] std::string place(std::size_t position) const { return scanner_.place(position); }
  [[nodiscard]] const text::TextScanner& scanner() const { return scanner_; }

 private:
  text::TextScanner scanner_;
};

/// The numbers of a PLY body in bytes of either order.
class PlyByteNumbers {
 public:
  PlyByteNumbers(std::string_view bytes, std::string_view file, const PlyHeader& header)
      : bytes_(bytes),
        file_(file),
        position_(header.size),
        swap_(header.encoding == PlyEncoding::big_endian) {}

  void begin_element() {}
  void end_element() {}

  double number(PlyType type, std::string_view what) {
    const std::size_t place = position_;
    const auto value = take<double>(type);
    if (!std::isfinite(value)) {
      fail(place, "found " + std::to_string(value) + ", expected " + std::string(what) +
                      " that is finite");
    }
    return value + 0.0;  // -0 becomes 0
  }
  std::int64_t integer(PlyType type, std::int64_t lowest, std::int64_t highest,
                       std::string_view what) {
    const std::size_t place = position_;
    const auto value = take<std::int64_t>(type);
    if (value < lowest || value > highest) {
      fail(place, "found " + std::to_string(value) + ", expected " + std::string(what) + " from " +
                      std::to_string(lowest) + " to " + std::to_string(highest));
    }
    return value;
  }
  /// Whether a list has the form that most files have, a byte 3 and three integers of 4 bytes,
  /// which are indices of points.
  [[nodiscard]] bool at_triangle(const PlyProperty& list, std::size_t points) const {
    if (swap_ || list.count_type != PlyType::uint8 || !is_4_byte_integer(list.type) ||
        remaining() < 1 + sizeof(Triangle) || bytes_[position_] != 3) {
      return false;
    }
    const std::size_t end = list.type == PlyType::int32 ? std::min(points, kPastInt32) : points;
    return corner(0) < end && corner(1) < end && corner(2) < end;
  }
  /// Takes that list.
  Triangle take_triangle() {
    const Triangle triangle = {corner(0), corner(1), corner(2)};
    position_ += 1 + sizeof(Triangle);
    return triangle;
  }
  void skip(PlyType type) { (void)take<double>(type); }
  void end() const {
    if (position_ != bytes_.size()) {
      fail(position_, "found " + std::to_string(remaining()) +
                          " more bytes, expected the end of the file behind the last element");
    }
  }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::string place(std::size_t position) const {
    return std::string(file_) + ":byte " + std::to_string(position);
  }

 private:
  static constexpr std::size_t kPastInt32 = std::size_t{1} << 31;

  [[nodiscard]] std::uint32_t corner(std::size_t i) const {
    return text::load<std::uint32_t>(bytes_, position_ + 1 + 4 * i);
  }

  [[noreturn]] void fail(std::size_t place, const std::string& message) const {
    throw Error(Errc::parse_failed, message, {}, this->place(place));
  }

  /// The next number, of the type `Stored`.
  template <typename Number, typename Stored>
  Number take_stored() {
    if (remaining() < sizeof(Stored)) {
      fail(position_, "found the end of the file, expected a number of " +
                          std::to_string(sizeof(Stored)) + " bytes");
    }
    auto raw = text::load<std::array<char, sizeof(Stored)>>(bytes_, position_);
    if (swap_) {
      std::reverse(raw.begin(), raw.end());
    }
    position_ += sizeof(Stored);
    return static_cast<Number>(std::bit_cast<Stored>(raw));
  }

  template <typename Number>
  Number take(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take_stored<Number, std::int8_t>();
      case PlyType::uint8:
        return take_stored<Number, std::uint8_t>();
      case PlyType::int16:
        return take_stored<Number, std::int16_t>();
      case PlyType::uint16:
        return take_stored<Number, std::uint16_t>();
      case PlyType::int32:
        return take_stored<Number, std::int32_t>();
      case PlyType::uint32:
        return take_stored<Number, std::uint32_t>();
      case PlyType::float32:
        return take_stored<Number, float>();
      case PlyType::float64:
        return take_stored<Number, double>();
    }
    return 0;
  }

  std::string_view bytes_;
  std::string_view file_;
  std::size_t position_;
  bool swap_;
};

/// A vertex of a binary file of ours: with a normal, and the number of its point, where files have
/// these.
inline void store_ply_vertex(std::string& bytes, const Vec3& point, const Direction* normal,
                             const std::uint32_t* number) {
  text::store(bytes, point.x());
  text::store(bytes, point.y());
  text::store(bytes, point.z());
  if (normal != nullptr) {
    text::store(bytes, *normal);
  }
  if (number != nullptr) {
    text::store(bytes, *number);
  }
}

/// A face likewise.
inline void store_ply_face(std::string& bytes, const Triangle& corners, const std::uint32_t* label,
                           const text::Colour* colour) {
  text::store(bytes, std::uint8_t{3});
  text::store(bytes, corners);
  if (label != nullptr) {
    text::store(bytes, *label);
  }
  if (colour != nullptr) {
    text::store(bytes, *colour);
  }
}

}  // namespace dupin::formats
