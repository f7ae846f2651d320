#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/edit_chain.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "editing/chain_of.h"

namespace dupin {
using editing::chain_of;
namespace {

// Of the way from the piece to its bias sphere, by which a junction is moved.
constexpr std::array kShares{0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};

// Moves that seem to do, per piece, which are built: these take long.
constexpr int kBuilds = 4;

// Spheres before the first one of the document.
std::size_t own(const CyclideChainThrough& chain) {
  return std::holds_alternative<PortReference>(chain.from) ? 1 : 0;
}

std::vector<PeArc> pieces_of(const Assembly& assembly, std::uint32_t part) {
  const ResolvedAssembly resolved = resolve(assembly);
  const auto found = std::find_if(resolved.parts.begin(), resolved.parts.end(),
                                  [&](const ResolvedPart& p) { return p.index == part; });
  return cyclide_pieces(found->shape);
}

std::vector<std::size_t> turned(const CyclideChainThrough& chain,
                                const std::vector<PeArc>& pieces) {
  std::vector<PeVector> spheres(own(chain), pieces.front().start());
  spheres.insert(spheres.end(), chain.spheres.begin(), chain.spheres.end());
  return bias_warnings({pieces}, spheres);
}

PeVector at_places(const PeVector& sphere) {
  return {{rounded(sphere.m.x(), kPlaceDigits), rounded(sphere.m.y(), kPlaceDigits),
           rounded(sphere.m.z(), kPlaceDigits)},
          rounded(sphere.r, kPlaceDigits)};
}

// Whether fewer pieces turn away, and this one does not.
bool is_remedied(const Assembly& moved, std::uint32_t part, std::size_t piece, std::size_t before,
                 double margin) {
  const auto left = turned(chain_of(moved, part), pieces_of(moved, part));
  if (left.size() >= before || std::ranges::find(left, piece) != left.end()) {
    return false;
  }
  check_edit(moved, part, margin, false);
  return true;
}

std::optional<std::pair<std::size_t, PeVector>> remedy_of(const Assembly& assembly,
                                                          std::uint32_t part, std::size_t piece,
                                                          std::size_t before, double margin) {
  const CyclideChainThrough& chain = chain_of(assembly, part);
  const PeArc arc = pieces_of(assembly, part)[piece];
  const Vec3 towards = chain.spheres[2 * piece + 1 - own(chain)].m - circle_at(arc, 0.5).center;
  int builds = 0;
  for (const double share : kShares) {
    for (const std::size_t junction : {2 * piece + 2, 2 * piece}) {
      if (junction == 0 || junction - own(chain) >= chain.spheres.size()) {
        continue;
      }
      const std::size_t sphere = junction - own(chain);
      const PeVector& from = chain.spheres[sphere];
      const PeVector to = at_places({from.m + share * towards, from.r});
      try {
        Assembly moved = assembly;
        moved.parts[part].shape = move_sphere(assembly, part, sphere, to);
        if (is_remedied(moved, part, piece, before, margin)) {
          if (++builds > kBuilds) {
            return std::nullopt;
          }
          check_edit(moved, part, margin);
          return std::pair(sphere, to);
        }
      } catch (const Error& error) {  // no chain goes there
        if (error.code() == Errc::cancelled) {
          throw;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<TurnedPiece> turned_pieces(const Assembly& assembly, std::uint32_t part,
                                       double margin) {
  const CyclideChainThrough& chain = chain_of(assembly, part);
  std::vector<TurnedPiece> result;
  if (chain.joints == ChainJoints::kneecaps) {
    return result;
  }
  const auto found = turned(chain, pieces_of(assembly, part));
  for (const std::size_t piece : found) {
    result.push_back({piece, 2 * piece + 1 - own(chain),
                      remedy_of(assembly, part, piece, found.size(), margin)});
  }
  return result;
}

}  // namespace dupin
