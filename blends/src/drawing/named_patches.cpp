#include "drawing/named_patches.h"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/part_surface.h"

namespace dupin::drawing {
namespace {

using shading::FlatPatch, shading::Patch, shading::PatchTable, shading::RimPatch;
using shading::SectionFamily, shading::section_families, shading::section_family;
using shading::SweptPatch;

using Numbers = std::vector<std::uint32_t>;

class Filler {
 public:
  Filler(const ResolvedAssembly& assembly, const std::map<std::string, std::string>& renamed,
         PatchTable& table)
      : assembly_(assembly),
        buried_(assembly),
        renamed_(renamed),
        table_(table),
        skins_(assembly.parts.size()) {}

  void run() {
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      const ResolvedPart& part = assembly_.parts[i];
      if (const auto* ball = std::get_if<Sphere>(&part.shape)) {
        skins_[i].push_back({add(part.name, *ball)});
      } else {
        add_chain(std::get<Chain>(part.shape), i);
      }
    }
    for (std::size_t i = 0; i < assembly_.parts.size(); ++i) {
      join_at_rings(i);
    }
    for (const ResolvedFillet& fillet : assembly_.fillets) {
      add_fillet(fillet);
    }
    for (const ResolvedJunction& junction : assembly_.junctions) {
      const std::uint32_t hub = add(junction.name, junction.shape.hub);
      for (const std::uint32_t arm : junction.arms) {
        join_with_part(hub, arm);
      }
    }
  }

 private:
  std::uint32_t add(const std::string& name, Patch patch) {
    const auto number = std::uint32_t(table_.patches.size());
    table_.patches.push_back(std::move(patch));
    const auto other = renamed_.find(name);
    table_.of_name[other == renamed_.end() ? name : other->second].push_back(number);
    return number;
  }

  void join(std::uint32_t a, std::uint32_t b) { table_.neighbours.insert(std::minmax(a, b)); }

  // The pieces of one skin, from start to end.
  Numbers add_skin(const Chain& chain, const std::string& name) {
    Numbers result;
    for (const Piece& piece : chain.pieces) {
      result.push_back(add(name, SweptPatch(section_family(piece))));
      if (result.size() > 1 && chain.joints == Joints::smooth) {
        join(result[result.size() - 2], result.back());
      }
    }
    if (chain.closed) {
      join(result.front(), result.back());
    }
    if (chain.joints == Joints::spherical) {
      add_balls(chain, name, result);
    }
    return result;
  }

  // Each touches both pieces that meet in it.
  void add_balls(const Chain& chain, const std::string& name, const Numbers& pieces) {
    const std::vector<PeArc> arcs = cyclide_pieces(chain);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (i == 0 && !chain.closed) {
        continue;
      }
      const std::uint32_t ball = add(name, Sphere{arcs[i].start().m, arcs[i].start().r});
      join(ball, pieces[i]);
      join(ball, pieces[i == 0 ? pieces.size() - 1 : i - 1]);
    }
  }

  std::uint32_t add_face(const Ring& ring, bool is_rim, const std::string& name) {
    return add(name, is_rim ? Patch(RimPatch{ring}) : Patch(FlatPatch{ring.center, ring.normal}));
  }

  void add_chain(const Chain& chain, std::uint32_t index) {
    const ResolvedPart& part = assembly_.parts[index];
    std::vector<Numbers>& skins = skins_[index];
    if (chain.pieces.empty()) {
      return;
    }
    skins.push_back(add_skin(chain, part.name));
    if (chain.wall > 0) {
      skins.push_back(add_skin(inner_skin(chain), part.name));
    }
    for (const End end : {End::start, End::end}) {
      if (!chain.closed && !part.joined.at(at(end)) && !buried_.contains({index, end})) {
        const std::uint32_t face =
            add_face(end_ring(chain, end), chain.wall > 0, part.end_names.at(at(end)));
        if (part.is_closed.at(at(end))) {
          join(at_end(skins.front(), end), face);  // the tip of a head is nearly tangent
        }
      }
    }
  }

  [[nodiscard]] static std::uint32_t at_end(const Numbers& skin, End end) {
    return end == End::start ? skin.front() : skin.back();
  }

  void join_at_rings(std::size_t index) {
    for (const End end : {End::start, End::end}) {
      const auto& joined = assembly_.parts[index].joined.at(at(end));
      if (joined && !skins_[index].empty() && !skins_[joined->part].empty()) {
        join(at_end(skins_[index].front(), end), at_end(skins_[joined->part].front(), joined->end));
      }
    }
  }

  void join_with_part(std::uint32_t patch, std::uint32_t part) {
    for (const Numbers& skin : skins_[part]) {
      for (const std::uint32_t piece : skin) {
        join(patch, piece);
      }
    }
  }

  void add_fillet(const ResolvedFillet& fillet) {
    if (fillet.shape.is_cope()) {
      return;
    }
    for (const CanalFillet& loop : fillet.shape.loops) {
      Numbers stretches;
      for (const SectionFamily& family : section_families(loop)) {
        stretches.push_back(add(fillet.name, SweptPatch(family)));
        join(stretches.front(), stretches.back());
        for (const std::uint32_t part : fillet.between) {
          join_with_part(stretches.back(), part);
        }
      }
    }
  }

  const ResolvedAssembly& assembly_;
  BuriedEnds buried_;
  const std::map<std::string, std::string>& renamed_;
  PatchTable& table_;
  std::vector<std::vector<Numbers>> skins_;  // of each part: outer and inner, by pieces
};

}  // namespace

void add_patches(const ResolvedAssembly& assembly,
                 const std::map<std::string, std::string>& renamed, PatchTable& table) {
  Filler(assembly, renamed, table).run();
}

}  // namespace dupin::drawing
