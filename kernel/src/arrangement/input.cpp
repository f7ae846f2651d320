#include "arrangement/input.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>

#include "arrangement/points/coincident_point_index.h"
#include "boxes/box_tree.h"
#include "boxes/tree_traversal.h"
#include "mesh/coincident_points.h"
#include "support/blocks.h"
#include "support/operation_limits.h"

namespace dupin::arrangement {
namespace {

void check_limits(std::span<const mesh::ExactMesh* const> operands) {
  std::uint64_t points = 0, triangles = 0;
  for (const mesh::ExactMesh* mesh : operands) {
    points += mesh->points.size() + 3 * mesh->planes.size();
    triangles += mesh->triangles.size();
  }
  support::refuse_too_many(points, triangles);
}

// Where the points and triangles of each operand begin.
void lay_out(ArrangementInput& input) {
  PointId doubles = 0;
  std::uint32_t triangles = 0;
  std::size_t planes = 0;
  for (const mesh::ExactMesh* mesh : input.operands) {
    input.first_double.push_back(doubles);
    input.first_triangle.push_back(triangles);
    doubles += mesh->double_count();
    triangles += static_cast<std::uint32_t>(mesh->triangles.size());
    planes += mesh->planes.size();
  }
  input.first_double.push_back(doubles);
  input.first_triangle.push_back(triangles);
  input.triangles.resize(triangles);
  input.points.set_double_count(doubles + 3 * planes);
}

void add_implicit_points(ArrangementInput& input) {
  for (const mesh::ExactMesh* mesh : input.operands) {
    input.first_implicit.push_back(input.points.size());
    for (std::size_t i = 0; i < mesh->implicit.size(); ++i) {
      input.points.add(mesh->implicit[i]);
    }
  }
  input.first_implicit.push_back(input.points.size());
}

void copy_triangles(ArrangementInput& input, std::size_t o) {
  const std::vector<Triangle>& triangles = input.operands[o]->triangles;
  support::for_each_block(triangles.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto& [a, b, c] = triangles[i];
      input.triangles[input.first_triangle[o] + i] = {input.point_of(o, a), input.point_of(o, b),
                                                      input.point_of(o, c)};
    }
  });
}

// Bounds of the nearest doubles of the points. Rounding is monotone: where exact solids meet, these
// overlap.
ArrangementInput::Bounds copy_points(ArrangementInput& input, std::size_t o) {
  const mesh::ExactMesh& mesh = *input.operands[o];
  std::vector<ArrangementInput::Bounds> bounds(support::block_count(mesh.points.size()));
  support::for_each_block(mesh.points.size(), [&](const support::Block& block) {
    ArrangementInput::Bounds& part = bounds[block.number];
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Vec3& point = mesh.points[i];
      part.extend(point);
      if (i < mesh.double_count()) {
        input.points.set(input.first_double[o] + static_cast<PointId>(i), point);
      }
    }
  });
  ArrangementInput::Bounds all;
  for (const ArrangementInput::Bounds& part : bounds) {
    all.extend(part);
  }
  return all;
}

// The planes that triangles with implicit corners lie in, by points of their own.
void find_supports(ArrangementInput& input) {
  const auto has_planes = [](const mesh::ExactMesh* mesh) { return !mesh->planes.empty(); };
  if (std::none_of(input.operands.begin(), input.operands.end(), has_planes)) {
    return;
  }
  input.supports = input.triangles;
  PointId next = input.first_double.back();
  for (std::size_t o = 0; o < input.operands.size(); ++o) {
    const PointId first_plane_point = next;
    for (const std::array<Vec3, 3>& plane : input.operands[o]->planes) {
      for (const Vec3& point : plane) {
        input.points.set(next++, point);
      }
    }
    const std::vector<std::uint32_t>& plane_of = input.operands[o]->plane_of;
    for (std::size_t i = 0; i < plane_of.size(); ++i) {
      if (plane_of[i] != mesh::ExactMesh::kOwnPlane) {
        const PointId first = first_plane_point + 3 * plane_of[i];
        input.supports[input.first_triangle[o] + i] = {first, first + 1, first + 2};
      }
    }
  }
}

