#include "dupin/blends/edit_chain.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "assembly/bore.h"
#include "assembly/run_solids.h"
#include "assembly/welded_runs.h"
#include "dupin/blends/build.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "editing/chain_of.h"

namespace dupin {
namespace {

class Editor {
  // What `work` returns; its faults are laid at the sphere that was to move.
  template <class Work>
  auto reached(std::size_t sphere, const Work& work) const {
    try {
      return work();
    } catch (const Error& error) {
      const std::string piece = error.part().empty() ? "" : error.part() + ": ";
      throw Error(
          error.code(),
          "sphere " + std::to_string(sphere) + " cannot be moved there: " + piece + error.message(),
          assembly_.parts[part_].name,
          document_place(assembly_, part_, "spheres/" + std::to_string(sphere)));
    }
  }

 public:
  Editor(const Assembly& assembly, std::uint32_t part)
      : assembly_(assembly),
        part_(part),
        edited_(editing::chain_of(assembly, part)),
        own_(std::holds_alternative<PortReference>(edited_.from) ? 1 : 0) {
    const ResolvedAssembly resolved = resolve(assembly);
    const auto found = std::find_if(resolved.parts.begin(), resolved.parts.end(),
                                    [&](const ResolvedPart& p) { return p.index == part; });
    pieces_.pieces = cyclide_pieces(found->shape);
  }

  CyclideChainThrough moved(std::size_t sphere, const PeVector& to, bool on_locus) {
    if (sphere >= edited_.spheres.size()) {
      fail("there is no sphere " + std::to_string(sphere) + "; the last is " +
           std::to_string(edited_.spheres.size() - 1));
    }
    if (!to.m.allFinite() || !(to.r > 0 && std::isfinite(to.r))) {
      fail("a sphere needs finite coordinates and a positive radius, not " +
           decimal(to.r, kMessageDigits));
    }
    if (edited_.joints == ChainJoints::kneecaps) {
      edited_.spheres[sphere] = to;
      (void)reached(sphere, [&] { return edited_kneecaps(); });
      return edited_;
    }
    const std::size_t position = sphere + own_, count = pieces_.pieces.size();
    if (position == 0) {
      fail("the chain's first sphere cannot be moved alone");
    }
    edited_.spheres[sphere] = to;
    if (position % 2 != 0) {
      pin_start(position);
      return edited_;
    }
    const std::size_t junction = position / 2;
    if (junction < count) {
      const EditedChain result = reached(sphere, [&] {
        return on_locus || junction + 1 == count ? move_on_locus(pieces_, junction, to)
                                                 : move_junction(pieces_, junction, to);
      });
      take(result.chain, result.changed.front(), result.changed.back());
    }
    pin_start(position);
    return edited_;
  }

  CyclideChainThrough twisted(std::size_t sphere, double angle) {
    if (edited_.joints == ChainJoints::kneecaps) {
      fail("a chain with kneecaps has no common tangent cones to turn about");
    }
    if (!std::isfinite(angle)) {
      fail("a chain is turned by a finite angle");
    }
    const std::size_t position = sphere + own_;
    if (position % 2 != 0 || position == 0 || position / 2 >= pieces_.pieces.size()) {
      fail("sphere " + std::to_string(sphere) + " is no junction between two pieces" + junctions());
    }
    const PeArc& next = pieces_.pieces[position / 2];
    const Vec3 center = next.start().m;
    const Eigen::AngleAxisd rotation(angle, next.start_tangent().m.normalized());
    for (std::size_t i = sphere + 1; i < edited_.spheres.size(); ++i) {
      edited_.spheres[i].m = center + rotation * (edited_.spheres[i].m - center);
    }
    for (PinnedTangent& pin : edited_.tangents) {
      if (pin.sphere > sphere) {
        pin.tangent.m = rotation * pin.tangent.m;
      }
    }
    pin_start(position + 1);
    return edited_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(Errc::invalid_argument, message, assembly_.parts[part_].name,
                document_place(assembly_, part_, "spheres"));
  }

  // A chain that begins at a port or along a direction keeps its first sphere, if that is not its
  // own, and its tangent.
  [[nodiscard]] Chain edited_kneecaps() const {
    const PeArc& first = pieces_.pieces.front();
    std::vector<PeVector> spheres(own_, first.start());
    spheres.insert(spheres.end(), edited_.spheres.begin(), edited_.spheres.end());
    const bool is_free = std::holds_alternative<ChainFree>(edited_.from);
    return kneecap_chain(spheres, is_free ? std::optional<PeVector>() : first.start_tangent());
  }

