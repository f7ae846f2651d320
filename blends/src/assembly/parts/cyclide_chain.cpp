#include "assembly/cyclide_part.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

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
};
template const PartKind& part_kind<"cyclide_chain">();

}  // namespace dupin::assembly
