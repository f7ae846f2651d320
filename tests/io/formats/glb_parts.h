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

}  // namespace dupin::test
