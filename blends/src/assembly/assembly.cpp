#include "dupin/blends/assembly.h"

namespace dupin {

std::string_view name(PartEnd end) { return end == PartEnd::start ? "start" : "end"; }

std::string to_string(const PortReference& port) {
  return port.part + "." + std::string(name(port.end));
}

std::string document_place(const Assembly& assembly, std::uint32_t part, std::string_view key) {
  std::string place = document_place(assembly, "/parts/" + std::to_string(part));
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
