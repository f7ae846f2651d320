#include "extract.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>

#include <tbb/parallel_invoke.h>

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
  PointWriter(const Scene& scene, const Umbrellas& umbrellas, const BulkVector<Kept>& kept,
              ExactMesh& mesh)
      : scene_(scene),
        umbrellas_(umbrellas),
        number_(umbrellas.first_copy + umbrellas.copies.size(), kNone) {
    for_each_block(kept.size(), [&](const Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        for (const PointId id : kept[i].corners) {
          std::atomic_ref(number_[id]).store(0, std::memory_order_relaxed);
        }
      }
    });
    std::vector<RoundedPoint> nearest = evaluate(mesh.implicit);
    write_doubles(nearest, mesh);
    write_others(nearest, mesh);
  }
  [[nodiscard]] std::uint32_t number(PointId id) const { return number_[id]; }

 private:
  [[nodiscard]] PointId original(PointId id) const {
    return id < umbrellas_.first_copy ? id : umbrellas_.copies[id - umbrellas_.first_copy];
  }
  std::vector<RoundedPoint> evaluate(std::vector<ExactPoint>& exact) {
    const PointId first = scene_.points.double_count();
    implicit_ = collect_in_order<PointId>(
        number_.size() - first, [&](std::size_t i, std::vector<PointId>& found) {
          const auto id = static_cast<PointId>(first + i);
          if (number_[id] == 0 && !scene_.points.is_double(original(id))) {
            found.push_back(id);
          }
        });
    std::vector<RoundedPoint> nearest(implicit_.size());
    resize_bulk(exact, implicit_.size());
    for_each_in_parallel(implicit_.size(), [&](std::size_t i) {
      exact[i] = scene_.points.exact_value(original(implicit_[i]));
      nearest[i] = rounded(exact[i]);
    });
    return nearest;
  }
  void write_doubles(const std::vector<RoundedPoint>& nearest, ExactMesh& mesh) {
    for (std::size_t i = 0; i < implicit_.size(); ++i) {
      number_[implicit_[i]] = nearest[i].is_exact ? 0 : kNone;
    }
    const Ranking doubles(number_.size(), [this](std::size_t id) { return number_[id] == 0; });
    reserve_bulk(mesh.points, doubles.size() + implicit_.size());
    mesh.points.resize(doubles.size());
    doubles.for_each([&](std::size_t i, std::size_t number) {
      const auto id = static_cast<PointId>(i);
      if (const PointId original_id = original(id); scene_.points.is_double(original_id)) {
        mesh.points[number] = scene_.points.coordinates(original_id);
      } else {
        const auto place = std::lower_bound(implicit_.begin(), implicit_.end(), id);
        mesh.points[number] = nearest[static_cast<std::size_t>(place - implicit_.begin())].point;
      }
      number_[id] = static_cast<std::uint32_t>(number);
    });
  }
  // Holes that points leave which doubles hold are filled from the end.
  void write_others(std::vector<RoundedPoint>& nearest, ExactMesh& mesh) {
    std::size_t kept = implicit_.size();
    for (std::size_t i = 0; i < kept;) {
      if (!nearest[i].is_exact) {
        ++i;
      } else if (i != --kept) {
        mesh.implicit[i] = std::move(mesh.implicit[kept]);
        nearest[i] = nearest[kept];
        implicit_[i] = implicit_[kept];
      }
    }
    mesh.implicit.resize(kept);
    const std::size_t doubles = mesh.points.size();
    mesh.points.resize(doubles + kept);
    for_each_block(kept, [&](const Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        number_[implicit_[i]] = static_cast<std::uint32_t>(doubles + i);
        mesh.points[doubles + i] = nearest[i].point;
      }
    });
  }

  const Scene& scene_;
  const Umbrellas& umbrellas_;
  BulkVector<std::uint32_t> number_;
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
void write_planes(const Scene& scene, const BulkVector<Kept>& kept, ExactMesh& mesh) {
  if (mesh.implicit.empty()) {
    return;
  }
  resize_bulk(mesh.plane_of, kept.size());
  const auto collect = [&, first_implicit = mesh.double_count()](
                           std::size_t i, std::vector<std::uint32_t>& found) {
    mesh.plane_of[i] = ExactMesh::kOwnPlane;
    const Triangle &corners = mesh.triangles[i], &support = scene.support(kept[i].support);
    const auto is_implicit = [&](std::uint32_t c) { return c >= first_implicit; };
    const auto is_known = [&](PointId id) { return scene.points.is_double(id); };
    if (std::any_of(corners.begin(), corners.end(), is_implicit) &&
        std::all_of(support.begin(), support.end(), is_known)) {
      found.push_back(static_cast<std::uint32_t>(i));
    }
  };
  const auto with_planes = collect_in_order<std::uint32_t>(kept.size(), collect);
  KeyNumbering known(0);
  std::uint32_t previous = with_planes.empty() ? 0 : with_planes.front();
  for (const std::uint32_t i : with_planes) {
    const bool reversed = kept[i].reversed;
    // Pieces of one triangle follow one another.
    if (i != previous && kept[i].support == kept[previous].support &&
        reversed == kept[previous].reversed) {
      mesh.plane_of[i] = mesh.plane_of[previous];
      continue;
    }
    previous = i;
    const Triangle& support = scene.support(kept[i].support);
    mesh.plane_of[i] = known.number({std::uint64_t{support[0]} << 32 | support[1],
                                     std::uint64_t{support[2]} << 1 | std::uint64_t{reversed}});
    if (mesh.plane_of[i] == mesh.planes.size()) {
      const std::size_t second = reversed ? 2 : 1, third = reversed ? 1 : 2;
      mesh.planes.push_back({scene.points.coordinates(support[0]),
                             scene.points.coordinates(support[second]),
                             scene.points.coordinates(support[third])});
    }
  }
}

