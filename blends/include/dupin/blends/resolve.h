#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/junction.h"
#include "dupin/blends/part_surface.h"
#include "dupin/kernel/gap.h"

namespace dupin {

/// One end of one part of a resolved assembly.
struct EndIndex {
  std::uint32_t part = 0;
  End end = End::start;
  friend bool operator==(const EndIndex&, const EndIndex&) = default;
};

/// A part with its geometry; caps are not parts any more but names of ends.
struct ResolvedPart {
  std::string name;
  std::string kind;
  std::uint32_t index = 0;  ///< in Assembly::parts
  PartSurface shape;
  /// What start and end are joined to; the two rings are flips of each other, bitwise.
  std::array<std::optional<EndIndex>, 2> joined;
  /// What the discs that close open ends are called: the cap's name, or "part.start".
  std::array<std::string, 2> end_names;
  bool is_tangent = false;   ///< a transition between its neighbours, to be tangent to them
  bool ends_in_hub = false;  ///< an arm of a junction, which has no end there
  /// Ends that are closed for good, and are no ports: a head's tip, both faces of a flange.
  std::array<bool, 2> is_closed{};
  std::optional<std::uint32_t> run;  ///< the part on whose axis a branch starts

  /// Whether an end may be open: it is not closed for good, nor called as the part (`patches`).
  [[nodiscard]] bool may_open(End end) const {
    return !is_closed.at(at(end)) && end_names.at(at(end)) != name;
  }
};

/// What a ball leaves uncovered that rolls round the crossing of two straight pipes outside of
/// both: a surface tangent to both along closed curves. The pipes' faces end there.
///
/// A ball of radius 0 leaves nothing uncovered: it runs along the edge in which both pipes end, as
/// where one is cut to fit the other (a cope).
struct Fillet {
  /// Those of the balls' ways that lie on the pipes: one for a branch, two where a pipe passes
  /// through the other. All have the same quadrics. None as long as they are not looked for
  /// (`resolve_unproved`).
  std::vector<CanalFillet> loops;
  /// Which ends of the first and second pipe lie inside the other one, and vanish.
  std::array<std::array<bool, 2>, 2> buried{};
  /// A proved lower bound of how far the loops are from folding (least_regularity); none of a cope.
  std::optional<double> regularity;
  double radius = 0;  ///< of the ball, as it was asked for; 0 of a cope

  [[nodiscard]] bool is_cope() const { return radius == 0; }
};

/// A fillet with its geometry. It is no part: it trims those that it is between.
struct ResolvedFillet {
  std::string name;
  std::uint32_t index = 0;                 ///< in Assembly::parts
  std::array<std::uint32_t, 2> between{};  ///< in ResolvedAssembly::parts
  Fillet shape;
};

/// A junction with its geometry. Its arms are parts, called "name.1" and so on, and so are the
/// transitions from elliptical and oblique ends, "name.1.transition"; it is what its hub has left.
struct ResolvedJunction {
  std::string name;
  std::uint32_t index = 0;          ///< in Assembly::parts
  std::vector<std::uint32_t> arms;  ///< in ResolvedAssembly::parts
  Junction shape;
};

struct ResolvedAssembly {
  std::vector<ResolvedPart>
      parts;  ///< in document order, then the arms of junctions, each after its transition
  std::vector<ResolvedFillet> fillets;
  std::vector<ResolvedJunction> junctions;
};

/// All rings, computed once. A port that another part's name refers to is that part's ring,
/// flipped, bitwise. O(n log n).
///
/// Throws Error{invalid_argument}, or what `cyclic_blend` throws, with the part's name and the JSON
/// pointer of the fault: duplicate or bad names, unknown parts or ports, ports taken twice, cyclic
/// references, numbers that are not finite or not positive, parts without length.
[[nodiscard]] ResolvedAssembly resolve(const Assembly& assembly);

/// The same, but of fillets, which take most of the time of documents that have them, only the ends
/// are known that they bury: `Fillet::loops` are left to `find_loops`, `Fillet::regularity` to
/// `prove_fillets`.
[[nodiscard]] ResolvedAssembly resolve_unproved(const Assembly& assembly);

/// Finds where fillets are, on as many threads as TBB may use, where that is not known yet. Throws
/// as `resolve` does, for the first in document order of those that do.
void find_loops(const Assembly& assembly, ResolvedAssembly& resolved);

/// Finds them, and proves likewise that they do not fold.
void prove_fillets(const Assembly& assembly, ResolvedAssembly& resolved);

/// Ends that vanish: inside of a fillet's other pipe, or in a junction's hub. O(parts + fillets).
class BuriedEnds {
 public:
  explicit BuriedEnds(const ResolvedAssembly& assembly);
  [[nodiscard]] bool contains(const EndIndex& end) const {
    return is_buried_.at(end.part).at(at(end.end));
  }

 private:
  std::vector<std::array<bool, 2>> is_buried_;  // of each part
};

/// All ports in document order, named "part.start" and "part.end", without those that are buried
/// or called as their part (`patches`), and without starts of branches that lie in their runs,
/// which face nothing unless they are joined.
[[nodiscard]] std::vector<Port> ports(const ResolvedAssembly& assembly);

/// Pairs and measures these ports of the assembly's. Ends that do not face each other make no pair
/// where a third part lies within `connect`, as where branches start in one header, or arms in one
/// ball. Throws as pair_ends.
[[nodiscard]] std::vector<GapPair> pair_ends(const ResolvedAssembly& assembly,
                                             std::span<const Port> ports, double connect);

}  // namespace dupin
