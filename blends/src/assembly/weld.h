#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/ring.h"
#include "tessellation/level_discs.h"

namespace dupin::assembly {

/// Ends that go on nowhere, whose discs lie about one centre in one plane, bitwise: a pipe's end
/// and the face of its flange, the faces of two flanges. Each rounded by itself, they would cross
/// each other; made of the same triangles, they are one face to the exact union.
class LevelEnds {
 public:
  LevelEnds() = default;
  /// `run_of` has the place of each part's run. O(n log n).
  LevelEnds(const ResolvedAssembly& assembly, std::vector<std::size_t> run_of);
  /// Flanges of one size get the sampling of the first of those whose faces are level, with the
  /// most segments of any.
  void share(std::vector<RingSampling>& of_runs) const;
  /// The disc of an end that goes on elsewhere has this ring in it.
  void put_within(const EndIndex& end, tessellation::SampledRing ring);
  /// Smaller rings in the disc of an end, ascending, with the names of those ends that look to the
  /// same side.
  [[nodiscard]] std::vector<tessellation::SampledRing> within(
      const EndIndex& end, std::span<const RingSampling> of_runs) const;

 private:
  struct Member {
    EndIndex end;
    Ring ring;
    std::size_t run = 0;
    bool is_flange = false;
    std::string name = {};
  };
  std::vector<std::vector<Member>> groups_;  // by radius
  std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> group_of_;
  std::map<std::pair<std::uint32_t, std::size_t>, tessellation::SampledRing> put_within_;
};

/// A ring in the disc of an end that goes on elsewhere, the same as another surface has.
struct RingWithin {
  EndIndex end;
  tessellation::SampledRing ring;
};

/// The tubes of `parts` as one mesh, closed but for what fillets
/// trimmed: tubes that share a ring share its vertices, and every
/// other end gets a disc, but for ends that a fillet buries. `tubes` are the tessellations of all
/// parts, by part; `sampling` is the run's, `of_runs` those of all. Labels name the parts, and the
/// discs of open ends as ResolvedPart::end_names says.
[[nodiscard]] TriMesh welded(const ResolvedAssembly& assembly, std::span<const std::uint32_t> parts,
                             const std::vector<TriMesh>& tubes, const RingSampling& sampling,
                             const BuriedEnds& buried, const LevelEnds& level,
                             std::span<const RingSampling> of_runs);

/// The parts of a labelled mesh that share no points, each with the points it uses, in the order of
/// their first triangles.
[[nodiscard]] std::vector<TriMesh> connected_parts(const TriMesh& mesh);

}  // namespace dupin::assembly
