#include "dupin/blends/assembly.h"

namespace dupin {

std::string to_string(const PortReference& port) {
  return port.part + "." + std::string(name(port.end));
}

std::string_view kind(const PartShape& shape) {
  struct Kind {
    std::string_view operator()(const PipeBetween&) const { return "pipe"; }
    std::string_view operator()(const PipeAlong&) const { return "pipe"; }
    std::string_view operator()(const PipeTo&) const { return "pipe"; }
    std::string_view operator()(const ConeBetween&) const { return "cone"; }
    std::string_view operator()(const ConeAlong&) const { return "cone"; }
    std::string_view operator()(const ObliqueBetween&) const { return "oblique"; }
    std::string_view operator()(const ElbowTurning&) const { return "elbow"; }
    std::string_view operator()(const ElbowTo&) const { return "elbow"; }
    std::string_view operator()(const ElbowCorner&) const { return "elbow"; }
    std::string_view operator()(const SphereAt&) const { return "sphere"; }
    std::string_view operator()(const SplineBetween&) const { return "spline"; }
    std::string_view operator()(const SplineRound&) const { return "spline"; }
    std::string_view operator()(const CyclicBlendBetween&) const { return "cyclic_blend"; }
    std::string_view operator()(const CyclideBlendBetween&) const { return "cyclide_blend"; }
    std::string_view operator()(const CyclideChainThrough&) const { return "cyclide_chain"; }
    std::string_view operator()(const TwoConeBlendBetween&) const { return "two_cone_blend"; }
    std::string_view operator()(const RingedBlendBetween&) const { return "ringed_blend"; }
    std::string_view operator()(const CapAt&) const { return "cap"; }
  };
  return std::visit(Kind(), shape);
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