void add_points_and_triangles(ArrangementInput& input) {
  lay_out(input);
  add_implicit_points(input);
  input.bounds.resize(input.operands.size());
  support::for_each_in_parallel(input.operands.size(), [&](std::size_t o) {
    copy_triangles(input, o);
    input.bounds[o] = copy_points(input, o);
  });
  for (const ArrangementInput::Bounds& box : input.bounds) {
    if (!box.isEmpty()) {
      input.extent = std::max(
          {input.extent, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
    }
  }
  find_supports(input);
}

void find_operand_pairs(ArrangementInput& input) {
  std::vector<Vec3> corners;
  for (const ArrangementInput::Bounds& b : input.bounds) {
    if (!b.isEmpty()) {
      corners.insert(corners.end(), {b.min(), b.max()});
    }
  }
  const boxes::BoxQuantizer quantizer(corners);
  std::vector<boxes::Box> mapped;
  for (const ArrangementInput::Bounds& b : input.bounds) {
    mapped.push_back(boxes::Box::nothing());
    if (!b.isEmpty()) {
      const boxes::FramedPoint low = quantizer.map(b.min()), high = quantizer.map(b.max());
      mapped.back() = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
    }
  }
  const boxes::BoxTree tree{std::span<const boxes::Box>(mapped)};
  boxes::TreeTraversal(tree).visit([&](std::uint32_t i, std::uint32_t k) {
    const auto [a, b] = std::minmax(tree.items()[i], tree.items()[k]);
    if (input.bounds[a].intersects(input.bounds[b])) {
      input.operand_pairs.push_back({a, b});
    }
  });
  std::sort(input.operand_pairs.begin(), input.operand_pairs.end());
}

// Points that may coincide with another: those inside the bounds of another operand, and all of an
// operand whose surface touches or crosses itself.
std::vector<PointId> shared_candidates(const ArrangementInput& input) {
  // With more neighbours than this, asking all of them costs more than hashing the point.
  constexpr std::size_t kManyNeighbours = 16;
  std::vector<std::vector<std::uint32_t>> neighbours(input.operands.size());
  for (const auto& [a, b] : input.operand_pairs) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::vector<PointId>> candidates(input.operands.size());
  support::for_each_in_parallel(input.operands.size(), [&](std::size_t o) {
    const mesh::ExactMesh& mesh = *input.operands[o];
    const auto itself = static_cast<std::uint32_t>(o);
    const bool all = !mesh.contacts.empty() || neighbours[o].size() > kManyNeighbours ||
                     std::ranges::find(neighbours[o], itself) != neighbours[o].end();
    const auto collect = [&](std::size_t i, std::vector<PointId>& found) {
      const auto holds = [&](std::uint32_t other) {
        return input.bounds[other].contains(mesh.points[i]);
      };
      if (all || std::any_of(neighbours[o].begin(), neighbours[o].end(), holds)) {
        found.push_back(input.point_of(o, static_cast<std::uint32_t>(i)));
      }
    };
    candidates[o] = support::collect_in_order<PointId>(mesh.points.size(), collect);
  });
  return support::joined(std::move(candidates));
}

// Drops points whose hash no other has, by a table far smaller than the points: in two bits per
// slot, whether there is one, and whether there are more.
void keep_possibly_coincident(const PointTable& points, std::vector<PointId>& ids) {
  const std::size_t slots = std::bit_ceil(4 * ids.size() + 4);
  std::vector<std::uint8_t> seen(slots / 4, 0);
  const auto slot = [&](std::size_t i) {
    return mesh::hash_of(points.coordinates(ids[i])) & (slots - 1);
  };
  const auto one = [](std::size_t s) { return static_cast<std::uint8_t>(1u << s % 4 * 2); };
  const auto more = [](std::size_t s) { return static_cast<std::uint8_t>(2u << s % 4 * 2); };
  support::for_each_block(ids.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const std::size_t s = slot(i);
      const std::atomic_ref bits(seen[s / 4]);
      if ((bits.fetch_or(one(s), std::memory_order_relaxed) & one(s)) != 0) {
        bits.fetch_or(more(s), std::memory_order_relaxed);
      }
    }
  });
  ids = support::collect_in_order<PointId>(
      ids.size(), [&](std::size_t i, std::vector<PointId>& kept) {
        if (const std::size_t s = slot(i); (seen[s / 4] & more(s)) != 0) {
          kept.push_back(ids[i]);
        }
      });
}

class Welder {
 public:
  explicit Welder(ArrangementInput& input) : input_(input) {
    input.special.assign(input.points.size(), 0);
    // Points of planes are corners of no triangle.
    std::fill(input.special.begin() + input.first_double.back(),
              input.special.begin() + input.points.double_count(), std::uint8_t{1});
  }

  void weld() {
    doubles_ = shared_candidates(input_);
    if (input_.points.size() > input_.points.double_count()) {
      const auto is_double = [this](PointId id) { return input_.points.is_double(id); };
      const auto first = std::stable_partition(doubles_.begin(), doubles_.end(), is_double);
      implicit_.assign(first, doubles_.end());
      doubles_.erase(first, doubles_.end());
    }
    weld_doubles();
    weld_implicit();
    if (!first_.empty()) {
      renumber(input_.triangles);
      renumber(input_.supports);
    }
  }

 private:
  void join(PointId id, PointId first) {
    if (id == first) {
      return;
    }
    if (first_.empty()) {
      first_.resize(input_.points.size());
      std::iota(first_.begin(), first_.end(), 0u);
    }
    first_[id] = first;
    input_.special[first] = input_.special[id] = 1;
  }
  void renumber(support::BulkVector<Triangle>& triangles) const {
    support::for_each_block(triangles.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        for (PointId& corner : triangles[i]) {
          corner = first_[corner];
        }
      }
    });
  }
  void weld_doubles() {
    keep_possibly_coincident(input_.points, doubles_);
    std::vector<Vec3> coordinates;
    coordinates.reserve(doubles_.size());
    for (const PointId id : doubles_) {
      coordinates.push_back(input_.points.coordinates(id));
    }
    const std::vector<std::uint32_t> first = mesh::coincident_representatives(coordinates);
    for (std::size_t i = 0; i < doubles_.size(); ++i) {
      join(doubles_[i], doubles_[first[i]]);
    }
  }
  void weld_implicit() {
    CoincidentPointIndex index(input_.points, input_.extent, implicit_.size());
    for (const PointId id : implicit_) {
      join(id, index.first_coincident(id));
    }
  }

  ArrangementInput& input_;
  std::vector<PointId> doubles_, implicit_;  // that may coincide with another
  std::vector<PointId> first_;               // coincident with each point; empty while no two are
};