// Whose a triangle is, quick for triangles in order.
class OperandOf {
 public:
  explicit OperandOf(const Scene& scene) : scene_(scene) {}
  [[nodiscard]] std::uint32_t operator()(std::uint32_t t) {
    if (t < scene_.first_triangle[last_] || t >= scene_.first_triangle[last_ + 1]) {
      last_ = scene_.operand_of(t);
    }
    return last_;
  }

 private:
  const Scene& scene_;
  std::uint32_t last_ = 0;
};

void write_triangles(const Scene& scene, const BulkVector<Kept>& kept, const PointWriter& points,
                     const Labels& labels, ExactMesh& mesh) {
  tbb::parallel_invoke([&] { resize_bulk(mesh.triangles, kept.size()); },
                       [&] { resize_bulk(mesh.sources, kept.size()); },
                       [&] { resize_bulk(mesh.labels, labels.any() ? kept.size() : 0); });
  for_each_block(kept.size(), [&](const Block& block) {
    OperandOf operand_of(scene);
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Kept& k = kept[i];
      mesh.triangles[i] = {points.number(k.corners[0]), points.number(k.corners[1]),
                           points.number(k.corners[2])};
      const std::uint32_t operand = operand_of(k.source);
      mesh.sources[i] = {operand, k.source - scene.first_triangle[operand]};
      if (labels.any()) {
        mesh.labels[i] = labels.label(mesh.sources[i]);
      }
    }
  });
}

bool same_corners(const Triangle& a, Triangle b, bool reversed) {
  if (reversed) {
    std::swap(b[1], b[2]);
  }
  return a == b;
}

