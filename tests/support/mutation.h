#pragma once

#include <cstddef>
#include <random>
#include <string>

namespace dupin::test {

/// `bytes` with one to four random faults: a byte changed, removed, inserted or copied from
/// elsewhere, or the end cut off.
inline std::string mutated(std::string bytes, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) { return random() % bound; };
  const std::size_t faults = 1 + below(4);
  for (std::size_t i = 0; i < faults && !bytes.empty(); ++i) {
    const std::size_t place = below(bytes.size());
    switch (below(8)) {
      case 0:
        bytes.erase(place, 1 + below(4));
        break;
      case 1:
        bytes.insert(place, 1 + below(3), static_cast<char>(below(256)));
        break;
      case 2:
        bytes[place] = bytes[below(bytes.size())];
        break;
      case 3:
        bytes.insert(place, bytes.substr(below(bytes.size()), below(24)));
        break;
      case 4:
        bytes.resize(below(8) == 0 ? place : bytes.size());
        break;
      case 5:
        bytes[place] =
            static_cast<char>(static_cast<unsigned char>(bytes[place]) ^ (1U << below(8)));
        break;
      case 6:
        bytes[place] = "0123456789-+.eE \n\r#"[below(19)];
        break;
      default:
        bytes[place] = static_cast<char>(below(256));
    }
  }
  return bytes;
}

}  // namespace dupin::test
