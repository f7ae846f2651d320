#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

namespace dupin::test {

inline std::uint32_t number_at(const std::string& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, 4);
  return number;
}

/// The JSON chunk of a binary glTF file.
inline nlohmann::json glb_json(const std::string& glb) {
  return nlohmann::json::parse(glb.substr(20, number_at(glb, 12)));
}

/// The same file with another JSON chunk.
inline std::string with_json(const std::string& glb, std::string text) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string rest = glb.substr(20 + number_at(glb, 12));
  std::string bytes = glb.substr(0, 20) + text + rest;
  const auto set = [&](std::size_t place, std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data() + place, &number, 4);
  };
  set(8, bytes.size());
  set(12, text.size());
  return bytes;
}

}  // namespace dupin::test
