#include "arrangement/output_mesh.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include <tbb/parallel_invoke.h>

#include "arrangement/non_manifold_vertices.h"
#include "support/key_numbering.h"

namespace dupin::arrangement {
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
    const double value = mesh::nearest_double(x, w);
    return NearestDouble{value, std::isfinite(value) && CGAL::Mpzf(value) * w == x};
  };
  constexpr double kLeast = 0x1p-900;  // of what is divided; conversions of less lose digits
  const double weight = w.to_double();
  double value = x.to_double() / weight;
  if (!std::isfinite(value) || weight < kLeast) {
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
  const double rest = remainder.to_double(), error = rest / weight;
  const double next = std::nextafter(value, error > 0 ? HUGE_VAL : -HUGE_VAL);
  // Conversions and the division are off by less than 2^-50 of the error.
  const double half = std::abs(next - value) / 2 * (1 - 0x1p-48);
  if (std::isnormal(value) && std::isnormal(error) && std::abs(rest) >= kLeast &&
      std::abs(error) < half) {
    return {value, false};
  }
  return slowly();
}

// The double nearest to the number in the ball, and whether it may be that number; none where the
// ball does not tell. Needs UpwardRounding.
//
// Lemma: `high` less one of its neighbours is a double, and so are halves of gaps, far from the
// least doubles. The number is no further from `value` than from `least` to `most`: if that is
// within half of the gaps beside it, no other double is as near, and if it leaves zero out, `value`
// is not the number.
std::optional<NearestDouble> nearest(const exact::Ball& ball) {
  const bool is_negative = ball.high() < 0;
  const exact::Ball size = is_negative ? -ball : ball;
  double value = size.high();
  if (!(value > 0x1p-900 && value < 0x1p900)) {
    return std::nullopt;
  }
  const auto neighbour = [](double of, int step) {
    return std::bit_cast<double>(std::bit_cast<std::int64_t>(of) + step);
  };
  if (2 * size.low() > neighbour(value, 1) - value) {
    value = neighbour(value, 1);
  } else if (-2 * size.low() > value - neighbour(value, -1)) {
    value = neighbour(value, -1);
  }
  const double shift = size.high() - value;
  const double most = shift + (size.low() + size.radius());
  const double least = -((size.radius() - size.low()) - shift);
  if (!(2 * most < neighbour(value, 1) - value && -2 * least < value - neighbour(value, -1))) {
    return std::nullopt;
  }
  return NearestDouble{is_negative ? -value : value, least <= 0 && most >= 0};
}

// The point as doubles if they hold it, and the nearest ones.
struct RoundedPoint {
  Vec3 point = Vec3::Zero();
  bool is_exact = true;
};

// The same of a point that certainly no doubles hold; none where balls do not tell. Needs
// UpwardRounding.
std::optional<RoundedPoint> rounded(const exact::BallPoint& balls) {
  RoundedPoint result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto coordinate = nearest(balls[k]);
    if (!coordinate) {
      return std::nullopt;
    }
    result.point[static_cast<Eigen::Index>(k)] = coordinate->value;
    result.is_exact = result.is_exact && coordinate->is_exact;
  }
  return result.is_exact ? std::nullopt : std::optional(result);
}

RoundedPoint rounded(const mesh::ExactPoint& exact) {
  RoundedPoint result;
  for (int k = 0; k < 3; ++k) {
    const NearestDouble coordinate = nearest(exact[static_cast<std::size_t>(k)], exact[3]);
    result.point[k] = coordinate.value;
    result.is_exact = result.is_exact && coordinate.is_exact;
  }
  return result;
}

// The same of a point whose nearest doubles are known.
RoundedPoint rounded(const mesh::ExactPoint& exact, const Vec3& nearest) {
  RoundedPoint result{nearest, true};
  for (std::size_t k = 0; k < 3 && result.is_exact; ++k) {
    const double coordinate = nearest[static_cast<Eigen::Index>(k)];
    result.is_exact = std::isfinite(coordinate) && CGAL::Mpzf(coordinate) * exact[3] == exact[k];
  }
  return result;
}