  // "; these are 2, 4".
  [[nodiscard]] std::string junctions() const {
    std::string result;
    for (std::size_t piece = 1; piece < pieces_.pieces.size(); ++piece) {
      result += (result.empty() ? "; these are " : ", ") + std::to_string(2 * piece - own_);
    }
    return result.empty() ? "; the chain has none" : result;
  }

  // Junctions after the pieces first..last as the new chain has them; the tangent after these
  // pieces is pinned to what it was.
  void take(const CyclideChain& chain, std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      edited_.spheres[2 * piece + 2 - own_] = chain.pieces[piece].end();
    }
    std::erase_if(edited_.tangents, [&](const PinnedTangent& pin) {
      return pin.sphere + own_ > 2 * first && pin.sphere + own_ <= 2 * last + 2;
    });
    if (last + 1 < chain.pieces.size()) {
      pin(2 * last + 2, chain.pieces[last + 1].start_tangent());
    }
  }

  // Where the first three spheres decide how the chain begins, they did so before one was moved.
  void pin_start(std::size_t moved) {
    const bool is_pinned = std::any_of(edited_.tangents.begin(), edited_.tangents.end(),
                                       [](const PinnedTangent& pin) { return pin.sphere == 0; });
    if (std::holds_alternative<ChainFree>(edited_.from) && moved <= 2 && !is_pinned) {
      pin(0, pieces_.pieces.front().start_tangent());
    }
  }

  void pin(std::size_t position, const PeVector& tangent) {
    edited_.tangents.push_back({position - own_, tangent});
    std::sort(edited_.tangents.begin(), edited_.tangents.end(),
              [](const auto& a, const auto& b) { return a.sphere < b.sphere; });
  }

  const Assembly& assembly_;
  std::uint32_t part_;
  CyclideChainThrough edited_;
  std::size_t own_;  // spheres before the first one of the document
  CyclideChain pieces_;
};

}  // namespace

std::uint32_t find_chain(const Assembly& assembly, const std::optional<std::string>& name) {
  std::optional<std::uint32_t> found;
  std::string chains;
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    const Part& part = assembly.parts[i];
    if (!std::holds_alternative<CyclideChainThrough>(part.shape)) {
      continue;
    }
    if (name && part.name == *name) {
      return i;
    }
    chains += (chains.empty() ? "'" : ", '") + part.name + "'";
    found = found ? assembly.parts.size() : i;
  }
  if (chains.empty()) {
    throw Error(Errc::invalid_argument, "the document has no cyclide_chain", {}, assembly.source);
  }
  if (name) {
    throw Error(Errc::invalid_argument,
                "'" + *name + "' is no cyclide_chain of the document; there is " + chains, {},
                assembly.source);
  }
  if (*found == assembly.parts.size()) {
    throw Error(Errc::invalid_argument, "name one of the chains " + chains, {}, assembly.source);
  }
  return *found;
}

CyclideChainThrough move_sphere(const Assembly& assembly, std::uint32_t part, std::size_t sphere,
                                const PeVector& to, bool on_locus) {
  return Editor(assembly, part).moved(sphere, to, on_locus);
}

CyclideChainThrough twist_chain(const Assembly& assembly, std::uint32_t part, std::size_t sphere,
                                double angle) {
  return Editor(assembly, part).twisted(sphere, angle);
}

void check_edit(const Assembly& edited, std::uint32_t part, double margin, bool build_all) {
  if (!(margin < 1)) {
    throw Error(Errc::invalid_argument, "the margin of an edit must be less than 1, not " +
                                            decimal(margin, kMessageDigits));
  }
  (void)editing::chain_of(edited, part);
  const ResolvedAssembly resolved = resolve(edited);
  for (const ResolvedPart& other : resolved.parts) {
    if (other.index != part) {
      continue;
    }
    const std::vector<PeArc> pieces = cyclide_pieces(other.shape);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Enclosure found = dupin::margin(pieces[i]);
      if (!(found.lower >= margin && found.lower > 0)) {
        throw Error(Errc::irregular_surface,
                    "piece " + std::to_string(i) + " would all but fold: its margin 1 - kappa R " +
                        (found.upper < margin ? "is at most " + decimal_at_most(found.upper)
                                              : "is proved to be at least " +
                                                    decimal_at_least(found.lower) + " only") +
                        ", and must be at least " + decimal(margin, kMessageDigits),
                    other.name, document_place(edited, part));
      }
    }
  }
  const BuildOptions options;
  if (build_all && assembly::walls_of(edited, resolved, options.region)) {
    (void)build(edited);
  } else if (build_all) {  // to unite what are solids is never refused
    (void)assembly::solids_of_runs(edited, resolved, assembly::lattice_spacing(edited, resolved),
                                   options);
  }
}

void check_placement(const Assembly& placed) {
  (void)assembly::lattice_spacing(placed, resolve(placed));
}

}  // namespace dupin
