#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/part_shape.h"
#include "dupin/blends/unit.h"

namespace dupin {

/// Which side of the surface that a document describes its wall is on.
enum class WallSide : std::uint8_t {
  inwards,   ///< radii are outside ones
  outwards,  ///< inside ones
  centred,   ///< in the middle
};

[[nodiscard]] std::string_view name(WallSide side);  ///< as its enumerator

/// What several parts are together: a tee, a component of a piping file.
struct Component {
  std::string name, kind;  ///< none: a part that stands for itself
  std::size_t line = 0;    ///< of a piping file
};

struct Part {
  std::string name;
  PartShape shape;
  /// Thickness of the wall; 0: the part has no bore, but those of others pass through it; none: the
  /// assembly's. Only `build` hollows parts.
  std::optional<double> wall = {};
  bool solid = false;  ///< without a bore, and those of others end at it
  /// Where the document says it, if not at /parts/INDEX: several parts may come from one place.
  std::string pointer = {};
  /// What the document calls it there, if not by the kind of its shape: "tee/branch".
  std::string key = {};
  Component component = {};
  std::optional<WallSide> wall_side = {};  ///< none: the assembly's
  std::optional<double> insulation = {};   ///< thickness on the outside; none: the assembly's
};

/// A document: what the user says, before anything is computed.
struct Assembly {
  std::string source;  ///< the file's name, for messages; may be empty
  Unit unit = Unit::millimetre;
  double tolerance = 0.05;  ///< largest distance between the smooth surface and its mesh
  std::optional<std::uint32_t> segments;  ///< around every ring; none: from the tolerance
  std::vector<Part> parts;
  std::optional<double> wall = {};  ///< of every part that says none; none: parts are solid
  WallSide wall_side = WallSide::inwards;
  std::optional<double> insulation = {};  ///< of every part that says none
  /// Other names for patches, by their own: "inlet" for "run.start".
  std::map<std::string, std::string> patches = {};
  /// Made of a piping file or a graph: places in it are none that anybody wrote, nor are keys.
  bool is_of_network = false;
};

/// What was done to something in a file, be it a graph or a piping line, that could not stay as it
/// was.
struct SourceNote {
  std::size_t line = 0;  ///< of it; 0 if there is none
  std::string text;      ///< "node 7: ..."
  bool is_refusal = false;
};

/// A place in the document, for messages: "file.json#/tolerance", or the pointer alone if the
/// document has no name; the file alone of what was made of a network's.
[[nodiscard]] std::string document_place(const Assembly& assembly, std::string_view pointer);

/// The place of a part, or of a key of it: "file.json#/parts/3/pipe/radius".
[[nodiscard]] std::string document_place(const Assembly& assembly, std::uint32_t part,
                                         std::string_view key = {});

}  // namespace dupin