// Numbers the points in use, those that doubles hold first.
class PointWriter {
 public:
  PointWriter(const ArrangementInput& input, const VertexDuplicates& duplicates,
              const support::BulkVector<OutputTriangle>& kept, mesh::ExactMesh& mesh)
      : input_(input),
        duplicates_(duplicates),
        number_(duplicates.first_copy + duplicates.copies.size(), kNone) {
    support::for_each_block(kept.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        for (const PointId id : kept[i].corners) {
          std::atomic_ref(number_[id]).store(0, std::memory_order_relaxed);
        }
      }
    });
    std::vector<RoundedPoint> nearest = evaluate();
    write_doubles(nearest, mesh);
    write_others(nearest, mesh);
  }
  [[nodiscard]] std::uint32_t number(PointId id) const { return number_[id]; }

 private:
  [[nodiscard]] PointId original(PointId id) const {
    return id < duplicates_.first_copy ? id : duplicates_.copies[id - duplicates_.first_copy];
  }
  // A point that an operand brought.
  struct Given {
    const mesh::ExactMesh& operand;
    std::size_t index;  // in operand.implicit

    [[nodiscard]] const Vec3& nearest() const {
      return operand.points[operand.double_count() + index];
    }
  };
  [[nodiscard]] bool is_given(PointId id) const { return id < input_.first_implicit.back(); }
  [[nodiscard]] Given given(PointId id) const {
    const std::uint32_t operand = input_.operand_of_point(id);
    return {*input_.operands[operand], id - input_.first_implicit[operand]};
  }
  [[nodiscard]] bool is_meeting(PointId id) const {
    return is_given(id) ? given_meeting(id) != nullptr : input_.points.is_meeting(id);
  }
  [[nodiscard]] mesh::LinePlaneMeeting meeting(PointId id) const {
    return is_given(id) ? *given_meeting(id) : input_.points.meeting(id);
  }
  [[nodiscard]] const mesh::LinePlaneMeeting* given_meeting(PointId id) const {
    const auto [operand, index] = given(id);
    return operand.implicit.meeting(index);
  }
  std::vector<RoundedPoint> evaluate() {
    const PointId first = input_.points.double_count();
    implicit_ = support::collect_in_order<PointId>(
        number_.size() - first, [&](std::size_t i, std::vector<PointId>& found) {
          const auto id = static_cast<PointId>(first + i);
          if (number_[id] == 0 && !input_.points.is_double(original(id))) {
            found.push_back(id);
          }
        });
    std::vector<RoundedPoint> nearest(implicit_.size());
    constexpr std::size_t kPoints = 256;
    const auto round = [&](const support::Block& block) {
      std::vector<std::size_t> open;
      {
        const UpwardRounding rounding;
        for (std::size_t i = block.begin; i < block.end; ++i) {
          if (const auto certain = rounded_by_ball(original(implicit_[i]))) {
            nearest[i] = *certain;
          } else {
            open.push_back(i);
          }
        }
      }
      for (const std::size_t i : open) {
        nearest[i] = rounded_exactly(original(implicit_[i]));
      }
    };
    support::for_each_block(implicit_.size(), round, kPoints);
    return nearest;
  }
  // What balls tell of most points, by numbers that are kept for no other use.
  [[nodiscard]] std::optional<RoundedPoint> rounded_by_ball(PointId id) const {
    return is_given(id) || !input_.points.is_meeting(id)
               ? std::nullopt
               : rounded(evaluate_ball(input_.points, input_.points.definition(id)));
  }
  [[nodiscard]] RoundedPoint rounded_exactly(PointId id) const {
    mesh::ExactPoint value;
    const mesh::ExactPoint& exact =
        is_meeting(id) ? (value = input_.points.exact_value(id)) : input_.points.exact(id, value);
    return is_given(id) ? rounded(exact, given(id).nearest()) : rounded(exact);
  }
  void write_doubles(const std::vector<RoundedPoint>& nearest, mesh::ExactMesh& mesh) {
    for (std::size_t i = 0; i < implicit_.size(); ++i) {
      number_[implicit_[i]] = nearest[i].is_exact ? 0 : kNone;
    }
    const support::Ranking doubles(number_.size(),
                                   [this](std::size_t id) { return number_[id] == 0; });
    support::reserve_bulk(mesh.points, doubles.size() + implicit_.size());
    mesh.points.resize(doubles.size());
    doubles.for_each([&](std::size_t i, std::size_t number) {
      const auto id = static_cast<PointId>(i);
      if (const PointId original_id = original(id); input_.points.is_double(original_id)) {
        mesh.points[number] = input_.points.coordinates(original_id);
      } else {
        const auto at = std::lower_bound(implicit_.begin(), implicit_.end(), id);
        mesh.points[number] = nearest[static_cast<std::size_t>(at - implicit_.begin())].point;
      }
      number_[id] = static_cast<std::uint32_t>(number);
    });
  }
  void write_others(const std::vector<RoundedPoint>& nearest, mesh::ExactMesh& mesh) {
    // Holes that points leave which doubles hold are filled from the end.
    std::vector<std::uint32_t> kept(implicit_.size());
    std::iota(kept.begin(), kept.end(), 0);
    for (std::size_t i = 0; i < kept.size();) {
      if (nearest[kept[i]].is_exact) {
        kept[i] = kept.back();
        kept.pop_back();
      } else {
        ++i;
      }
    }
    const auto id = [&](std::size_t i) { return original(implicit_[kept[i]]); };
    mesh.implicit = mesh::ExactPoints(
        kept.size(), [&](std::size_t i) { return is_meeting(id(i)); },
        [&](std::size_t i) { return meeting(id(i)); },
        [&](std::size_t i) { return input_.points.exact_value(id(i)); });
    const std::size_t doubles = mesh.points.size();
    mesh.points.resize(doubles + kept.size());
    support::for_each_block(kept.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        number_[implicit_[kept[i]]] = static_cast<std::uint32_t>(doubles + i);
        mesh.points[doubles + i] = nearest[kept[i]].point;
      }
    });
  }

  const ArrangementInput& input_;
  const VertexDuplicates& duplicates_;
  support::BulkVector<std::uint32_t> number_;
  std::vector<PointId> implicit_;  // points in use that are no doubles, ascending
};

