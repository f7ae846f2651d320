#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/ring.h"
#include "surfaces/fillet_mesh.h"

namespace dupin::assembly {

/// Two fillets, or copes, that a part has not room for.
struct FilletOverlap {
  std::size_t fillet = 0;  ///< the later one of them, in ResolvedAssembly::fillets
  std::string why;         ///< names the other one, and the largest radius that would do beside it
};

/// The first two of those on a part whose feet cross there, if two do; for a part whose face could
/// not be trimmed. `meshes` are those of all fillets, by fillet, and `samplings` those of their
/// pipes. The radius is to two digits, and proved by trimming both pipes with it.
[[nodiscard]] std::optional<FilletOverlap> fillet_overlap(
    const Assembly& assembly, const ResolvedAssembly& resolved, std::uint32_t part,
    const std::map<std::uint32_t, RingSampling>& samplings,
    const std::vector<std::vector<surfaces::FilletMesh>>& meshes);

/// Why the part's face could not be trimmed, as an Error{infeasible_blend} that names the fillet
/// and its place: the later one of two that overlap, or with what `error` says the first one on it.
[[nodiscard]] Error trim_refusal(const Assembly& assembly, const ResolvedAssembly& resolved,
                                 std::uint32_t part,
                                 const std::map<std::uint32_t, RingSampling>& samplings,
                                 const std::vector<std::vector<surfaces::FilletMesh>>& meshes,
                                 const Error& error);

}  // namespace dupin::assembly
