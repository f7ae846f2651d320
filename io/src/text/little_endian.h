#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace dupin::text {

static_assert(std::endian::native == std::endian::little,
              "binary files are read and written by copying little-endian numbers");

/// The number whose bytes begin at `position`; the caller has checked that they are there.
template <typename Number>
[[nodiscard]] Number load(std::string_view bytes, std::size_t position) {
  Number number;
  std::memcpy(&number, bytes.data() + position, sizeof number);
  return number;
}

template <typename Number>
void store(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

}  // namespace dupin::text