// The operands' names in one list, and each operand's labels as indices into it.
class Labels {
 public:
  Labels(const ArrangementInput& input, mesh::ExactMesh& mesh) : input_(input) {
    for (const mesh::ExactMesh* operand : input.operands) {
      std::vector<std::uint32_t>& map = maps_.emplace_back();
      any_ = any_ || !operand->labels.empty();
      for (const std::string& name : operand->names) {
        map.push_back(index(name, mesh.names));
      }
    }
    if (any_) {
      for (std::size_t o = 0; o < input.operands.size(); ++o) {
        unlabelled_.push_back(input.operands[o]->labels.empty() ? index("", mesh.names) : kNone);
      }
    }
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] std::uint32_t label(const Source& source) const {
    const mesh::ExactMesh& operand = *input_.operands[source.operand];
    return operand.labels.empty() ? unlabelled_[source.operand]
                                  : maps_[source.operand][operand.labels[source.triangle]];
  }

 private:
  std::uint32_t index(const std::string& name, std::vector<std::string>& names) {
    const auto [entry, is_new] = known_.emplace(name, static_cast<std::uint32_t>(names.size()));
    if (is_new) {
      names.push_back(name);
    }
    return entry->second;
  }

  const ArrangementInput& input_;
  bool any_ = false;
  std::map<std::string, std::uint32_t> known_;
  std::vector<std::vector<std::uint32_t>> maps_;
  std::vector<std::uint32_t> unlabelled_;
};

// Whose a triangle is, quick for triangles in order.
class OperandOf {
 public:
  explicit OperandOf(const ArrangementInput& input) : input_(input) {}
  [[nodiscard]] std::uint32_t operator()(std::uint32_t t) {
    if (t < input_.first_triangle[last_] || t >= input_.first_triangle[last_ + 1]) {
      last_ = input_.operand_of(t);
    }
    return last_;
  }

 private:
  const ArrangementInput& input_;
  std::uint32_t last_ = 0;
};

// One by one: a call for so few bytes takes longer, and this is asked of all that is kept.
bool same_corners(const Triangle& a, const Triangle& b, bool reversed) {
  return a[0] == b[0] && a[1] == b[reversed ? 2 : 1] && a[2] == b[reversed ? 1 : 2];
}

