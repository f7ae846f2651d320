#pragma once

#include <set>
#include <string>
#include <utility>

#include "dupin/blends/resolve.h"

namespace dupin::drawing {

/// Two names, the lesser one first.
using NamePair = std::pair<std::string, std::string>;

[[nodiscard]] NamePair name_pair(const std::string& a, const std::string& b);

/// The pairs of parts, fillets and hubs that meet tangentially: all around the ring that they share
/// their normals differ by no more than `angle`, in radians. Fillets do on both parts, and a
/// junction's arms on its hub.
[[nodiscard]] std::set<NamePair> smooth_joints(const ResolvedAssembly& assembly, double angle);

}  // namespace dupin::drawing