// Triangles left whole stay in the classes that their operands have them in. Not so at contacts,
// where points have copies.
void write_steady_classes(const Scene& scene, const BulkVector<Kept>& kept, ExactMesh& mesh) {
  std::vector<std::uint32_t> first_class;
  for (const ExactMesh* operand : scene.operands) {
    const auto& classes = operand->steady.classes;
    first_class.push_back(static_cast<std::uint32_t>(mesh.steady.classes.size()));
    mesh.steady.classes.insert(mesh.steady.classes.end(), classes.begin(), classes.end());
  }
  if (mesh.steady.classes.empty() || !mesh.contacts.empty()) {
    mesh.steady = {};
    return;
  }
  resize_bulk(mesh.steady.of_triangle, kept.size());
  for_each_block(kept.size(), [&](const Block& block) {
    OperandOf operand_of(scene);
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto& [corners, t, reversed, source] = kept[i];
      const std::uint32_t operand = operand_of(t);
      const std::vector<std::uint32_t>& classes = scene.operands[operand]->steady.of_triangle;
      const bool is_whole = same_corners(corners, scene.triangles[t], reversed);
      const std::uint32_t own = is_whole && !classes.empty()
                                    ? classes[t - scene.first_triangle[operand]]
                                    : SteadyClasses::kNone;
      mesh.steady.of_triangle[i] = own == SteadyClasses::kNone ? own : first_class[operand] + own;
    }
  });
}

// The source agrees in orientation where there is a choice.
std::uint32_t source_of(std::span<const SignedTriangle> cover, int selected) {
  const auto agrees = [selected](const SignedTriangle& t) { return t.sign == selected; };
  const auto place = std::find_if(cover.begin(), cover.end(), agrees);
  return place != cover.end() ? place->triangle : cover.front().triangle;
}

Kept kept_face(Triangle corners, std::uint32_t support, int selected, std::uint32_t source) {
  if (selected < 0) {
    std::swap(corners[1], corners[2]);
  }
  return {corners, support, selected < 0, source};
}

Kept kept_triangle(const Scene& scene, std::uint32_t t, int selected) {
  const std::uint32_t source = selected < 0 ? source_of(scene.cover(t), selected) : t;
  return kept_face(scene.triangles[t], t, selected, source);
}

Kept kept_piece(const Pieces& pieces, std::uint32_t p, int selected) {
  const Pieces::Piece& piece = pieces.pieces[p];
  return kept_face(piece.corners, pieces.regions[piece.region].support, selected,
                   source_of(pieces.cover(piece.region), selected));
}

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

BulkVector<Kept> collect(const Scene& scene, const Incidences& incidences, const Pieces& pieces,
                         const Patches& patches, const std::vector<std::int8_t>& selection) {
  const auto count = static_cast<std::uint32_t>(scene.triangles.size());
  BulkVector<std::int8_t> selected(count + pieces.pieces.size());
  for_each_block(selected.size(), [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto t = static_cast<std::uint32_t>(i);
      if (t >= count) {
        selected[i] = selection[patches.of_region(pieces.pieces[t - count].region)];
      } else {
        selected[i] = incidences.touched[t] || scene.merged[t] ? std::int8_t{0}
                                                               : selection[patches.of_triangle(t)];
      }
    }
  });
  const Ranking ranking(selected.size(), [&](std::size_t i) { return selected[i] != 0; });
  BulkVector<Kept> kept(ranking.size());
  ranking.for_each([&](std::size_t i, std::size_t rank) {
    const auto t = static_cast<std::uint32_t>(i);
    kept[rank] = t < count ? kept_triangle(scene, t, selected[i])
                           : kept_piece(pieces, t - count, selected[i]);
  });
  return kept;
}

ExactMesh extract(Scene& scene, BulkVector<Kept> kept) {
  const Umbrellas umbrellas = [&] {
    const UpwardRounding rounding;
    return separate_umbrellas(scene, kept);
  }();
  ExactMesh mesh;
  const PointWriter points(scene, umbrellas, kept, mesh);
  const Labels labels(scene, mesh);
  write_triangles(scene, kept, points, labels, mesh);
  write_planes(scene, kept, mesh);
  write_contacts(umbrellas, points, mesh);
  write_steady_classes(scene, kept, mesh);
  return mesh;
}

}  // namespace dupin::detail
