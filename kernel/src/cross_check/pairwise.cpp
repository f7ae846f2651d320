#include "cross_check/pairwise.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "cross_check/corefinement.h"
#include "dupin/kernel/error.h"

namespace dupin::cross_check {
namespace {

// Implicit points are within half an ulp of theirs; closed bounds of nearest doubles still tell
// disjoint sets apart safely, because rounding is monotone.
Eigen::AlignedBox3d bounds_of(const mesh::ExactMesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : mesh.points) {
    bounds.extend(point);
  }
  return bounds;
}

mesh::ExactMesh concatenated(mesh::ExactMesh a, const mesh::ExactMesh& b) {
  const std::uint32_t a_doubles = a.double_count(), b_doubles = b.double_count();
  const auto a_implicit = static_cast<std::uint32_t>(a.implicit.size());
  a.points.insert(a.points.begin() + a_doubles, b.points.begin(), b.points.begin() + b_doubles);
  a.points.insert(a.points.end(), b.points.begin() + b_doubles, b.points.end());
  a.implicit.append(b.implicit);
  for (Triangle& corners : a.triangles) {
    for (std::uint32_t& corner : corners) {
      corner += corner < a_doubles ? 0 : b_doubles;
    }
  }
  for (const Triangle& t : b.triangles) {
    Triangle& corners = a.triangles.emplace_back();
    std::transform(t.begin(), t.end(), corners.begin(), [&](std::uint32_t corner) {
      return corner + a_doubles + (corner < b_doubles ? 0 : a_implicit);
    });
  }
  a.sources.insert(a.sources.end(), b.sources.begin(), b.sources.end());
  a.contacts.insert(a.contacts.end(), b.contacts.begin(), b.contacts.end());
  return a;
}

class Pairwise {
 public:
  Pairwise(SetOperation operation, Steps& steps) : operation_(operation), steps_(steps) {}

  [[nodiscard]] mesh::ExactMesh united(std::vector<mesh::ExactMesh> operands) const {
    std::vector<mesh::ExactMesh> groups;
    for (auto& group : grouped(std::move(operands))) {
      groups.push_back(united_tree(group));
    }
    return std::accumulate(std::make_move_iterator(groups.begin() + 1),
                           std::make_move_iterator(groups.end()), std::move(groups.front()),
                           concatenated);
  }

  [[nodiscard]] mesh::ExactMesh folded(std::vector<mesh::ExactMesh> operands) const {
    mesh::ExactMesh result = std::move(operands.front());
    for (std::size_t i = 1; i < operands.size() && !result.triangles.empty(); ++i) {
      if (bounds_of(result).intersects(bounds_of(operands[i]))) {
        result = step(result, operands[i]);
      } else if (operation_ == SetOperation::intersect) {
        result = {};
      }
    }
    return result;
  }

 private:
  [[nodiscard]] mesh::ExactMesh step(const mesh::ExactMesh& a, const mesh::ExactMesh& b) const {
    steps_.next();
    return corefine(operation_, a, b);
  }

  // Consumes the operands; neighbours in the call stay neighbours in the tree.
  [[nodiscard]] mesh::ExactMesh united_tree(std::span<mesh::ExactMesh> operands) const {
    if (operands.size() == 1) {
      return std::move(operands[0]);
    }
    const mesh::ExactMesh left = united_tree(operands.first(operands.size() / 2));
    const mesh::ExactMesh right = united_tree(operands.subspan(operands.size() / 2));
    return bounds_of(left).intersects(bounds_of(right)) ? step(left, right)
                                                        : concatenated(left, right);
  }

  // Operands whose boxes hang together, in the order of their first members.
  static std::vector<std::vector<mesh::ExactMesh>> grouped(std::vector<mesh::ExactMesh> operands) {
    std::vector<Eigen::AlignedBox3d> bounds;
    std::ranges::transform(operands, std::back_inserter(bounds), bounds_of);
    std::vector<std::size_t> group(operands.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (std::size_t i = 0; i < operands.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (group[i] != group[j] && bounds[i].intersects(bounds[j])) {
          const auto [kept, dropped] = std::minmax(group[i], group[j]);
          std::replace(group.begin(), group.end(), std::size_t{dropped}, std::size_t{kept});
        }
      }
    }
    std::vector<std::vector<mesh::ExactMesh>> groups(operands.size());
    for (std::size_t i = 0; i < operands.size(); ++i) {
      groups[group[i]].push_back(std::move(operands[i]));
    }
    std::erase_if(groups, [](const auto& members) { return members.empty(); });
    return groups;
  }

  SetOperation operation_;
  Steps& steps_;
};

mesh::ExactMesh combined(SetOperation operation, std::vector<mesh::ExactMesh> operands,
                         Steps& steps) {
  if (operation != SetOperation::subtract) {
    const auto is_empty = [](const mesh::ExactMesh& mesh) { return mesh.triangles.empty(); };
    const auto removed = std::erase_if(operands, is_empty);
    if (operands.empty() || (removed > 0 && operation == SetOperation::intersect)) {
      return {};
    }
  }
  const Pairwise pairwise(operation, steps);
  return operation == SetOperation::unite ? pairwise.united(std::move(operands))
                                          : pairwise.folded(std::move(operands));
}

// Only what the set is, not how it came to be.
mesh::ExactMesh bare(const mesh::ExactMesh& operand) {
  mesh::ExactMesh mesh;
  mesh.points = operand.points;
  mesh.implicit = operand.implicit;
  mesh.triangles = operand.triangles;
  mesh.sources.resize(mesh.triangles.size());
  mesh.contacts = operand.contacts;
  return mesh;
}

}  // namespace

mesh::ExactMesh mesh_by_corefinement(const Request& request, const Progress& progress) {
  Steps steps(request.steps, progress);
  mesh::ExactMesh mesh = evaluated<mesh::ExactMesh>(
      request.steps, [&](std::uint32_t operand) { return bare(request.operands[operand].exact()); },
      [&](SetOperation operation, std::vector<mesh::ExactMesh> operands) {
        return combined(operation, std::move(operands), steps);
      });
  for (std::uint32_t i = 0; i < mesh.sources.size(); ++i) {
    mesh.sources[i] = {0, i};
  }
  return mesh;
}

}  // namespace dupin::cross_check
