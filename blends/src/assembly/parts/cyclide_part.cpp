#include "assembly/parts/cyclide_part.h"

#include <cmath>
#include <optional>
#include <string>

#include "assembly/parts/part_checks.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

class ChainPart {
  std::vector<PeVector> all_spheres() const {
    std::vector<PeVector> result;
    if (port_ != nullptr) {
      result.push_back(contact_sphere(context_.ring(*port_)));
    }
    result.insert(result.end(), chain_.spheres.begin(), chain_.spheres.end());
    return result;
  }

  [[noreturn]] void fail(Errc code, const std::string& key, const std::string& message) const {
    const auto& [assembly, index, ring, motion, surface] = context_;
    throw Error(code, message, assembly.parts.at(index).name, document_place(assembly, index, key));
  }

  static std::string sphere_key(std::size_t position) {
    return "spheres/" + std::to_string(position);
  }

  // What `work` returns; a fault of a piece gets the place of the sphere that it leads to.
  template <class Work>
  auto at_piece(const Work& work) const {
    try {
      return work();
    } catch (const PieceError& error) {
      fail(error.code(), sphere_key(2 * error.piece() + (port_ == nullptr ? 2 : 1)),
           error.part() + ": " + error.message());
    } catch (const Error& error) {
      fail(error.code(), error.code() == Errc::invalid_argument ? "tangents" : "spheres",
           error.message());
    }
  }

  void check_numbers() const {
    for (std::size_t i = 0; i < chain_.spheres.size(); ++i) {
      const auto& [center, radius] = chain_.spheres[i];
      check_finite(context_, center, sphere_key(i));
      check_positive(context_, radius, sphere_key(i));
    }
    if (chain_.wall != 0) {
      check_positive(context_, chain_.wall, "wall");
    }
    if (port_ != nullptr && context_.ring(*port_).ellipse) {
      fail(Errc::invalid_argument, "from",
           "a chain of cyclides begins at a circle, not an ellipse");
    }
    if (chain_.wall > 0 && port_ != nullptr) {
      fail(Errc::invalid_argument, "wall", "a hollow chain has no ports and begins at none");
    }
  }

  PeVector initial(const std::vector<PeVector>& spheres) const {
    if (port_ != nullptr) {
      return contact_tangent(context_.ring(*port_));
    }
    if (const auto* given = std::get_if<ChainDirection>(&chain_.from)) {
      if (!(given->axis.norm() > 0) || !given->axis.allFinite() || !std::isfinite(given->slope)) {
        fail(Errc::invalid_argument, "direction", "the direction must be finite and not zero");
      }
      return {std::hypot(1, given->slope) * given->axis.normalized(), given->slope};
    }
    try {
      return initial_tangent(spheres[0], spheres[1], spheres[2]);
    } catch (const Error& error) {
      fail(error.code(), "spheres", error.message());
    }
  }

  CyclideChain composed(const std::vector<PeVector>& spheres) const {
    const std::size_t own = port_ == nullptr ? 0 : 1;
    std::vector<PinnedTangent> pinned = chain_.tangents;
    PeVector tangent;
    bool has_first = false;
    for (std::size_t i = 0; i < pinned.size(); ++i) {
      if (pinned[i].sphere >= chain_.spheres.size() || (pinned[i].sphere + own) % 2 != 0) {
        fail(Errc::invalid_argument, "tangents/" + std::to_string(i) + "/sphere",
             "there is no junction " + std::to_string(pinned[i].sphere));
      }
      pinned[i].sphere += own;
      if (pinned[i].sphere == 0) {
        tangent = pinned[i].tangent;
        has_first = true;
      }
    }
    if (!has_first) {
      tangent = initial(spheres);
    }
    return at_piece([&] { return compose(spheres, tangent, pinned); });
  }

 public:
  ChainPart(const PartContext& context, const CyclideChainThrough& chain)
      : context_(context), chain_(chain), port_(std::get_if<PortReference>(&chain.from)) {}

  PartSurface surface() const {
    check_numbers();
    const auto spheres = all_spheres();
    check_count(spheres.size());
    if (chain_.joints == ChainJoints::kneecaps) {
      check_kneecaps();
      return kneecaps(spheres);
    }
    return tube(spheres);
  }

 private:
  void check_count(std::size_t spheres) const {
    if (spheres < 3 || spheres % 2 == 0) {
      fail(Errc::invalid_argument, "spheres",
           std::string(port_ == nullptr ? "a chain needs an odd number of spheres, three at least"
                                        : "a chain from a port needs an even number of spheres, "
                                          "two at least") +
               ": junctions and bias spheres in turn, not " +
               std::to_string(chain_.spheres.size()));
    }
  }

  // Every piece but the first is shaped by its three spheres alone.
  void check_kneecaps() const {
    if (!chain_.tangents.empty()) {
      fail(Errc::invalid_argument, "tangents", "a chain with kneecaps takes no 'tangents'");
    }
  }

  Chain kneecaps(const std::vector<PeVector>& spheres) const {
    const bool is_free = std::holds_alternative<ChainFree>(chain_.from);
    const auto tangent = is_free ? std::optional<PeVector>() : initial(spheres);
    Chain chain = at_piece([&] { return hollow(kneecap_chain(spheres, tangent), chain_.wall); });
    if (port_ != nullptr) {
      std::get<CyclidePiece>(chain.pieces.front()).start = flipped(context_.ring(*port_));
    }
    return chain;
  }

  Chain tube(const std::vector<PeVector>& spheres) const {
    const CyclideChain chain = composed(spheres);
    return at_piece([&] {
      return port_ == nullptr ? cyclide_tube(chain, chain_.wall)
                              : cyclide_tube(chain, flipped(context_.ring(*port_)),
                                             circle_at(chain.pieces.back(), 1));
    });
  }

  const PartContext& context_;
  const CyclideChainThrough& chain_;
  const PortReference* port_;
};

}  // namespace

PartSurface cyclide_chain(const PartContext& context, const CyclideChainThrough& chain) {
  return ChainPart(context, chain).surface();
}

}  // namespace dupin::assembly
