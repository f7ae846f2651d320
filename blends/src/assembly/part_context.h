#pragma once

#include <string>

#include "dupin/blends/assembly.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {

/// What `work` returns; an Error that names no part yet gets this part's name and place in the
/// document.
template <typename Work>
auto with_part_context(const Assembly& assembly, std::uint32_t part, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (!error.part().empty() || error.code() == Errc::cancelled) {
      throw;
    }
    const std::string within = error.where().empty() ? "" : ": " + error.where();
    throw Error(error.code(), error.message(), assembly.parts.at(part).name,
                document_place(assembly, part) + within);
  }
}

}  // namespace dupin::assembly
