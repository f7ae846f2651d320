#include <string>
#include <vector>

#include "assembly/parts/cyclide_part.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {
namespace {

std::vector<std::string> bias_sentences(const CyclideChain& pieces,
                                        const CyclideChainThrough& chain) {
  std::vector<PeVector> spheres = chain.spheres;
  const bool from_port = std::holds_alternative<PortReference>(chain.from);
  if (from_port) {
    spheres.insert(spheres.begin(), pieces.pieces.front().start());
  }
  std::vector<std::string> sentences;
  for (const std::size_t piece : bias_warnings(pieces, spheres)) {
    sentences.push_back("piece " + std::to_string(piece) + " turns away from sphere " +
                        std::to_string(2 * piece + (from_port ? 0 : 1)));
  }
  return sentences;
}

}  // namespace

template <>
struct PartRules<"cyclide_chain"> {
  static References references(const CyclideChainThrough& chain) {
    const auto* port = std::get_if<PortReference>(&chain.from);
    return port == nullptr ? References() : References{{*port, "from"}};
  }

  static std::string_view portless(const CyclideChainThrough& chain) {
    return chain.wall > 0 ? "hollow" : "";
  }

  static PartSurface geometry(const PartContext& context, const CyclideChainThrough& chain) {
    return cyclide_chain(context, chain);
  }

  static PartNotes notes(const CyclideChainThrough& chain, const PartSurface& surface) {
    const std::string pieces = std::to_string(cyclide_pieces(surface).size()) + " pieces";
    if (std::get<Chain>(surface).joints == Joints::spherical) {
      return {pieces + " with kneecaps", {}, {}};
    }
    return {pieces, {}, bias_sentences({cyclide_pieces(surface)}, chain)};
  }
};
template const PartKind& part_kind<"cyclide_chain">();

}  // namespace dupin::assembly
