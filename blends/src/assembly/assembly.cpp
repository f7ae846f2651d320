#include "dupin/blends/assembly.h"

namespace dupin {

std::string to_string(const PortReference& port) {
  return port.part + "." + std::string(name(port.end));
}

std::string document_place(const Assembly& assembly, std::uint32_t part, std::string_view key) {
  const bool has_own = part < assembly.parts.size() && !assembly.parts[part].pointer.empty();
  std::string place = document_place(
      assembly, has_own ? assembly.parts[part].pointer : "/parts/" + std::to_string(part));
  if (!key.empty()) {
    place += "/" + std::string(kind(assembly.parts.at(part).shape)) + "/" + std::string(key);
  }
  return place;
}

std::string document_place(const Assembly& assembly, std::string_view pointer) {
  return assembly.source.empty() ? std::string(pointer)
                                 : assembly.source + "#" + std::string(pointer);
}

}  // namespace dupin
