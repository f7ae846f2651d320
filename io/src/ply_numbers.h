#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "dupin/kernel/error.h"
#include "little_endian.h"
#include "ply_header.h"
#include "text_scanner.h"

namespace dupin {

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
    return scanner_.integer(lowest, highest, std::string(what) + ", an integer");
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
  [[nodiscard]] const TextScanner& scanner() const { return scanner_; }

 private:
  TextScanner scanner_;
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
    const double value = take(type);
    if (!std::isfinite(value)) {
      fail(place, "found " + std::to_string(value) + ", expected " + std::string(what) +
                      " that is finite");
    }
    return value + 0.0;  // -0 becomes 0
  }
  std::int64_t integer(PlyType type, std::int64_t lowest, std::int64_t highest,
                       std::string_view what) {
    const std::size_t place = position_;
    const auto value = static_cast<std::int64_t>(take(type));
    if (value < lowest || value > highest) {
      fail(place, "found " + std::to_string(value) + ", expected " + std::string(what) +
                      ", an integer from " + std::to_string(lowest) + " to " +
                      std::to_string(highest));
    }
    return value;
  }
  void skip(PlyType type) { (void)take(type); }
  void end() const {
    if (position_ != bytes_.size()) {
      fail(position_, "found " + std::to_string(remaining()) +
                          " more bytes, expected the end of the file behind the last element");
    }
  }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }

 private:
  [[noreturn]] void fail(std::size_t place, const std::string& message) const {
    throw Error(Errc::parse_failed, message, {},
                std::string(file_) + ":byte " + std::to_string(place));
  }

  template <typename Number>
  double take() {
    std::array<char, sizeof(Number)> raw;
    std::copy_n(bytes_.data() + position_, raw.size(), raw.data());
    if (swap_) {
      std::reverse(raw.begin(), raw.end());
    }
    position_ += raw.size();
    return static_cast<double>(load<Number>({raw.data(), raw.size()}, 0));
  }

  double take(PlyType type) {
    if (remaining() < size_of(type)) {
      fail(position_, "found the end of the file, expected a number of " +
                          std::to_string(size_of(type)) + " bytes");
    }
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return take<float>();
      case PlyType::float64:
        return take<double>();
    }
    return 0;
  }

  std::string_view bytes_;
  std::string_view file_;
  std::size_t position_;
  bool swap_;
};

}  // namespace dupin