// An edge along which an operand touches itself may have copies of one end only: the fan of
// the other end then passes it twice.
void mark_repeated_edges(ArrangementInput& input) {
  std::vector<std::array<PointId, 2>> edges;
  for (std::size_t o = 0; o < input.operands.size(); ++o) {
    if (input.operands[o]->contacts.empty()) {
      continue;
    }
    edges.clear();
    for (std::uint32_t t = input.first_triangle[o]; t < input.first_triangle[o + 1]; ++t) {
      const Triangle& corners = input.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const PointId from = corners[i], to = corners[(i + 1) % 3];
        if (input.special[from] || input.special[to]) {
          edges.push_back({from, to});
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    for (auto e = edges.begin(); (e = std::adjacent_find(e, edges.end())) != edges.end(); ++e) {
      input.special[(*e)[0]] = input.special[(*e)[1]] = 1;
    }
  }
}

bool same_orientation(const Triangle& a, const Triangle& b) {
  const auto k = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(k + 1) % 3] == a[1];
}

void merge_coincident_triangles(ArrangementInput& input, const BooleanRule& rule) {
  input.merged.assign(input.triangles.size(), 0);
  using Shared = std::pair<Triangle, std::uint32_t>;
  const auto collect = [&input](std::size_t t, std::vector<Shared>& found) {
    Triangle corners = input.triangles[t];
    if (input.special[corners[0]] && input.special[corners[1]] && input.special[corners[2]]) {
      std::sort(corners.begin(), corners.end());
      found.emplace_back(corners, static_cast<std::uint32_t>(t));
    }
  };
  std::vector<Shared> shared = support::collect_in_order<Shared>(input.triangles.size(), collect);
  std::sort(shared.begin(), shared.end());
  for (std::size_t i = 0, end = 0; i < shared.size(); i = end) {
    end = i + 1;
    while (end < shared.size() && shared[end].first == shared[i].first) {
      ++end;
    }
    if (end == i + 1) {
      continue;
    }
    const std::uint32_t kept = shared[i].second;
    std::vector<SignedTriangle> coincident;
    for (std::size_t j = i; j < end; ++j) {
      const std::uint32_t t = shared[j].second;
      const bool same = same_orientation(input.triangles[kept], input.triangles[t]);
      coincident.push_back({t, same ? 1 : -1});
    }
    const bool gone = is_cancelled(input, rule, coincident);
    for (std::size_t j = gone ? 0 : 1; j < coincident.size(); ++j) {
      input.merged[coincident[j].triangle] = 1;
      if (!gone) {
        input.duplicates.push_back({kept, coincident[j]});
      }
    }
  }
  std::stable_sort(input.duplicates.begin(), input.duplicates.end(),
                   [](const auto& a, const auto& b) { return a.kept < b.kept; });
}

}  // namespace

std::uint32_t ArrangementInput::operand_of(std::uint32_t triangle) const {
  return static_cast<std::uint32_t>(
      std::upper_bound(first_triangle.begin(), first_triangle.end(), triangle) -
      first_triangle.begin() - 1);
}

std::uint32_t ArrangementInput::operand_of_point(PointId point) const {
  const std::vector<PointId>& first = points.is_double(point) ? first_double : first_implicit;
  return static_cast<std::uint32_t>(std::upper_bound(first.begin(), first.end(), point) -
                                    first.begin() - 1);
}

std::vector<SignedTriangle> ArrangementInput::cover(std::uint32_t triangle) const {
  std::vector<SignedTriangle> all{{triangle, 1}};
  const auto begin =
      std::lower_bound(duplicates.begin(), duplicates.end(), triangle,
                       [](const Duplicate& d, std::uint32_t t) { return d.kept < t; });
  for (auto d = begin; d != duplicates.end() && d->kept == triangle; ++d) {
    all.push_back(d->copy);
  }
  return all;
}

ArrangementInput load_operands(std::span<const mesh::ExactMesh* const> operands,
                               const BooleanRule& rule, std::vector<OperandPair> pairs) {
  check_limits(operands);
  ArrangementInput input;
  input.operands = operands;
  add_points_and_triangles(input);
  input.operand_pairs = std::move(pairs);
  if (input.operand_pairs.empty()) {
    find_operand_pairs(input);
  }
  Welder(input).weld();
  mark_repeated_edges(input);
  merge_coincident_triangles(input, rule);
  return input;
}

}  // namespace dupin::arrangement
