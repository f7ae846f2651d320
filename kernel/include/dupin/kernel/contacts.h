#pragma once

#include <vector>

#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// A solid that does not touch itself, and where the one it was made from did.
struct Settled {
  Solid solid;
  std::vector<Contact> contacts;
};

/// Takes away the material around each contact, all of it within `distance` of the contact: what
/// touched there is apart. In the sources, the given solid is operand 0; labels of new faces are
/// "contact". A solid without contacts comes back as it is.
///
/// Throws Error{invalid_argument} if `distance` is not positive and finite, Error{contact} where
/// the solid would still touch itself, as it does within less than 2^-32 of the largest coordinate,
/// and what subtract() throws.
[[nodiscard]] Settled separate(const Solid& solid, double distance, const Progress& progress = {});

/// Adds material around each contact, all of it within `radius` of the contact: what touched there
/// is one. Otherwise like separate().
[[nodiscard]] Settled bridge(const Solid& solid, double radius, const Progress& progress = {});

}  // namespace dupin
