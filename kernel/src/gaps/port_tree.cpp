#include "gaps/port_tree.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "exact/exact_numbers.h"

namespace dupin::gaps {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

bool facing(const Vec3& normal, const Vec3& other) {
  return CGAL::angle(Kernel::Vector_3(normal.x(), normal.y(), normal.z()),
                     Kernel::Vector_3(other.x(), other.y(), other.z())) == CGAL::OBTUSE;
}

// Whether the directions are 60 degrees apart or more.
bool is_not_same_way(const Vec3& normal, const Vec3& other) {
  const exact::ExactVector n = exact::exact_vector(normal), m = exact::exact_vector(other);
  const auto along = exact::dot(n, m);
  return along <= 0 || 4 * along * along <= exact::dot(n, n) * exact::dot(m, m);
}

bool looks(const Vec3& normal, const Vec3& other, Outlook outlook) {
  return outlook == Outlook::facing ? facing(normal, other) : is_not_same_way(normal, other);
}

// Of two directions less than 60 degrees apart, whatever rounding does.
constexpr double kSurelySameWay = 0.6;

bool within(const Vec3& a, const Vec3& b, double reach) {
  return compare_distances(a, b, Vec3::Zero(), {reach, 0, 0}) <= 0;
}

std::vector<std::uint32_t> numbered_parts(std::span<const Port> ports, std::uint32_t none) {
  std::vector<std::string_view> names;
  for (const Port& port : ports) {
    names.emplace_back(port.part);
  }
  std::sort(names.begin(), names.end());
  std::vector<std::uint32_t> numbers;
  for (const Port& port : ports) {
    const auto place = std::lower_bound(names.begin(), names.end(), port.part);
    numbers.push_back(port.part.empty() ? none : static_cast<std::uint32_t>(place - names.begin()));
  }
  return numbers;
}

}  // namespace

int compare_distances(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return CGAL::compare_distance(point(a), point(b), point(c), point(d));
}

struct PortTree::Search {
  std::uint32_t port;
  Vec3 center, normal;
  double reach;
  Outlook outlook;
  std::uint32_t best = kNone;
};

const Vec3& PortTree::best_center(const Search& search) const {
  return ports_[search.best].ring.center;
}

PortTree::PortTree(std::span<const Port> ports, std::vector<std::uint32_t> rank)
    : ports_(ports),
      rank_(std::move(rank)),
      part_(numbered_parts(ports, kNoPart)),
      order_(ports.size()),
      leaf_(ports.size()),
      held_(ports.size(), true) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!ports.empty()) {
    build(0, static_cast<std::uint32_t>(ports.size()), kNone);
  }
}

PortTree::Node PortTree::bounds(std::uint32_t begin, std::uint32_t end) const {
  const std::uint32_t first = order_[begin];
  Node node;
  node.low = node.high = ports_[first].ring.center;
  node.normal_low = node.normal_high = ports_[first].ring.normal;
  node.part = part_[first];
  for (std::uint32_t i = begin; i < end; ++i) {
    const Ring& ring = ports_[order_[i]].ring;
    node.low = node.low.cwiseMin(ring.center);
    node.high = node.high.cwiseMax(ring.center);
    node.normal_low = node.normal_low.cwiseMin(ring.normal);
    node.normal_high = node.normal_high.cwiseMax(ring.normal);
    node.part = node.part == part_[order_[i]] ? node.part : kNoPart;
  }
  node.begin = begin;
  node.end = end;
  node.held = end - begin;
  return node;
}

std::uint32_t PortTree::build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  const Node node = bounds(begin, end);
  nodes_.push_back(node);
  nodes_[index].parent = parent;
  if (end - begin <= kLeafSize) {
    for (std::uint32_t i = begin; i < end; ++i) {
      leaf_[order_[i]] = index;
    }
    look_for_least_rank(nodes_[index]);
    return index;
  }
  int axis = 0;
  const bool by_center = (node.high - node.low).maxCoeff(&axis) > 0;
  if (!by_center) {
    (node.normal_high - node.normal_low).maxCoeff(&axis);
  }
  const auto key = [&](std::uint32_t port) {
    const Ring& ring = ports_[port].ring;
    return std::pair(by_center ? ring.center[axis] : ring.normal[axis], port);
  };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  const std::uint32_t left = build(begin, middle, index);
  const std::uint32_t right = build(middle, end, index);
  nodes_[index].left = left;
  nodes_[index].right = right;
  look_for_least_rank(nodes_[index]);
  return index;
}

void PortTree::look_for_least_rank(Node& node) const {
  if (node.left != kNone) {
    node.least_rank = std::min(nodes_[node.left].least_rank, nodes_[node.right].least_rank);
    return;
  }
  node.least_rank = kNone;
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    if (held_[order_[i]]) {
      node.least_rank = std::min(node.least_rank, rank_[order_[i]]);
    }
  }
}

void PortTree::remove(std::uint32_t port) {
  held_[port] = false;
  for (std::uint32_t node = leaf_[port]; node != kNone; node = nodes_[node].parent) {
    --nodes_[node].held;
    look_for_least_rank(nodes_[node]);
  }
}

// The nearest point of a box and the normal of a box of normals that faces best are made of the
// doubles given, so that these decisions are exact too.
bool PortTree::worth_visiting(const Node& node, const Search& search) const {
  const std::uint32_t part = part_[search.port];
  if (node.held == 0 || (part != kNoPart && node.part == part)) {
    return false;
  }
  const Vec3 opposed = (search.normal.array() > 0).select(node.normal_low, node.normal_high);
  if (search.outlook == Outlook::facing ? !facing(search.normal, opposed)
                                        : search.normal.dot(opposed) > kSurelySameWay) {
    return false;
  }
  const Vec3 closest = search.center.cwiseMax(node.low).cwiseMin(node.high);
  if (search.best == kNone) {
    return within(search.center, closest, search.reach);
  }
  const int order = compare_distances(search.center, closest, search.center, best_center(search));
  return order < 0 || (order == 0 && node.least_rank < rank_[search.best]);
}

void PortTree::visit(std::uint32_t index, Search& search) const {
  const Node& node = nodes_[index];
  if (!worth_visiting(node, search)) {
    return;
  }
  if (node.left != kNone) {
    const auto outside = [&](std::uint32_t child) {
      const Node& box = nodes_[child];
      return (search.center - search.center.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
    };
    const auto key = [&](std::uint32_t child) {
      return std::pair(outside(child), nodes_[child].least_rank);
    };
    const bool left_first = key(node.left) <= key(node.right);
    visit(left_first ? node.left : node.right, search);
    visit(left_first ? node.right : node.left, search);
    return;
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const std::uint32_t port = order_[i];
    const Ring& ring = ports_[port].ring;
    if (!held_[port] || port == search.port || !may_pair(search.port, port) ||
        !looks(search.normal, ring.normal, search.outlook)) {
      continue;
    }
    if (search.best == kNone) {
      search.best = within(search.center, ring.center, search.reach) ? port : kNone;
      continue;
    }
    const int order =
        compare_distances(search.center, ring.center, search.center, best_center(search));
    if (order < 0 || (order == 0 && rank_[port] < rank_[search.best])) {
      search.best = port;
    }
  }
}

std::optional<std::uint32_t> PortTree::nearest(std::uint32_t port, double reach,
                                               Outlook outlook) const {
  const Ring& ring = ports_[port].ring;
  Search search{port, ring.center, ring.normal, reach, outlook};
  visit(0, search);
  return search.best == kNone ? std::nullopt : std::optional(search.best);
}

}  // namespace dupin::gaps
