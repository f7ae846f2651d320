#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "assembly/part_context.h"
#include "dupin/blends/part_shape.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// A port of another part that a shape refers to: under which key, and which of its own ends is
/// there.
struct Reference {
  PortReference port;
  std::string_view key;
  End own_end = End::start;
};

using References = std::vector<Reference>;

/// Another part whose surface a shape needs, under which key.
struct Need {
  std::string part;
  std::string_view key;
};

/// The straight tubes that a fillet is between, by the names it gives under a key.
struct FilletPipes {
  std::string_view key;
  std::array<std::string, 2> names;
};

/// The tubes that have these names: their surfaces, and where they are in Assembly::parts.
struct TubesToFillet {
  std::array<const PartSurface*, 2> surfaces{};
  std::array<std::uint32_t, 2> parts{};
};

/// What a report says of a part in words; see PartReport.
struct PartNotes {
  std::string construction;
  std::vector<std::string> rejected, warnings;
};

/// A junction, and for each of its ends that is no right circle what leads from there to one that
/// is, where its arm begins.
struct JunctionOfEnds {
  Junction shape;
  std::vector<std::optional<Chain>> transitions;
};

/// What a key of a document means. The functions take shapes of this key only.
struct PartKind {
  std::string_view key;
  bool is_tangent = false;  ///< a transition, whose tangency to its neighbours is reported
  bool names_end = false;   ///< no part of its own, but the name of the end it refers to
  References (*references)(const PartShape&);
  /// What a shape without ports is, "a sphere" or "hollow"; empty for one that has ports.
  std::string_view (*portless)(const PartShape&);
  /// The geometry, of a kind that names no end. Throws as resolve() does.
  PartSurface (*geometry)(const PartContext&, const PartShape&);
  /// What is to be said of a shape that turned out to be this surface.
  PartNotes (*notes)(const PartShape&, const PartSurface&);
  /// The other parts whose surfaces decide about this one, without being joined to it.
  std::vector<Need> (*needs)(const PartShape&);
  /// Of a fillet, none of other kinds: it is no part of its own, but trims these.
  FilletPipes (*pipes)(const PartShape&) = nullptr;
  Fillet (*fillet)(const PartContext&, const PartShape&, const TubesToFillet&) = nullptr;
  /// What `fillet` leaves open, each none of what leaves nothing open: where it is, and that it
  /// does not fold.
  void (*find_loops)(const Assembly&, const PartShape&, const TubesToFillet&, Fillet&) = nullptr;
  void (*prove)(const Assembly&, const PartShape&, const TubesToFillet&, Fillet&) = nullptr;
  /// Of a junction, none of other kinds: the ports that it joins, and its geometry.
  References (*ends)(const PartShape&) = nullptr;
  JunctionOfEnds (*junction)(const PartContext&, const PartShape&) = nullptr;
  /// Which ends are closed for good: no ports, and no bore opens there.
  std::array<bool, 2> closed_ends{};
  /// Of a kind that has no bore of its own, whatever the document's wall.
  bool is_pad = false;
  /// What a wall leaves of the surface, of kinds that know it better than from its rings.
  PartSurface (*bore)(const PartShape&, const PartSurface&, double wall) = nullptr;
  /// And a proved lower bound of how far it is from the surface.
  double (*least_wall)(const PartShape&, const PartSurface&, double wall) = nullptr;

  [[nodiscard]] bool is_junction() const { return junction != nullptr; }
  /// Whether it has a surface with ends.
  [[nodiscard]] bool is_part() const { return !names_end && fillet == nullptr && !is_junction(); }
};

/// The kind of a key. Each is defined in the file of the key's name; see part_rules.h.
template <KeyName key>
[[nodiscard]] const PartKind& part_kind();

/// The kind of a shape.
[[nodiscard]] const PartKind& part_kind(const PartShape& shape);

/// The reference of a part that begins at a port, as "from"; none of one that does not.
[[nodiscard]] References from_port(const PartStart& from);

/// The references of a part between two ports, "from" and "to".
[[nodiscard]] References between_ports(const PortReference& from, const PortReference& to);

}  // namespace dupin::assembly
