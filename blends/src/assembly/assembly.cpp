#include "dupin/blends/assembly.h"

#include <array>

namespace dupin {

std::string to_string(const PortReference& port) {
  return port.part + "." + std::string(name(port.end));
}

std::string_view name(WallSide side) {
  constexpr std::array<std::string_view, 3> kNames{"inwards", "outwards", "centred"};
  return kNames.at(std::size_t(side));
}

std::string document_place(const Assembly& assembly, std::uint32_t part, std::string_view key) {
  const bool has_own = part < assembly.parts.size() && !assembly.parts[part].pointer.empty();
  std::string place = document_place(
      assembly, has_own ? assembly.parts[part].pointer : "/parts/" + std::to_string(part));
  if (!key.empty() && !assembly.is_of_network && part < assembly.parts.size()) {
    const Part& own = assembly.parts[part];
    place +=
        "/" + (own.key.empty() ? std::string(kind(own.shape)) : own.key) + "/" + std::string(key);
  }
  return place;
}

std::string document_place(const Assembly& assembly, std::string_view pointer) {
  return assembly.source.empty()  ? std::string(pointer)
         : assembly.is_of_network ? assembly.source
                                  : assembly.source + "#" + std::string(pointer);
}

}  // namespace dupin
