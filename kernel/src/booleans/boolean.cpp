#include "dupin/kernel/boolean.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <vector>

#include "booleans/combine.h"
#include "dupin/kernel/parallel.h"
#include "mesh/exact_mesh.h"
#include "support/sequences.h"

namespace dupin {
namespace {

using mesh::ExactMesh;

// -1, 0 or 1.
int compare(const mesh::ExactPoint& a, const mesh::ExactPoint& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (const auto sign = (a[k] - b[k]).sign(); sign != 0) {
      return static_cast<int>(sign);
    }
  }
  return 0;
}

// Whether the first mesh comes before the second, by what they are alone.
bool precedes(const ExactMesh& a, const ExactMesh& b) {
  if (&a == &b) {
    return false;
  }
  const auto before = [](const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  const auto [p, q] =
      std::mismatch(a.points.begin(), a.points.end(), b.points.begin(), b.points.end());
  if (p != a.points.end() || q != b.points.end()) {
    return q != b.points.end() && (p == a.points.end() || before(*p, *q));
  }
  if (a.triangles != b.triangles) {
    return a.triangles < b.triangles;
  }
  for (std::size_t i = 0; i < std::min(a.implicit.size(), b.implicit.size()); ++i) {
    if (const int order = compare(a.implicit[i], b.implicit[i]); order != 0) {
      return order < 0;
    }
  }
  return std::tie(a.labels, a.names) < std::tie(b.labels, b.names);
}

// The operation on operands of which those from `first_alike` on may be exchanged: in an order that
// does not depend on theirs, so that the result does not either. One that is there twice does what
// it does once.
template <class Combine>
Solid combine_alike(std::span<const Solid> operands, std::size_t first_alike,
                    const Combine& combine) {
  std::vector<std::uint32_t> order = support::numbers_below(operands.size());
  const auto alike =
      order.begin() + static_cast<std::ptrdiff_t>(std::min(first_alike, order.size()));
  const auto before = [&operands](std::uint32_t i, std::uint32_t j) {
    return precedes(operands[i].exact(), operands[j].exact());
  };
  std::stable_sort(alike, order.end(), before);
  order.erase(std::unique(alike, order.end(), std::not_fn(before)), order.end());
  ExactMesh result = combine(support::selected(operands, order));
  for (Source& source : result.sources) {
    source.operand = order[source.operand];
  }
  return Solid(std::make_shared<const ExactMesh>(std::move(result)));
}

}  // namespace

Solid unite(std::span<const Solid> operands, const BooleanOptions& options) {
  const UsualArithmetic usual;
  return combine_alike(operands, 0, [&](std::span<const Solid> sorted) {
    return booleans::combine_in_union(sorted, options);
  });
}

Solid intersect(std::span<const Solid> operands, const BooleanOptions& options) {
  const UsualArithmetic usual;
  return combine_alike(operands, 0, [&](std::span<const Solid> sorted) {
    return booleans::combine(sorted, arrangement::intersection_rule(sorted.size()), options);
  });
}

Solid subtract(const Solid& from, std::span<const Solid> operands, const BooleanOptions& options) {
  const UsualArithmetic usual;
  std::vector<Solid> all = {from};
  all.insert(all.end(), operands.begin(), operands.end());
  return combine_alike(all, 1, [&](std::span<const Solid> sorted) {
    return booleans::combine(sorted, arrangement::difference_rule(sorted.size()), options);
  });
}

}  // namespace dupin
