#pragma once

#include <cstddef>
#include <cstdint>

namespace dupin::test {

/// Choices made by the bytes of a fuzzer's input, and by zeros after its end.
class FuzzBytes {
 public:
  FuzzBytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  [[nodiscard]] bool is_empty() const { return left_ == 0; }
  /// For bounds up to 256.
  std::uint32_t below(std::uint32_t bound) {
    if (left_ == 0) {
      return 0;
    }
    --left_;
    return *data_++ % bound;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace dupin::test
