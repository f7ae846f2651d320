#include "shading/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/parallel.h"

namespace dupin::shading {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kChunk = 4096;
// Normals of neighbouring patches that differ by less are one.
constexpr double kTangentCosine = 0.9998476951563913;  // of a degree
// As far apart, binary32 hardly tells directions apart.
constexpr double kSameDirection = 0x1p-22;

// The surface at a point of the mesh, for the triangles of one patch around it.
struct PatchAtPoint {
  std::uint32_t patch = 0;
  Vec3 facets = Vec3::Zero();  // the sum of the triangles' normals, by area
  std::optional<Vec3> normal;
  std::size_t one = 0;  // the first of those that have one normal
};

// The patches that a label may stand for, and boxes around every few of them, grown by the largest
// distance that a point may be from them.
struct Candidates {
  static constexpr std::size_t kBlock = 16;

  std::vector<std::uint32_t> patches;
  std::vector<Eigen::AlignedBox3d> boxes, blocks;
};

Candidates candidates_of(const PatchTable& table, const std::string& name, double reach) {
  Candidates result;
  if (const auto found = table.of_name.find(name); found != table.of_name.end()) {
    result.patches = found->second;
  }
  for (std::size_t i = 0; i < result.patches.size(); ++i) {
    Eigen::AlignedBox3d box = box_of(table.patches[result.patches[i]]);
    box.min() -= Vec3::Constant(reach);
    box.max() += Vec3::Constant(reach);
    result.boxes.push_back(box);
    if (i % Candidates::kBlock == 0) {
      result.blocks.emplace_back();
    }
    result.blocks.back().extend(box);
  }
  return result;
}

Direction direction(const Vec3& v) {
  // Adding 0 takes the sign from a zero.
  return {float(v.x()) + 0.0F, float(v.y()) + 0.0F, float(v.z()) + 0.0F};
}

void in_chunks(std::size_t count, const std::function<void(std::size_t, std::size_t)>& visit) {
  for_each_in_parallel((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    visit(chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
  });
}

class Shader {
 public:
  Shader(const PatchTable& table, const TriMesh& mesh, const MeshBounds& bounds)
      : table_(table), mesh_(mesh), bounds_(bounds) {
    for (const std::string& name : mesh.names) {
      candidates_.push_back(candidates_of(table, name, bounds.largest));
    }
  }

  CornerNormals run() {
    const std::size_t count = mesh_.triangles.size();
    result_.resize(count);
    facets_.resize(count);
    patch_of_.assign(count, kNone);
    in_chunks(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto& [a, b, c] = mesh_.triangles[i];
        facets_[i] =
            (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]) / 2;
        patch_of_[i] = patch_of(i);
      }
    });
    list_corners();
    in_chunks(mesh_.points.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<PatchAtPoint> around;
      for (std::size_t i = begin; i < end; ++i) {
        shade(i, around);
      }
    });
    return std::move(result_);
  }

 private:
  // The nearest one, about within the largest bound. What is as large as `facet` and nearly on a
  // surface is off it by how far it leans, too: that tells the sides of an edge apart next to it.
  [[nodiscard]] std::uint32_t nearest(const Candidates& candidates, const Vec3& place,
                                      const Vec3& facet = Vec3::Zero()) const {
    std::uint32_t result = kNone;
    double least = std::numeric_limits<double>::infinity();
    const double size = std::sqrt(facet.norm());
    for (std::size_t i = 0; i < candidates.patches.size(); ++i) {
      if (i % Candidates::kBlock == 0 &&
          !candidates.blocks[i / Candidates::kBlock].contains(place)) {
        i += Candidates::kBlock - 1;
        continue;
      }
      if (!candidates.boxes[i].contains(place)) {
        continue;
      }
      const std::uint32_t patch = candidates.patches[i];
      const std::optional<Foot> foot = rough_foot_on(table_.patches[patch], place);
      if (foot && foot->distance < 2 * bounds_.largest) {
        const double off =
            foot->distance + (size > 0 ? foot->normal.cross(facet).norm() / size : 0);
        if (off < least) {
          least = off;
          result = patch;
        }
      }
    }
    return result;
  }

  [[nodiscard]] std::uint32_t patch_of(std::size_t triangle) const {
    if (mesh_.labels.empty()) {
      return kNone;
    }
    const Candidates& candidates = candidates_[mesh_.labels[triangle]];
    if (candidates.patches.size() == 1) {
      return candidates.patches.front();
    }
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return nearest(candidates, (mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3,
                   facets_[triangle]);
  }

  // Those of each point, in the order of the triangles.
  void list_corners() {
    begin_.assign(mesh_.points.size() + 1, 0);
    for (const Triangle& triangle : mesh_.triangles) {
      for (const std::uint32_t point : triangle) {
        ++begin_[point + 1];
      }
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) {
      begin_[i] += begin_[i - 1];
    }
    corners_.resize(3 * mesh_.triangles.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      corners_[next[mesh_.triangles[i / 3][i % 3]]++] = i;
    }
  }

  void shade(std::size_t point, std::vector<PatchAtPoint>& around) {
    around.clear();
    for (std::size_t i = begin_[point]; i < begin_[point + 1]; ++i) {
      const std::size_t triangle = corners_[i] / 3;
      if (patch_of_[triangle] != kNone) {
        entry(around, patch_of_[triangle], point, triangle).facets += facets_[triangle];
      }
    }
    std::ranges::sort(around, {}, &PatchAtPoint::patch);
    unite_tangent(around);
    for (std::size_t i = begin_[point]; i < begin_[point + 1]; ++i) {
      const std::size_t triangle = corners_[i] / 3;
      const auto own = std::ranges::find(around, patch_of_[triangle], &PatchAtPoint::patch);
      result_[triangle].at(corners_[i] % 3) =
          chosen(facets_[triangle], own == around.end() ? std::nullopt : own->normal);
    }
  }

  // The normal is turned later, when all facets are known.
  [[nodiscard]] PatchAtPoint& entry(std::vector<PatchAtPoint>& around, std::uint32_t patch,
                                    std::size_t point, std::size_t triangle) const {
    const auto known = std::ranges::find(around, patch, &PatchAtPoint::patch);
    if (known != around.end()) {
      return *known;
    }
    const Vec3& place = mesh_.points[point];
    std::optional<Foot> foot = foot_on(table_.patches[patch], place);
    if (!foot || !(foot->distance <= bounds_.usual)) {
      // A triangle may reach from its patch into the next one of its part.
      const std::uint32_t other = nearest(candidates_[mesh_.labels[triangle]], place);
      if (other != kNone && other != patch) {
        const std::optional<Foot> there = foot_on(table_.patches[other], place);
        foot = there && !(foot && foot->distance <= there->distance) ? there : foot;
      }
    }
    const bool is_there = foot && foot->distance <= bounds_.largest;
    around.push_back({patch, Vec3::Zero(), is_there ? std::optional(foot->normal) : std::nullopt});
    return around.back();
  }

  [[nodiscard]] bool are_one(const PatchAtPoint& a, const PatchAtPoint& b) const {
    return (*a.normal - *b.normal).norm() <= kSameDirection ||
           (table_.are_neighbours(a.patch, b.patch) && a.normal->dot(*b.normal) > kTangentCosine);
  }

  void unite_tangent(std::vector<PatchAtPoint>& around) const {
    for (std::size_t i = 0; i < around.size(); ++i) {
      PatchAtPoint& own = around[i];
      own.one = i;
      if (!own.normal) {
        continue;
      }
      if (own.normal->dot(own.facets) < 0) {
        own.normal = -*own.normal;
      }
      for (std::size_t j = 0; j < i; ++j) {
        if (around[j].normal && around[j].one != own.one && are_one(around[j], own)) {
          const auto [lesser, greater] = std::minmax(own.one, around[j].one);
          for (std::size_t k = 0; k <= i; ++k) {
            around[k].one = around[k].one == greater ? lesser : around[k].one;
          }
        }
      }
    }
    average(around);
  }

  // Where they are numbered by the first of each, which comes before the others.
  static void average(std::vector<PatchAtPoint>& around) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (around[i].one != i || !around[i].normal) {
        continue;
      }
      Vec3 sum = Vec3::Zero();
      std::size_t count = 0;
      for (const PatchAtPoint& other : around) {
        if (other.one == i) {
          sum += *other.normal;
          ++count;
        }
      }
      for (PatchAtPoint& other : around) {
        if (count > 1 && other.one == i) {
          other.normal = sum.normalized();
        }
      }
    }
  }

  // The surface's normal where it is that of the triangle, too, more or less.
  [[nodiscard]] Direction chosen(const Vec3& facet, const std::optional<Vec3>& normal) const {
    const double area = facet.norm();
    if (normal && !(normal->dot(facet) < bounds_.least_cosine * area)) {
      return direction(*normal);
    }
    return direction(area > 0 ? Vec3(facet / area) : Vec3(Vec3::UnitZ()));
  }

  const PatchTable& table_;
  const TriMesh& mesh_;
  const MeshBounds& bounds_;
  std::vector<Candidates> candidates_;        // by label
  std::vector<Vec3> facets_;                  // by triangle
  std::vector<std::uint32_t> patch_of_;       // by triangle
  std::vector<std::size_t> begin_, corners_;  // by point
  CornerNormals result_;
};

}  // namespace

CornerNormals vertex_normals(const PatchTable& table, const TriMesh& mesh,
                             const MeshBounds& bounds) {
  return Shader(table, mesh, bounds).run();
}

}  // namespace dupin::shading
