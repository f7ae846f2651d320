#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "assembly/part_box.h"
#include "canal/straight_pipe.h"
#include "dupin/blends/resolve.h"

namespace dupin {
namespace {

// At most how far the point is from what the part bounds; of bent parts their ends alone tell.
double beyond(const PartSurface& surface, const Vec3& point) {
  if (const auto* const ball = std::get_if<Sphere>(&surface)) {
    return (point - ball->center).norm() - ball->radius;
  }
  if (const RingedSurface* const tube = canal::straight_tube(surface)) {
    return canal::StraightPipe(*tube, {}, 0).outside(point);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const End end : {End::start, End::end}) {
    if (const Ring* const ring = port_ring(surface, end)) {
      least = std::min(least, (ring->center - point).norm());
    }
  }
  return least;
}

/// Parts by where they are along x.
class PartsAlong {
 public:
  PartsAlong(const ResolvedAssembly& assembly, double around) : assembly_(assembly) {
    entries_.reserve(assembly.parts.size());
    for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
      const Eigen::AlignedBox3d box = assembly::part_box(assembly.parts[i].shape);
      entries_.push_back({box.min().x() - around, box.max().x() + around, i});
    }
    std::ranges::sort(entries_, {}, &Entry::low);
    double highest = -std::numeric_limits<double>::infinity();
    for (Entry& entry : entries_) {
      entry.highest = highest = std::max(highest, entry.high);
    }
  }

  /// Whether a part other than two is at most that far from the point.
  [[nodiscard]] bool has_other_near(const Vec3& point, double distance, const std::string& part,
                                    const std::string& other) const {
    auto i = std::size_t(std::ranges::upper_bound(entries_, point.x(), {}, &Entry::low) -
                         entries_.begin());
    while (i > 0 && entries_[i - 1].highest >= point.x()) {
      const Entry& entry = entries_[--i];
      const ResolvedPart& near = assembly_.parts[entry.part];
      if (entry.high >= point.x() && near.name != part && near.name != other &&
          beyond(near.shape, point) <= distance) {
        return true;
      }
    }
    return false;
  }

 private:
  struct Entry {
    double low, high;
    std::uint32_t part;
    double highest = 0;  // of the entries up to it
  };
  const ResolvedAssembly& assembly_;
  std::vector<Entry> entries_;
};

}  // namespace

std::vector<GapPair> pair_ends(const ResolvedAssembly& assembly, std::span<const Port> ports,
                               double connect) {
  std::optional<PartsAlong> parts;  // most assemblies never ask
  return pair_ends(ports, connect, [&](std::size_t port, std::size_t other) {
    if (!parts) {
      parts.emplace(assembly, connect);
    }
    return parts->has_other_near(ports[port].ring.center, connect, ports[port].part,
                                 ports[other].part);
  });
}

}  // namespace dupin
