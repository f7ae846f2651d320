#pragma once

#include "dupin/blends/part_surface.h"
#include "json/json_document.h"

namespace dupin::json {

/// A piece of a chain in a certificate: an object with the key of its kind and, below it, its exact
/// numbers.
[[nodiscard]] Json json_value(const Piece& piece);

/// Throws Error{parse_failed} for anything else.
[[nodiscard]] Piece certificate_piece(const JsonNode& node);

// What these are made of.

[[nodiscard]] Json ring_value(const Ring& ring);
[[nodiscard]] Ring certificate_ring(const JsonNode& node);
[[nodiscard]] Json sphere_value(const PeVector& sphere);  ///< [x, y, z, r]
[[nodiscard]] PeVector certificate_sphere(const JsonNode& node);

}  // namespace dupin::json
