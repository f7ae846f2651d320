#include "extract.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <tbb/parallel_for.h>

#include "key_numbering.h"
#include "umbrellas.h"

namespace dupin::detail {
namespace {

struct NearestDouble {
  double value;
  bool is_exact;
};

// One step of Newton's iteration from the quotient of doubles, checked: the remainder tells how far
// the quotient is from the next double. Only near a tie, or outside of normal doubles, the slow way
// is taken.
NearestDouble nearest(const CGAL::Mpzf& x, const CGAL::Mpzf& w) {
  const auto slowly = [&] {
    const double value = nearest_double(x, w);
    return NearestDouble{value, std::isfinite(value) && CGAL::Mpzf(value) * w == x};
  };
  const double weight = w.to_double();
  double value = x.to_double() / weight;
  if (!std::isfinite(value)) {
    return slowly();
  }
  CGAL::Mpzf remainder = x - CGAL::Mpzf(value) * w;
  if (!remainder.is_zero()) {
    const double better = value + remainder.to_double() / weight;
    if (better != value) {
      value = better;
      remainder = x - CGAL::Mpzf(value) * w;
    }
  }
  if (remainder.is_zero()) {
    return {value, true};
  }
  const double error = remainder.to_double() / weight;
  const double next = std::nextafter(value, error > 0 ? HUGE_VAL : -HUGE_VAL);
  // Conversions and the division are off by less than 2^-50 of the error.
  const double half = std::abs(next - value) / 2 * (1 - 0x1p-48);
  if (std::isnormal(value) && std::isnormal(error) && std::abs(error) < half) {
    return {value, false};
  }
  return slowly();
}

// The point as doubles if they hold it, and the nearest ones.
struct RoundedPoint {
  Vec3 point = Vec3::Zero();
  bool is_exact = true;
};

RoundedPoint rounded(const ExactPoint& exact) {
  RoundedPoint result;
  for (int k = 0; k < 3; ++k) {
    const NearestDouble coordinate = nearest(exact[static_cast<std::size_t>(k)], exact[3]);
    result.point[k] = coordinate.value;
    result.is_exact = result.is_exact && coordinate.is_exact;
  }
  return result;
}

// Numbers the points in use, those that doubles hold first.
class PointWriter {
 public:
  PointWriter(const Scene& scene, const Umbrellas& umbrellas, const std::vector<Kept>& kept,
              ExactMesh& mesh)
      : scene_(scene), umbrellas_(umbrellas) {
    number_.assign(umbrellas.first_copy + umbrellas.copies.size(), kNone);
    for (const Kept& k : kept) {
      for (const PointId id : k.corners) {
        number_[id] = 0;
      }
    }
    const std::vector<RoundedPoint> nearest = evaluate(mesh.implicit);
    write_doubles(nearest, mesh);
    write_others(nearest, mesh);
  }
  [[nodiscard]] std::uint32_t number(PointId id) const { return number_[id]; }

 private:
  [[nodiscard]] PointId original(PointId id) const {
    return id < umbrellas_.first_copy ? id : umbrellas_.copies[id - umbrellas_.first_copy];
  }
  std::vector<RoundedPoint> evaluate(std::vector<ExactPoint>& exact) {
    for (PointId id = 0; id < number_.size(); ++id) {
      if (number_[id] == 0 && !scene_.points.is_double(original(id))) {
        implicit_.push_back(id);
      }
    }
    std::vector<RoundedPoint> nearest(implicit_.size());
    exact.resize(implicit_.size());
    tbb::parallel_for(std::size_t{0}, implicit_.size(), [&](std::size_t i) {
      exact[i] = scene_.points.exact_value(original(implicit_[i]));
      nearest[i] = rounded(exact[i]);
    });
    return nearest;
  }
  void write(PointId id, const Vec3& point, ExactMesh& mesh) {
    number_[id] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(point);
  }
  void write_doubles(const std::vector<RoundedPoint>& nearest, ExactMesh& mesh) {
    std::size_t next = 0;
    for (PointId id = 0; id < number_.size(); ++id) {
      if (next < implicit_.size() && implicit_[next] == id) {
        if (nearest[next].is_exact) {
          write(id, nearest[next].point, mesh);
        }
        ++next;
      } else if (number_[id] == 0) {
        write(id, scene_.points.coordinates(original(id)), mesh);
      }
    }
  }
  void write_others(const std::vector<RoundedPoint>& nearest, ExactMesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < implicit_.size(); ++i) {
      if (!nearest[i].is_exact) {
        write(implicit_[i], nearest[i].point, mesh);
        if (kept != i) {
          mesh.implicit[kept] = std::move(mesh.implicit[i]);
        }
        ++kept;
      }
    }
    mesh.implicit.resize(kept);
  }

  const Scene& scene_;
  const Umbrellas& umbrellas_;
  std::vector<std::uint32_t> number_;
  std::vector<PointId> implicit_;  // points in use that are no doubles, ascending
};

// The operands' names in one list, and each operand's labels as indices into it.
class Labels {
 public:
  Labels(const Scene& scene, ExactMesh& mesh) : scene_(scene) {
    for (const ExactMesh* operand : scene.operands) {
      std::vector<std::uint32_t>& map = maps_.emplace_back();
      any_ = any_ || !operand->labels.empty();
      for (const std::string& name : operand->names) {
        map.push_back(index(name, mesh.names));
      }
    }
    if (any_) {
      for (std::size_t o = 0; o < scene.operands.size(); ++o) {
        unlabelled_.push_back(scene.operands[o]->labels.empty() ? index("", mesh.names) : kNone);
      }
    }
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] std::uint32_t label(const Source& source) const {
    const ExactMesh& operand = *scene_.operands[source.operand];
    return operand.labels.empty() ? unlabelled_[source.operand]
                                  : maps_[source.operand][operand.labels[source.triangle]];
  }

