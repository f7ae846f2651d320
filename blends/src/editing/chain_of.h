#pragma once

#include <string>
#include <variant>

#include "dupin/blends/assembly.h"
#include "dupin/kernel/error.h"

namespace dupin::editing {

/// The chain that a part is. Throws Error{invalid_argument} for a number of no part and for other
/// parts.
[[nodiscard]] inline const CyclideChainThrough& chain_of(const Assembly& assembly,
                                                         std::uint32_t part) {
  if (part >= assembly.parts.size()) {
    throw Error(Errc::invalid_argument,
                "there is no part " + std::to_string(part) + "; the document has " +
                    std::to_string(assembly.parts.size()),
                {}, assembly.source);
  }
  const auto* chain = std::get_if<CyclideChainThrough>(&assembly.parts[part].shape);
  if (chain == nullptr) {
    throw Error(
        Errc::invalid_argument,
        "the part is no cyclide_chain; other parts have no spheres to move or to turn about",
        assembly.parts[part].name, document_place(assembly, part));
  }
  return *chain;
}

}  // namespace dupin::editing
