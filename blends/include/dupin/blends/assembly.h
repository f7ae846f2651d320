#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/part_shape.h"
#include "dupin/blends/unit.h"

namespace dupin {

struct Part {
  std::string name;
  PartShape shape;
  /// Thickness inwards; 0: the part has no bore, but those of others pass through it; none: the
  /// assembly's. Only `build` hollows parts.
  std::optional<double> wall = {};
  bool solid = false;  ///< without a bore, and those of others end at it
  /// Where the document says it, if not at /parts/INDEX: several parts may come from one place.
  std::string pointer = {};
};

/// A document: what the user says, before anything is computed.
struct Assembly {
  std::string source;  ///< the file's name, for messages; may be empty
  Unit unit = Unit::millimetre;
  double tolerance = 0.05;  ///< largest distance between the smooth surface and its mesh
  std::optional<std::uint32_t> segments;  ///< around every ring; none: from the tolerance
  std::vector<Part> parts;
  std::optional<double> wall = {};  ///< of every part that says none; none: parts are solid
};

/// What was done to something in a file, be it a graph or a piping line, that could not stay as it
/// was.
struct SourceNote {
  std::size_t line = 0;  ///< of it; 0 if there is none
  std::string text;      ///< "node 7: ..."
  bool is_refusal = false;
};

/// A place in the document, for messages: "file.json#/tolerance", or the pointer alone if the
/// document has no name.
[[nodiscard]] std::string document_place(const Assembly& assembly, std::string_view pointer);

/// The place of a part, or of a key of it: "file.json#/parts/3/pipe/radius".
[[nodiscard]] std::string document_place(const Assembly& assembly, std::uint32_t part,
                                         std::string_view key = {});

}  // namespace dupin