 private:
  std::uint32_t index(const std::string& name, std::vector<std::string>& names) {
    const auto [place, is_new] = known_.emplace(name, static_cast<std::uint32_t>(names.size()));
    if (is_new) {
      names.push_back(name);
    }
    return place->second;
  }

  const Scene& scene_;
  bool any_ = false;
  std::map<std::string, std::uint32_t> known_;
  std::vector<std::vector<std::uint32_t>> maps_;
  std::vector<std::uint32_t> unlabelled_;
};

// Keeps the planes of triangles with implicit corners.
class PlaneWriter {
 public:
  PlaneWriter(const Scene& scene, ExactMesh& mesh) : scene_(scene), mesh_(mesh) {}

  void add(const Kept& kept, const Triangle& corners) {
    const std::uint32_t first_implicit = mesh_.double_count();
    const bool is_own = std::all_of(corners.begin(), corners.end(),
                                    [&](std::uint32_t c) { return c < first_implicit; });
    const Triangle& support = scene_.support(kept.support);
    const bool is_known = std::all_of(support.begin(), support.end(),
                                      [&](PointId id) { return scene_.points.is_double(id); });
    if (is_own || !is_known) {
      mesh_.plane_of.push_back(ExactMesh::kOwnPlane);
      return;
    }
    const std::uint32_t number = known_.number({std::uint64_t{support[0]} << 32 | support[1],
                                                std::uint64_t{support[2]} << 1 | kept.reversed});
    if (number == mesh_.planes.size()) {
      std::array<Vec3, 3> plane;
      for (std::size_t i = 0; i < 3; ++i) {
        plane[i] = scene_.points.coordinates(support[i]);
      }
      if (kept.reversed) {
        std::swap(plane[1], plane[2]);
      }
      mesh_.planes.push_back(plane);
    }
    mesh_.plane_of.push_back(number);
  }

 private:
  const Scene& scene_;
  ExactMesh& mesh_;
  KeyNumbering known_{0};
};

void write_contacts(const Umbrellas& umbrellas, const PointWriter& points, ExactMesh& mesh) {
  for (const Touch& touch : umbrellas.touches) {
    const bool is_vertex = touch.from == touch.to;
    std::set<std::string> names;
    for (const std::uint32_t face : touch.faces) {
      if (!mesh.labels.empty()) {
        names.insert(mesh.names[mesh.labels[face]]);
      }
    }
    mesh.contacts.push_back({is_vertex ? Contact::Kind::vertex : Contact::Kind::edge,
                             mesh.points[points.number(touch.from)],
                             mesh.points[points.number(touch.to)],
                             {names.begin(), names.end()}});
  }
}

}  // namespace

std::vector<Kept> collect(const Scene& scene, const Incidences& incidences, const Pieces& pieces,
                          const Patches& patches, const std::vector<std::int8_t>& selection) {
  std::vector<Kept> kept;
  const auto add = [&kept](Triangle corners, std::uint32_t support, bool reversed,
                           std::uint32_t source) {
    if (reversed) {
      std::swap(corners[1], corners[2]);
    }
    kept.push_back({corners, support, reversed, source});
  };
  // The source agrees in orientation where there is a choice.
  const auto source = [](std::span<const SignedTriangle> cover, int selected) {
    const auto agrees = [selected](const SignedTriangle& t) { return t.sign == selected; };
    const auto place = std::find_if(cover.begin(), cover.end(), agrees);
    return place != cover.end() ? place->triangle : cover.front().triangle;
  };
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    if (incidences.touched[t] || scene.merged[t]) {
      continue;
    }
    const std::int8_t selected = selection[patches.of_triangle(t)];
    if (selected != 0) {
      add(scene.triangles[t], t, selected < 0, source(scene.cover(t), selected));
    }
  }
  for (const Pieces::Piece& piece : pieces.pieces) {
    const std::int8_t selected = selection[patches.of_region(piece.region)];
    if (selected != 0) {
      add(piece.corners, pieces.regions[piece.region].support, selected < 0,
          source(pieces.cover(piece.region), selected));
    }
  }
  return kept;
}

ExactMesh extract(Scene& scene, std::vector<Kept> kept) {
  const Umbrellas umbrellas = [&] {
    const UpwardRounding rounding;
    return separate_umbrellas(scene, kept);
  }();
  ExactMesh mesh;
  const PointWriter points(scene, umbrellas, kept, mesh);
  const Labels labels(scene, mesh);
  PlaneWriter planes(scene, mesh);
  mesh.triangles.reserve(kept.size());
  mesh.sources.reserve(kept.size());
  for (const Kept& k : kept) {
    mesh.triangles.push_back(
        {points.number(k.corners[0]), points.number(k.corners[1]), points.number(k.corners[2])});
    if (!mesh.implicit.empty()) {
      planes.add(k, mesh.triangles.back());
    }
    const std::uint32_t operand = scene.operand_of(k.source);
    mesh.sources.push_back({operand, k.source - scene.first_triangle[operand]});
    if (labels.any()) {
      mesh.labels.push_back(labels.label(mesh.sources.back()));
    }
  }
  write_contacts(umbrellas, points, mesh);
  return mesh;
}

}  // namespace dupin::detail