// Triangles left whole stay in the classes that their operands have them in. Not so at contacts,
// where points have copies.
class StableClasses {
 public:
  StableClasses(const ArrangementInput& input, bool has_contacts, mesh::ExactMesh& mesh)
      : input_(input) {
    auto& all = mesh.stable.classes;
    for (const mesh::ExactMesh* operand : input.operands) {
      const auto& own = operand->stable.classes;
      first_.push_back(static_cast<std::uint32_t>(all.size()));
      if (!has_contacts) {
        all.insert(all.end(), own.begin(), own.end());
      }
    }
    any_ = !all.empty();
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] std::uint32_t of(const OutputTriangle& kept, std::uint32_t operand) const {
    const auto& own = input_.operands[operand]->stable.of_triangle;
    if (own.empty() || !same_corners(kept.corners, input_.triangles[kept.support], kept.reversed)) {
      return mesh::StableFaceGroups::kNone;
    }
    const std::uint32_t found = own[kept.support - input_.first_triangle[operand]];
    return found == mesh::StableFaceGroups::kNone ? found : first_[operand] + found;
  }

 private:
  const ArrangementInput& input_;
  std::vector<std::uint32_t> first_;  // of each operand, in the list of all
  bool any_ = false;
};

void write_triangles(const ArrangementInput& input, const support::BulkVector<OutputTriangle>& kept,
                     const PointWriter& points, const Labels& labels, const StableClasses& classes,
                     mesh::ExactMesh& mesh) {
  tbb::parallel_invoke(
      [&] { support::resize_bulk(mesh.triangles, kept.size()); },
      [&] { support::resize_bulk(mesh.sources, kept.size()); },
      [&] { support::resize_bulk(mesh.labels, labels.any() ? kept.size() : 0); },
      [&] { support::resize_bulk(mesh.stable.of_triangle, classes.any() ? kept.size() : 0); });
  support::for_each_block(kept.size(), [&](const support::Block& block) {
    OperandOf operand_of(input), operand_of_support(input);
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const OutputTriangle& k = kept[i];
      mesh.triangles[i] = {points.number(k.corners[0]), points.number(k.corners[1]),
                           points.number(k.corners[2])};
      const std::uint32_t operand = operand_of(k.source);
      mesh.sources[i] = {operand, k.source - input.first_triangle[operand]};
      if (labels.any()) {
        mesh.labels[i] = labels.label(mesh.sources[i]);
      }
      if (classes.any()) {
        mesh.stable.of_triangle[i] = classes.of(k, operand_of_support(k.support));
      }
    }
  });
}

// Keeps the planes of triangles with implicit corners.
void write_planes(const ArrangementInput& input, const support::BulkVector<OutputTriangle>& kept,
                  mesh::ExactMesh& mesh) {
  if (mesh.implicit.empty()) {
    return;
  }
  support::resize_bulk(mesh.plane_of, kept.size());
  const auto collect = [&, first_implicit = mesh.double_count()](
                           std::size_t i, std::vector<std::uint32_t>& found) {
    mesh.plane_of[i] = mesh::ExactMesh::kOwnPlane;
    const auto is_implicit = [&](std::uint32_t c) { return c >= first_implicit; };
    if (std::ranges::none_of(mesh.triangles[i], is_implicit)) {
      return;
    }
    const auto is_known = [&](PointId id) { return input.points.is_double(id); };
    if (std::ranges::all_of(input.support(kept[i].support), is_known)) {
      found.push_back(static_cast<std::uint32_t>(i));
    }
  };
  const auto with_planes = support::collect_in_order<std::uint32_t>(kept.size(), collect);
  // Sub-triangles of one triangle follow one another.
  const auto runs = support::ranges_of_equal(
      with_planes, [&](std::uint32_t i) { return std::pair(kept[i].support, kept[i].reversed); });
  support::KeyNumbering known(runs.size());
  for (const support::IndexRange& run : runs) {
    const std::uint32_t first = with_planes[run.begin];
    const bool reversed = kept[first].reversed;
    const Triangle& support = input.support(kept[first].support);
    mesh.plane_of[first] = known.number({std::uint64_t{support[0]} << 32 | support[1],
                                         std::uint64_t{support[2]} << 1 | std::uint64_t{reversed}});
    if (mesh.plane_of[first] == mesh.planes.size()) {
      const std::size_t second = reversed ? 2 : 1, third = reversed ? 1 : 2;
      mesh.planes.push_back({input.points.coordinates(support[0]),
                             input.points.coordinates(support[second]),
                             input.points.coordinates(support[third])});
    }
  }
  support::for_each_block(runs.size(), [&](const support::Block& block) {
    for (std::size_t r = block.begin; r < block.end; ++r) {
      for (std::uint32_t k = runs[r].begin + 1; k < runs[r].end; ++k) {
        mesh.plane_of[with_planes[k]] = mesh.plane_of[with_planes[runs[r].begin]];
      }
    }
  });
}

