#pragma once

#include <cstring>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "dupin/kernel/tiled_check.h"
#include "kernel/torus.h"
#include "support/shapes.h"

namespace dupin::test {

/// Facets that are held.
class HeldFacets : public FacetSource {
 public:
  explicit HeldFacets(std::vector<Facet> facets) : facets_(std::move(facets)) {}
  [[nodiscard]] std::uint32_t count() const override {
    return static_cast<std::uint32_t>(facets_.size());
  }
  void visit(const std::function<void(std::span<const Facet>)>& visit) const override {
    const std::span<const Facet> all(facets_);
    for (std::size_t i = 0; i < all.size(); i += 7) {
      visit(all.subspan(i, std::min<std::size_t>(7, all.size() - i)));
    }
  }

 private:
  std::vector<Facet> facets_;
};

class HeldScratch : public Scratch {
 public:
  void write(std::uint64_t at, std::span<const char> bytes) override {
    bytes_.resize(std::max<std::size_t>(bytes_.size(), at + bytes.size()));
    std::memcpy(bytes_.data() + at, bytes.data(), bytes.size());
  }
  void read(std::uint64_t at, std::span<char> bytes) const override {
    std::memcpy(bytes.data(), std::span(bytes_).subspan(at, bytes.size()).data(), bytes.size());
  }

 private:
  std::vector<char> bytes_;
};

inline void append_facets(const TriMesh& mesh, std::vector<Facet>& facets) {
  for (const Triangle& triangle : mesh.triangles) {
    Facet& facet = facets.emplace_back();
    for (std::size_t k = 0; k < 9; ++k) {
      facet[k] =
          static_cast<float>(mesh.points[triangle[k / 3]][static_cast<Eigen::Index>(k % 3)] + 0.0);
    }
  }
}

/// The mesh that readers make of facets.
inline TriMesh welded_mesh(const std::vector<Facet>& facets) {
  TriMesh mesh;
  std::map<std::tuple<float, float, float>, std::uint32_t> known;
  for (const Facet& facet : facets) {
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::tuple place(facet[3 * k], facet[3 * k + 1], facet[3 * k + 2]);
      const auto [at, is_new] =
          known.emplace(place, static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) {
        mesh.points.emplace_back(facet[3 * k], facet[3 * k + 1], facet[3 * k + 2]);
      }
      triangle[k] = at->second;
    }
  }
  return mesh;
}

/// Boxes, tetrahedra, tubes and tori on a small grid, which cross, touch, nest, coincide and are
/// inside out; with the chance `damage` each facet is left out, doubled, turned, made degenerate or
/// moved away, and the facets are shuffled.
inline std::vector<Facet> facet_scene(unsigned seed, double damage) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  const auto is_so = [&](double chance) { return double(random()) < chance * 4294967296.0; };
  std::vector<Facet> whole, facets;
  const int solids = 1 + below(12), spread = 3 + below(30);
  for (int i = 0; i < solids; ++i) {
    const Vec3 low(below(spread), below(spread), below(4));
    const int size = 1 + below(5);
    TriMesh mesh = below(3) == 0   ? tetrahedron(low, size)
                   : below(3) == 0 ? moved(tube(size, 0, 3, 5 + below(9)), low)
                   : below(5) == 0 ? moved(torus(6, 9, 2, 1), low)
                                   : box(low, low + Vec3(size, 1 + below(4), 1 + below(4)));
    mesh = below(7) == 0 ? reversed(mesh) : mesh;
    append_facets(mesh, whole);
    if (below(3) == 0) {
      append_facets(reversed(box(low + Vec3::Constant(0.25), low + Vec3::Constant(0.5))), whole);
    }
  }
  for (const Facet& facet : whole) {
    facets.push_back(facet);
    if (!is_so(damage)) {
      continue;
    }
    Facet& last = facets.back();
    switch (below(6)) {
      case 0:
        facets.pop_back();
        break;
      case 1:
        facets.push_back(Facet(last));
        break;
      case 2:
        std::swap_ranges(last.begin(), last.begin() + 3, last.begin() + 3);
        break;
      case 3:
        std::copy_n(last.begin(), 3, last.begin() + 6);
        break;
      case 4:
        for (std::size_t k = 0; k < 3; ++k) {
          last[6 + k] = 2 * last[3 + k] - last[k];
        }
        break;
      default:
        last[static_cast<std::size_t>(below(9))] += 1;
    }
  }
  if (below(2) == 0) {
    std::shuffle(facets.begin(), facets.end(), random);
  }
  return facets;
}

}  // namespace dupin::test
