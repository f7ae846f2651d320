#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dupin/kernel/gap.h"
#include "support/none.h"

namespace dupin::gaps {

/// Compares |a b| with |c d| exactly: negative, 0 or positive.
[[nodiscard]] int compare_distances(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Which way an end has to look to belong to another one.
enum class Outlook {
  facing,        ///< against it, by less than 90 degrees off
  not_same_way,  ///< at least 60 degrees away from where that looks
};

/// A k-d tree over the centres of ports, and over their normals where centres coincide, that finds
/// exact nearest ports of an outlook and lets ports be taken out.
class PortTree {
 public:
  /// `ports` outlive the tree. `rank` orders them where distances tie.
  PortTree(std::span<const Port> ports, std::vector<std::uint32_t> rank);

  [[nodiscard]] std::uint32_t rank(std::uint32_t port) const { return rank_[port]; }
  [[nodiscard]] bool holds(std::uint32_t port) const { return held_[port]; }
  void remove(std::uint32_t port);

  /// The nearest port still held, of another part, with this outlook on `port`, at most `reach`
  /// away; the lowest rank among equally near ones.
  [[nodiscard]] std::optional<std::uint32_t> nearest(std::uint32_t port, double reach,
                                                     Outlook outlook = Outlook::facing) const;

  /// Whether the ports are of different parts, or of none.
  [[nodiscard]] bool may_pair(std::uint32_t a, std::uint32_t b) const {
    return part_[a] == kNoPart || part_[a] != part_[b];
  }

 private:
  static constexpr std::uint32_t kNone = support::kNone;
  static constexpr std::uint32_t kNoPart = kNone;  // also: of several parts
  static constexpr std::uint32_t kLeafSize = 8;

  struct Node {
    Vec3 low, high;                // of the centres
    Vec3 normal_low, normal_high;  // of the normals
    std::uint32_t begin = 0, end = 0;
    std::uint32_t left = kNone, right = kNone, parent = kNone;
    std::uint32_t held = 0;
    std::uint32_t least_rank = kNone;  // of those held
    std::uint32_t part = kNoPart;      // that all its ports belong to
  };
  struct Search;

  std::uint32_t build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
  [[nodiscard]] Node bounds(std::uint32_t begin, std::uint32_t end) const;
  void look_for_least_rank(Node& node) const;
  [[nodiscard]] bool worth_visiting(const Node& node, const Search& search) const;
  [[nodiscard]] const Vec3& best_center(const Search& search) const;
  void visit(std::uint32_t node, Search& search) const;

  std::span<const Port> ports_;
  std::vector<std::uint32_t> rank_, part_, order_, leaf_;
  std::vector<bool> held_;
  std::vector<Node> nodes_;
};

}  // namespace dupin::gaps