// The source agrees in orientation where there is a choice.
std::uint32_t source_of(std::span<const SignedTriangle> cover, int selected) {
  const auto agrees = [selected](const SignedTriangle& t) { return t.sign == selected; };
  const auto agreeing = std::find_if(cover.begin(), cover.end(), agrees);
  return agreeing != cover.end() ? agreeing->triangle : cover.front().triangle;
}

OutputTriangle kept_face(Triangle corners, std::uint32_t support, int selected,
                         std::uint32_t source) {
  if (selected < 0) {
    std::swap(corners[1], corners[2]);
  }
  return {corners, support, selected < 0, source};
}

OutputTriangle kept_triangle(const ArrangementInput& input, std::uint32_t t, int selected) {
  const std::uint32_t source = selected < 0 ? source_of(input.cover(t), selected) : t;
  return kept_face(input.triangles[t], t, selected, source);
}

OutputTriangle kept_sub_triangle(const Subdivision& subdivision, std::uint32_t p, int selected) {
  const Subdivision::SubTriangle& triangle = subdivision.triangles[p];
  return kept_face(triangle.corners, subdivision.regions[triangle.region].support, selected,
                   source_of(subdivision.cover(triangle.region), selected));
}

void write_contacts(const VertexDuplicates& duplicates, const PointWriter& points,
                    mesh::ExactMesh& mesh) {
  for (const Touch& touch : duplicates.touches) {
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

support::BulkVector<OutputTriangle> collect_output_triangles(
    const ArrangementInput& input, const Subdivision& subdivision, const ManifoldPatches& patches,
    const std::vector<std::int8_t>& selection) {
  const auto count = static_cast<std::uint32_t>(input.triangles.size());
  support::BulkVector<std::int8_t> selected(count + subdivision.triangles.size());
  support::for_each_block(selected.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto t = static_cast<std::uint32_t>(i);
      if (t >= count) {
        selected[i] = selection[patches.of_region(subdivision.triangles[t - count].region)];
      } else {
        selected[i] = subdivision.touched[t] || input.merged[t] ? std::int8_t{0}
                                                                : selection[patches.of_triangle(t)];
      }
    }
  });
  const support::Ranking ranking(selected.size(), [&](std::size_t i) { return selected[i] != 0; });
  support::BulkVector<OutputTriangle> kept(ranking.size());
  ranking.for_each([&](std::size_t i, std::size_t rank) {
    const auto t = static_cast<std::uint32_t>(i);
    kept[rank] = t < count ? kept_triangle(input, t, selected[i])
                           : kept_sub_triangle(subdivision, t - count, selected[i]);
  });
  return kept;
}

mesh::ExactMesh extract(ArrangementInput& input, support::BulkVector<OutputTriangle> kept) {
  const VertexDuplicates duplicates = [&] {
    const UpwardRounding rounding;
    return duplicate_non_manifold_vertices(input, kept);
  }();
  mesh::ExactMesh mesh;
  const PointWriter points(input, duplicates, kept, mesh);
  const Labels labels(input, mesh);
  const StableClasses classes(input, !duplicates.touches.empty(), mesh);
  write_triangles(input, kept, points, labels, classes, mesh);
  write_planes(input, kept, mesh);
  write_contacts(duplicates, points, mesh);
  return mesh;
}

}  // namespace dupin::arrangement
