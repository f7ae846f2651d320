#include "assembly/fillet_overlap.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "assembly/fillet_part.h"
#include "assembly/filleted_runs.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

using Meshes = std::vector<std::vector<surfaces::FilletMesh>>;
using Samplings = std::map<std::uint32_t, RingSampling>;

bool is_on(const ResolvedFillet& fillet, std::uint32_t part) {
  return fillet.between[0] == part || fillet.between[1] == part;
}

bool trims(const ResolvedAssembly& resolved, std::uint32_t part, const Samplings& samplings,
           const Meshes& meshes) {
  try {
    (void)trimmed(resolved, part, samplings.at(part), meshes);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// The largest radius of a fillet for which both of its pipes can be trimmed, the others being as
// they are.
class RadiusSearch {
 public:
  RadiusSearch(const Assembly& assembly, const ResolvedAssembly& resolved, std::size_t fillet,
               const Samplings& samplings, const Meshes& meshes)
      : assembly_(assembly),
        resolved_(resolved),
        fillet_(fillet),
        samplings_(samplings),
        meshes_(meshes) {}

  std::optional<double> run(double radius) {
    // Of a bore the ball is larger by the wall than the document says.
    const double thicker = resolved_.fillets[fillet_].shape.radius - radius;
    return largest_radius_below(radius, [&](double tried) { return fits(tried + thicker); });
  }

 private:
  bool fits(double radius) {
    ResolvedFillet& fillet = resolved_.fillets[fillet_];
    const auto [a, b] = fillet.between;
    const std::array<const PartSurface*, 2> pipes{&resolved_.parts[a].shape,
                                                  &resolved_.parts[b].shape};
    const std::array<std::string, 2> names{resolved_.parts[a].name, resolved_.parts[b].name};
    try {
      if (fillet_fault(pipes, names, radius)) {
        return false;  // without a search for what would do
      }
      fillet.shape = fillet_between(pipes, names, radius);
      meshes_[fillet_] =
          fillet_meshes(assembly_, fillet, {samplings_.at(a), samplings_.at(b)}, kUsualTriangles);
    } catch (const Error&) {
      return false;
    }
    return trims(resolved_, a, samplings_, meshes_) && trims(resolved_, b, samplings_, meshes_);
  }

  const Assembly& assembly_;
  ResolvedAssembly resolved_;
  std::size_t fillet_;
  const Samplings& samplings_;
  Meshes meshes_;
};

// The first pair that cannot be on the part, the other fillets being left out.
std::optional<std::pair<std::size_t, std::size_t>> first_pair(const ResolvedAssembly& resolved,
                                                              std::uint32_t part,
                                                              const Samplings& samplings,
                                                              const Meshes& meshes) {
  ResolvedAssembly two = resolved;
  for (std::size_t later = 0; later < meshes.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const ResolvedFillet &first = resolved.fillets[earlier], &second = resolved.fillets[later];
      if (is_on(first, part) && is_on(second, part)) {
        two.fillets = {first, second};
        if (!trims(two, part, samplings, {meshes[earlier], meshes[later]})) {
          return std::pair(earlier, later);
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<FilletOverlap> fillet_overlap(const Assembly& assembly,
                                            const ResolvedAssembly& resolved, std::uint32_t part,
                                            const Samplings& samplings, const Meshes& meshes) {
  const auto pair = first_pair(resolved, part, samplings, meshes);
  if (!pair) {
    return std::nullopt;
  }
  const auto [earlier, later] = *pair;
  const ResolvedFillet& fillet = resolved.fillets[later];
  const std::string& other = resolved.fillets[earlier].name;
  std::string why = "it overlaps '" + other + "' on '" + resolved.parts[part].name + "'";
  if (const auto* shape = std::get_if<FilletBetween>(&assembly.parts[fillet.index].shape)) {
    const auto largest =
        RadiusSearch(assembly, resolved, later, samplings, meshes).run(shape->radius);
    why += largest ? "; with '" + other + "' as it is, the largest radius that fits is " +
                         decimal(*largest)
                   : "; nor does a smaller ball fit";
  } else {  // a cope
    why += "; without '" + fillet.name + "' the pipes are united uncut, which may do";
  }
  return FilletOverlap{later, why};
}

Error trim_refusal(const Assembly& assembly, const ResolvedAssembly& resolved, std::uint32_t part,
                   const Samplings& samplings, const Meshes& meshes, const Error& error) {
  const auto refusal = [&](const ResolvedFillet& fillet, const std::string& why) {
    return Error(Errc::infeasible_blend, why, fillet.name, document_place(assembly, fillet.index));
  };
  if (const auto overlap = fillet_overlap(assembly, resolved, part, samplings, meshes)) {
    return refusal(resolved.fillets[overlap->fillet], overlap->why);
  }
  const auto on_part = std::ranges::find_if(
      resolved.fillets, [&](const ResolvedFillet& fillet) { return is_on(fillet, part); });
  return refusal(
      *on_part,
      "on '" + resolved.parts[part].name + "', " + error.message() +
          "; fillets must be apart from each other and from its ends; where they are, a finer "
          "tolerance may do");
}

}  // namespace dupin::assembly
