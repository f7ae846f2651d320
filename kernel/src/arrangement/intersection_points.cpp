#include "arrangement/intersection_points.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "arrangement/points/implicit_predicates.h"
#include "support/hash.h"
#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

// The lines of edges with implicit ends, by points of the input that say less: the coordinates of
// new points then do not build on those of earlier ones.
class EdgeLines {
 public:
  /// Of no other edges than those that have marked points at both ends.
  EdgeLines(const ArrangementInput& input, const std::vector<std::uint8_t>& marked)
      : input_(input) {
    for (std::uint32_t t = 0; t < input.supports.size(); ++t) {
      for (Feature f = 3; f < kInside; ++f) {
        const EdgeKey edge = edge_of(input.triangles[t], f);
        const PointId low = lower_end(edge), high = upper_end(edge);
        if (marked[low] && marked[high] &&
            (!input.points.is_double(low) || !input.points.is_double(high))) {
          sides_.push_back({edge, t});
        }
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }

  /// The point where the edge meets a plane.
  [[nodiscard]] ImplicitPoint piercing(EdgeKey edge, const Triangle& plane) const {
    auto side = std::lower_bound(sides_.begin(), sides_.end(), Side{edge, 0});
    if (side != sides_.end() && side->edge == edge) {
      const Triangle& first = input_.support(side->triangle);
      for (++side; side != sides_.end() && side->edge == edge; ++side) {
        const Triangle& second = input_.support(side->triangle);
        if (!coplanar(first, second)) {
          return {ImplicitPoint::Kind::three_planes,
                  0,
                  {first[0], first[1], first[2], second[0], second[1], second[2], plane[0],
                   plane[1], plane[2]}};
        }
        if (const auto line = common_line(first, second, edge)) {
          return {ImplicitPoint::Kind::line_plane,
                  0,
                  {(*line)[0], (*line)[1], plane[0], plane[1], plane[2]}};
        }
      }
    }
    return {ImplicitPoint::Kind::line_plane,
            0,
            {lower_end(edge), upper_end(edge), plane[0], plane[1], plane[2]}};
  }

 private:
  struct Side {
    EdgeKey edge;
    std::uint32_t triangle;
    friend auto operator<=>(const Side&, const Side&) = default;
  };

  [[nodiscard]] bool coplanar(const Triangle& a, const Triangle& b) const {
    return std::all_of(b.begin(), b.end(), [&](PointId p) {
      return side_of_plane(input_.points, a[0], a[1], a[2], p) == 0;
    });
  }

  // Two corners that the planes have in common, if the edge lies on their line.
  [[nodiscard]] std::optional<std::array<PointId, 2>> common_line(const Triangle& a,
                                                                  const Triangle& b,
                                                                  EdgeKey edge) const {
    std::vector<PointId> common;
    for (const PointId p : a) {
      const bool is_common = std::any_of(b.begin(), b.end(), [&](PointId q) {
        return input_.points.is_double(p) && input_.points.is_double(q) &&
               input_.points.coordinates(p) == input_.points.coordinates(q);
      });
      if (is_common) {
        common.push_back(p);
      }
    }
    if (common.size() != 2) {
      return std::nullopt;
    }
    const int axis = projection_of(input_.points, a).axis;
    for (const PointId end : {lower_end(edge), upper_end(edge)}) {
      if (turn(input_.points, common[0], common[1], end, axis) != 0) {
        return std::nullopt;
      }
    }
    return std::array<PointId, 2>{common[0], common[1]};
  }

  const ArrangementInput& input_;
  std::vector<Side> sides_;
};

// What meets at an end of an intersection: two edges, or an edge and the plane of a triangle.
struct Meeting {
  static constexpr std::uint64_t kPlane = std::uint64_t{1} << 63;
  std::uint64_t first, second;
  friend auto operator<=>(const Meeting&, const Meeting&) = default;
};

struct MeetingAt {
  Meeting meeting;
  std::uint32_t hash;
  std::uint32_t end;
};

MeetingAt meeting_at(std::uint32_t end, const Meeting& m) {
  const std::uint64_t hash = support::mixed(support::mixed(0, m.first), m.second);
  return {m, static_cast<std::uint32_t>(hash >> 32), end};
}

class Creator {
 public:
  Creator(ArrangementInput& input, std::span<const TriangleIntersection> intersections,
          std::span<const TrianglePair> crossed_sheets)
      : input_(input),
        intersections_(intersections),
        crossed_sheets_(crossed_sheets),
        leader_(2 * intersections.size()) {
    points_.ends.resize(2 * intersections.size());
    points_.first_new_point = input.points.size();
  }

  IntersectionPoints run() {
    find_corners();
    find_meetings();
    find_leaders();
    find_facets();
    find_lines();
    add_points();
    return std::move(points_);
  }

 private:
  [[nodiscard]] const TriangleIntersection& intersection(std::size_t end) const {
    return intersections_[end / 2];
  }
  [[nodiscard]] bool is_end(std::size_t end) const {
    const TriangleIntersection::Kind kind = intersection(end).kind;
    return kind == TriangleIntersection::Kind::segment ||
           (kind == TriangleIntersection::Kind::point && end % 2 == 0);
  }
  [[nodiscard]] const Triangle& first(std::size_t end) const {
    return input_.triangles[intersection(end).first];
  }
  [[nodiscard]] const Triangle& second(std::size_t end) const {
    return input_.triangles[intersection(end).second];
  }

  void find_corners() {
    points_.corners = support::collect_in_order<PointId>(
        points_.ends.size(), [this](std::size_t end, std::vector<PointId>& corners) {
          PointId& id = points_.ends[end];
          id = kNone;
          if (!is_end(end)) {
            return;
          }
          const auto [on_first, on_second, crosses] = intersection(end).ends[end % 2];
          if (is_corner(on_first)) {
            id = first(end)[on_first];
          } else if (is_corner(on_second)) {
            id = second(end)[on_second];
          }
          if (id != kNone) {
            corners.push_back(id);
          }
        });
    support::sort_by_key(
        points_.corners, points_.first_new_point, [](PointId id) { return id; }, std::less<>());
    points_.corners.erase(std::unique(points_.corners.begin(), points_.corners.end()),
                          points_.corners.end());
  }

  [[nodiscard]] Meeting meeting(std::size_t end) const {
    const TriangleIntersection& e = intersection(end);
    const auto [on_first, on_second, crosses] = e.ends[end % 2];
    if (is_edge(on_first) && is_edge(on_second)) {
      const auto [low, high] =
          std::minmax({edge_of(first(end), on_first), edge_of(second(end), on_second)});
      return {low, high};
    }
    return is_edge(on_first) ? Meeting{edge_of(first(end), on_first), Meeting::kPlane | e.second}
                             : Meeting{edge_of(second(end), on_second), Meeting::kPlane | e.first};
  }

  // By meeting, those of each by end.
  void find_meetings() {
    meetings_ = support::collect_by_key<MeetingAt>(
        points_.ends.size(),
        [this](std::size_t end, const auto& found) {
          if (is_end(end) && points_.ends[end] == kNone) {
            found(meeting_at(static_cast<std::uint32_t>(end), meeting(end)));
          }
        },
        kNone, [](const MeetingAt& m) { return m.hash; },
        [](const MeetingAt& a, const MeetingAt& b) {
          return std::tie(a.hash, a.meeting) < std::tie(b.hash, b.meeting);
        });
  }

  // The first end of each meeting stands for the others.
  void find_leaders() {
    runs_ = support::ranges_of_equal(
        meetings_, [](const MeetingAt& m) -> const Meeting& { return m.meeting; });
    support::fill_all(leader_, kNone);
    support::for_each_block(runs_.size(), [this](const support::Block& block) {
      for (std::size_t r = block.begin; r < block.end; ++r) {
        for (const MeetingAt& m : run(r)) {
          leader_[m.end] = run(r).front().end;
        }
      }
    });
  }

  // All ends of one meeting.
  [[nodiscard]] std::span<const MeetingAt> run(std::size_t r) const {
    return std::span(meetings_).subspan(runs_[r].begin, runs_[r].end - runs_[r].begin);
  }

  // Two triangles at an edge that is met, by others in their plane somewhere.
  struct Candidate {
    TrianglePair pair;
    bool in_plane;
    friend bool operator<(const Candidate& a, const Candidate& b) {
      return a.pair != b.pair ? a.pair < b.pair : a.in_plane > b.in_plane;
    }
  };

  // Of an edge that is met there; none if it has others.
  [[nodiscard]] std::optional<TrianglePair> pair_at(std::span<const MeetingAt> run,
                                                    EdgeKey edge) const {
    std::array<std::uint32_t, 2> triangles{kNone, kNone};
    for (const MeetingAt& m : run) {
      const TriangleIntersection& e = intersection(m.end);
      const auto [on_first, on_second, crosses] = e.ends[m.end % 2];
      for (const auto& [triangle, feature] :
           {std::pair(e.first, on_first), {e.second, on_second}}) {
        if (!is_edge(feature) || edge_of(input_.triangles[triangle], feature) != edge ||
            triangle == triangles[0] || triangle == triangles[1]) {
          continue;
        }
        if (triangles[1] != kNone) {
          return std::nullopt;
        }
        triangles[triangles[0] == kNone ? 0 : 1] = triangle;
      }
    }
    const auto [t, u] = std::minmax(triangles[0], triangles[1]);
    return u != kNone ? std::optional(TrianglePair{t, u}) : std::nullopt;
  }

  // Whether edges of triangles that all lie in one plane meet there.
  [[nodiscard]] bool is_crossing_in_plane(std::span<const MeetingAt> run) const {
    const Meeting& meeting = run.front().meeting;
    return ((meeting.first | meeting.second) & Meeting::kPlane) == 0 &&
           std::ranges::all_of(run,
                               [this](const MeetingAt& m) { return intersection(m.end).coplanar; });
  }

  // Ascending, each once.
  [[nodiscard]] std::vector<Candidate> find_candidates() {
    in_plane_.assign(runs_.size(), 0);
    std::vector<Candidate> candidates = support::collect_in_order<Candidate>(
        runs_.size(), [&](std::size_t r, std::vector<Candidate>& found) {
          in_plane_[r] = is_crossing_in_plane(run(r)) ? 1 : 0;
          const Meeting& meeting = run(r).front().meeting;
          for (const EdgeKey edge : {meeting.first, meeting.second}) {
            if (const auto pair =
                    (edge & Meeting::kPlane) == 0 ? pair_at(run(r), edge) : std::nullopt) {
              found.push_back({*pair, in_plane_[r] != 0});
            }
          }
        });
    for (const TrianglePair& pair : crossed_sheets_) {
      candidates.push_back({pair, true});
    }
    support::sort_by_key(
        candidates, static_cast<std::uint32_t>(input_.triangles.size()),
        [](const Candidate& c) { return c.pair.first; }, std::less<>());
    candidates.erase(
        std::unique(candidates.begin(), candidates.end(),
                    [](const Candidate& a, const Candidate& b) { return a.pair == b.pair; }),
        candidates.end());
    return candidates;
  }

  // None if operands may cross themselves.
  void find_facets() {
    if (may_cross_themselves(input_)) {
      return;
    }
    std::vector<TrianglePair> all, in_plane;
    for (const Candidate& candidate : find_candidates()) {
      all.push_back(candidate.pair);
      if (candidate.in_plane) {
        in_plane.push_back(candidate.pair);
      }
    }
    points_.facets = FlatFacets(input_, all);
    points_.sheets = FlatSheets(input_, in_plane);
    if (points_.facets.empty() && points_.sheets.empty()) {
      return;
    }
    support::for_each_block(runs_.size(), [&](const support::Block& block) {
      for (std::size_t r = block.begin; r < block.end; ++r) {
        if (is_inside_sheets(r) || is_inside_facets(r)) {
          for (const MeetingAt& m : run(r)) {
            leader_[m.end] = kNone;
          }
        }
      }
    });
  }

  [[nodiscard]] bool is_inside_facets(std::size_t r) const {
    return !points_.facets.empty() && std::ranges::all_of(run(r), [this](const MeetingAt& m) {
      return points_.facets.is_joint(intersection(m.end), m.end % 2);
    });
  }

  [[nodiscard]] bool is_inside_sheets(std::size_t r) const {
    const auto& [first, second] = run(r).front().meeting;
    return in_plane_[r] != 0 && points_.sheets.at(first) != nullptr &&
           points_.sheets.at(second) != nullptr;
  }

  void find_lines() {
    std::vector<std::uint8_t> is_end_of_met;
    if (!input_.supports.empty()) {
      is_end_of_met.resize(input_.points.size(), 0);
      for (const MeetingAt& m : meetings_) {
        for (const EdgeKey edge : {m.meeting.first, m.meeting.second}) {
          if ((edge & Meeting::kPlane) == 0) {
            is_end_of_met[lower_end(edge)] = is_end_of_met[upper_end(edge)] = 1;
          }
        }
      }
    }
    lines_.emplace(input_, is_end_of_met);
  }

  void add_points() {
    constexpr std::size_t kEnds = 256;
    const support::Ranking leaders(leader_.size(),
                                   [this](std::size_t end) { return leader_[end] == end; });
    const PointId base = points_.first_new_point;
    input_.points.add_undefined(leaders.size());
    leaders.for_each([&](std::size_t end, std::size_t rank) {
      points_.ends[end] = base + static_cast<PointId>(rank);
    });
    support::for_each_block(
        leader_.size(),
        [&](const support::Block& block) {
          const UpwardRounding rounding;
          for (std::size_t end = block.begin; end < block.end; ++end) {
            if (leader_[end] == end) {
              input_.points.define(points_.ends[end], definition(end));
            } else if (leader_[end] != kNone) {
              points_.ends[end] = points_.ends[leader_[end]];
            }
          }
        },
        kEnds);
  }

  [[nodiscard]] ImplicitPoint definition(std::size_t end) const {
    const TriangleIntersection& e = intersection(end);
    const auto [on_first, on_second, first_crosses] = e.ends[end % 2];
    if (is_edge(on_first) && is_edge(on_second) && e.coplanar) {
      const EdgeKey a = edge_of(first(end), on_first), b = edge_of(second(end), on_second);
      return {ImplicitPoint::Kind::two_lines,
              e.axis,
              {lower_end(a), upper_end(a), lower_end(b), upper_end(b)}};
    }
    return is_edge(on_first) && (first_crosses || !is_edge(on_second))
               ? lines_->piercing(edge_of(first(end), on_first), input_.support(e.second))
               : lines_->piercing(edge_of(second(end), on_second), input_.support(e.first));
  }

  ArrangementInput& input_;
  std::span<const TriangleIntersection> intersections_;
  std::span<const TrianglePair> crossed_sheets_;
  std::optional<EdgeLines> lines_;
  IntersectionPoints points_;
  support::BulkVector<MeetingAt> meetings_;
  std::vector<support::IndexRange> runs_;      // of equal ones
  std::vector<std::uint8_t> in_plane_;         // per run
  support::BulkVector<std::uint32_t> leader_;  // of each end
};

}  // namespace

IntersectionPoints create_intersection_points(ArrangementInput& input,
                                              std::span<const TriangleIntersection> intersections,
                                              std::span<const TrianglePair> crossed_sheets) {
  return Creator(input, intersections, crossed_sheets).run();
}

}  // namespace dupin::arrangement
