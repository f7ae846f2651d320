#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "dupin/blends/assembly.h"
#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"

// This folder: a document becomes a solid. resolve.cpp takes parts in the order of their
// references, so that a part finds the rings of its neighbours (below) and keeps them bitwise;
// parts/KEY.cpp says what a key means, as one surface (dupin/blends/part_surface.h). build.cpp is
// the line: margins proved, runs of parts that share rings (welded_runs.h) given one sampling,
// tessellated, welded along the shared polygons, and the runs united. Only a sharing of rings joins
// parts; nothing is welded by distance. What is said of a part in reports comes from here too.

namespace dupin::assembly {

/// One part of an assembly whose neighbours are resolved.
struct PartContext {
  const Assembly& assembly;
  std::uint32_t index = 0;
  /// The ring of another part's port, its normal pointing out of that part.
  std::function<const Ring&(const PortReference&)> ring;
  /// How that ring moves out of that part, at unit speed.
  std::function<MovingRing(const PortReference&)> motion;
  /// The surface of another part, which the shape's kind must say that it needs.
  std::function<const PartSurface&(const std::string&)> surface = {};
};

/// What `work` returns; an Error that names no part yet gets this part's name and place in the
/// document, and so does one that names a piece of it only.
template <typename Work>
auto with_part_context(const Assembly& assembly, std::uint32_t part, const Work& work) {
  try {
    return work();
  } catch (const PieceError& error) {
    throw Error(error.code(), error.part() + ": " + error.message(), assembly.parts.at(part).name,
                document_place(assembly, part));
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
