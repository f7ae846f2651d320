#include "healing/closed_shells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "healing/ordered_points.h"
#include "healing/sorted_copies.h"
#include "mesh/measure.h"
#include "mesh/self_contact.h"
#include "support/disjoint_sets.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

using support::kNone;
using HalfEdges = std::vector<std::uint32_t>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Which faces are copies of each other.
struct CopyRanks {
  std::vector<std::uint32_t> face;  ///< one number for all copies
  std::vector<std::uint32_t> rank;  ///< among those of the same orientation
};

CopyRanks rank_copies(std::span<const Triangle> triangles, std::span<const std::uint32_t> faces) {
  const std::vector<Copy> sorted = sorted_copies(triangles, faces);
  CopyRanks copies{std::vector(triangles.size(), kNone), std::vector(triangles.size(), 0U)};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Copy& copy = sorted[i];
    copies.face[copy.face] = copy.face;
    if (i > 0 && sorted[i - 1].corners == copy.corners) {
      const Copy& before = sorted[i - 1];
      copies.face[copy.face] = copies.face[before.face];
      copies.rank[copy.face] = before.is_odd == copy.is_odd ? copies.rank[before.face] + 1 : 0;
    }
  }
  return copies;
}

// Per face the place of its set among all sets that are wanted, in the order of their faces; copies
// of a set have one place. Neither the order of faces nor that of points matters.
std::vector<std::uint32_t> places_of_sets(std::span<const Triangle> triangles,
                                          std::span<const std::uint32_t> places_of_points,
                                          std::span<const std::uint32_t> set_of_face,
                                          std::span<const std::uint8_t> is_wanted) {
  std::vector<std::uint32_t> place(triangles.size(), 0);
  std::vector<std::pair<std::vector<Triangle>, std::vector<std::uint32_t>>> sets;
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    if (is_wanted[set_of_face[f]] == 0) {
      continue;
    }
    if (set_of_face[f] == f) {  // the first of its set
      place[f] = static_cast<std::uint32_t>(sets.size());
      sets.emplace_back();
    }
    Triangle corners = triangles[f];
    for (std::uint32_t& corner : corners) {
      corner = places_of_points[corner];
    }
    std::ranges::sort(corners);
    sets[place[set_of_face[f]]].first.push_back(corners);
    sets[place[set_of_face[f]]].second.push_back(f);
  }
  for (auto& set : sets) {
    std::ranges::sort(set.first);
  }
  std::ranges::sort(sets);
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    at += i > 0 && sets[i].first != sets[i - 1].first ? 1 : 0;
    for (const std::uint32_t f : sets[i].second) {
      place[f] = at;
    }
  }
  return place;
}

class ShellFinder {
 public:
  ShellFinder(std::span<const Vec3> points, std::span<const Triangle> triangles, Wedges wedges)
      : mesh_(points, triangles),
        edges_(triangles, points.size()),
        sets_(triangles.size()),
        wedges_(wedges) {}

  ClosedShells find() {
    join_simple_edges();
    if (!open_.empty()) {
      join_copies();
      join_without_choice();
      join_by_angles();
    }
    ClosedShells found{mesh::grouped(sets_.representatives()), {}, {}};
    found.touches_itself.resize(found.shells.count, 0);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      add_pairs(edges_[i].half_edges, found);
    }
    support::sort_unique(found.at_one_edge);
    return found;
  }

 private:
  /// An edge of more than two faces, with the half-edges that are not paired yet.
  struct OpenEdge {
    std::size_t edge;
    HalfEdges half_edges;
  };

  [[nodiscard]] bool is_up(std::uint32_t half_edge) const {
    return edges_.origin(half_edge) < edges_.target(half_edge);
  }
  [[nodiscard]] std::uint32_t face(std::uint32_t half_edge) const {
    return copies_.face[half_edge / 3];
  }
  [[nodiscard]] std::uint32_t rank(std::uint32_t half_edge) const {
    return copies_.rank[half_edge / 3];
  }

  void join(const Pair& pair) { sets_.unite(pair.first / 3, pair.second / 3); }

  void join_simple_edges() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto along = edges_[i].half_edges;
      if (along.size() == 2) {
        join({along[0], along[1]});
      } else {
        open_.push_back({i, {along.begin(), along.end()}});
      }
    }
  }

  void join_copies() {
    std::vector<std::uint32_t> faces;
    for (const OpenEdge& open : open_) {
      for (const std::uint32_t half_edge : open.half_edges) {
        faces.push_back(half_edge / 3);
      }
    }
    support::sort_unique(faces);
    copies_ = rank_copies(mesh_.triangles, faces);
    std::erase_if(open_, [this](OpenEdge& open) { return are_copies_joined(open); });
  }

  // If they are of two faces, as often the one up as the other down.
  bool are_copies_joined(OpenEdge& open) {
    HalfEdges& all = open.half_edges;
    std::ranges::sort(all, {},
                      [this](std::uint32_t h) { return std::tuple(face(h), is_up(h), rank(h)); });
    const auto second =
        std::ranges::find_if(all, [&](std::uint32_t h) { return face(h) != face(all.front()); });
    if (second == all.end() || face(*second) != face(all.back()) ||
        all.end() - second != second - all.begin()) {
      return false;
    }
    std::rotate(
        second,
        std::ranges::find_if(second, all.end(), [this](std::uint32_t h) { return is_up(h); }),
        all.end());
    const std::size_t half = all.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      if (is_up(all[i]) == is_up(all[half + i])) {
        return false;
      }
    }
    for (std::size_t i = 0; i < half; ++i) {
      join({all[i], all[half + i]});
    }
    return true;
  }

  // In rounds, so that the order of edges does not matter: what closes itself, or what only one
  // face can close, else what the only other one closes that ends along the same edges, else by
  // copies of one lid. The others come after the first: of two bodies that overlap, one inside out,
  // what is left without their common part ends so.
  void join_without_choice() {
    constexpr int kMostRounds = 64;  // each looks at all edges
    std::vector<Pair> pairs;
    for (int round = 0; round == 0 || (!pairs.empty() && round < kMostRounds); ++round) {
      pairs.clear();
      for (OpenEdge& open : open_) {
        drop_closed(open);
      }
      std::erase_if(open_, [](const OpenEdge& open) { return open.half_edges.empty(); });
      for (OpenEdge& open : open_) {
        find_forced(open, pairs);
      }
      if (pairs.empty()) {
        find_mates(pairs);
      }
      if (pairs.empty() && !open_.empty()) {
        find_own_lids(pairs);
      }
      if (pairs.empty() && !open_.empty()) {
        find_lids(pairs);
      }
      for (const Pair& pair : pairs) {
        join(pair);
      }
    }
  }

  // Faces that hang together, as many up as down.
  void drop_closed(OpenEdge& open) {
    HalfEdges& all = open.half_edges;
    const auto set = [this](std::uint32_t h) { return sets_.find(h / 3); };
    std::ranges::sort(all, {}, set);
    HalfEdges kept;
    for (auto begin = all.begin(); begin != all.end();) {
      const auto end =
          std::find_if(begin, all.end(), [&](std::uint32_t h) { return set(h) != set(*begin); });
      const auto up = std::count_if(begin, end, [this](std::uint32_t h) { return is_up(h); });
      if (2 * up != end - begin) {
        kept.insert(kept.end(), begin, end);
      }
      begin = end;
    }
    all = std::move(kept);
  }

  /// Where faces that hang together end.
  struct Boundary {
    std::vector<std::pair<std::size_t, int>> edges;  // with the balance, the first one's positive
    bool is_turned;
    std::uint32_t half_edge;  // at the first of them
  };

  [[nodiscard]] std::uint32_t place(const Boundary& end) const {
    return place_of_set_[end.half_edge / 3];
  }

  [[nodiscard]] std::vector<Boundary> find_boundaries() {
    std::vector<std::tuple<std::uint32_t, std::size_t, std::uint32_t>> ends;  // set, edge
    for (const OpenEdge& open : open_) {
      for (const std::uint32_t h : open.half_edges) {
        ends.emplace_back(sets_.find(h / 3), open.edge, h);
      }
    }
    std::ranges::sort(ends);
    std::vector<Boundary> all;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto& [set, edge, h] = ends[i];
      if (i == 0 || std::get<0>(ends[i - 1]) != set) {
        all.push_back({{}, false, h});
      }
      auto& edges = all.back().edges;
      if (edges.empty() || edges.back().first != edge) {
        edges.emplace_back(edge, 0);
      }
      edges.back().second += is_up(h) ? 1 : -1;
    }
    for (Boundary& boundary : all) {
      boundary.is_turned = boundary.edges.front().second < 0;
      for (auto& [edge, balance] : boundary.edges) {
        balance *= boundary.is_turned ? -1 : 1;
      }
    }
    return all;
  }

  // Two that are not copies of each other, where nothing else has their boundary.
  void find_mates(std::vector<Pair>& pairs) {
    std::vector<Boundary> all = find_boundaries();
    std::ranges::sort(all, {}, &Boundary::edges);
    for (auto begin = all.begin(); begin != all.end();) {
      const auto end = std::find_if(
          begin, all.end(), [&](const Boundary& other) { return other.edges != begin->edges; });
      if (end - begin == 2 && begin[0].is_turned != begin[1].is_turned &&
          face(begin[0].half_edge) != face(begin[1].half_edge)) {
        pairs.emplace_back(begin[0].half_edge, begin[1].half_edge);
      }
      begin = end;
    }
  }

  // Of bodies that end along the same edges as copies of one lid: to each a copy, if there are
  // as many. By angles one would close another that is inside out, as what it does not have of it.
  void find_own_lids(std::vector<Pair>& pairs) {
    place_sets();
    std::vector<Boundary> all = find_boundaries();
    std::ranges::sort(all, [this](const Boundary& a, const Boundary& b) {
      return a.edges != b.edges ? a.edges < b.edges : place(a) < place(b);
    });
    for (auto begin = all.begin(); begin != all.end();) {
      const auto end = std::find_if(
          begin, all.end(), [&](const Boundary& other) { return other.edges != begin->edges; });
      give_lids({begin, end}, pairs);
      begin = end;
    }
  }

  // All of one boundary, copies one after the other: the lid is what there are most of.
  void give_lids(std::span<const Boundary> ends, std::vector<Pair>& pairs) const {
    std::span<const Boundary> most;
    for (std::size_t begin = 0, i = 1; i <= ends.size(); ++i) {
      if (i == ends.size() || place(ends[i]) != place(ends[begin])) {
        const auto copies = ends.subspan(begin, i - begin);
        most = copies.size() > most.size() ? copies : most;
        begin = i;
      }
    }
    if (2 * most.size() != ends.size()) {
      return;
    }
    std::array<HalfEdges, 2> lids, bodies;  // those that are not turned, and those that are
    for (const Boundary& end : ends) {
      (place(end) == place(most.front()) ? lids : bodies)[end.is_turned ? 1 : 0].push_back(
          end.half_edge);
    }
    if (bodies[0].size() != lids[1].size()) {
      return;
    }
    for (const std::size_t way : {0U, 1U}) {
      for (std::size_t i = 0; i < bodies[way].size(); ++i) {
        pairs.emplace_back(bodies[way][i], lids[1 - way][i]);
      }
    }
  }

  void find_forced(OpenEdge& open, std::vector<Pair>& pairs) const {
    HalfEdges& all = open.half_edges;
    constexpr std::size_t kMany = 64;
    if (all.empty() || all.size() > kMany) {
      return;
    }
    const bool may_cover = std::ranges::any_of(all, [&](std::uint32_t h) {
      return 2 * std::ranges::count(all, face(h), [this](std::uint32_t k) { return face(k); }) >
             std::ssize(all);
    });
    HalfEdges paired;
    for (const std::uint32_t h : all) {
      const auto is_partner = [&](std::uint32_t k) {
        return is_up(k) != is_up(h) && (may_cover || face(k) != face(h));
      };
      const auto partner = std::ranges::find_if(all, is_partner);
      if (partner != all.end() && std::ranges::count_if(all, is_partner) == 1) {
        pairs.emplace_back(h, *partner);
        paired.insert(paired.end(), {h, *partner});
      }
    }
    std::erase_if(all,
                  [&](std::uint32_t h) { return std::ranges::find(paired, h) != paired.end(); });
  }

  // Of copies of the same faces, one each for what nothing else closes where they end: bodies of
  // which one ends where another begins, inside a third.
  void find_lids(std::vector<Pair>& pairs) {
    place_sets();
    std::vector<Boundary> all = find_boundaries();
    const auto key = [this](const Boundary& lid) { return std::tuple(place(lid), lid.is_turned); };
    std::map<std::uint32_t, const Boundary*> of_set;
    std::map<std::size_t, const OpenEdge*> at;
    std::ranges::stable_sort(all, {}, key);
    for (const Boundary& boundary : all) {
      of_set[sets_.find(boundary.half_edge / 3)] = &boundary;
    }
    for (const OpenEdge& open : open_) {
      at[open.edge] = &open;
    }
    for (auto begin = all.begin(); begin != all.end();) {
      const auto end = std::find_if(
          begin, all.end(), [&](const Boundary& other) { return key(other) != key(*begin); });
      const OpenEdge& open = *at[begin->edges.front().first];
      auto lid = begin;
      for (auto h = open.half_edges.begin(); end - begin > 1 && h != open.half_edges.end(); ++h) {
        const Boundary*& body = of_set[sets_.find(*h / 3)];
        if (lid != end && body != nullptr && has_hole(*body, *begin) &&
            needs_one_of(*h, open, *begin)) {
          pairs.emplace_back(*h, lid->half_edge);
          body = nullptr;  // one of a round
          ++lid;
        }
      }
      begin = end;
    }
  }

  // If nothing closes the half-edge but what is a copy of the lid.
  [[nodiscard]] bool needs_one_of(std::uint32_t h, const OpenEdge& open, const Boundary& lid) {
    return is_up(h) != is_up(lid.half_edge) &&
           std::ranges::all_of(open.half_edges, [&](std::uint32_t k) {
             return is_up(k) == is_up(h) || face(k) == face(h) ||
                    place_of_set_[k / 3] == place(lid);
           });
  }

  // If a boundary has all of the lid's edges, run the other way.
  static bool has_hole(const Boundary& boundary, const Boundary& lid) {
    return std::ranges::all_of(lid.edges, [&](const std::pair<std::size_t, int>& end) {
      const auto found = std::ranges::lower_bound(boundary.edges, end.first, {},
                                                  &std::pair<std::size_t, int>::first);
      return found != boundary.edges.end() && found->first == end.first &&
             found->second * (boundary.is_turned == lid.is_turned ? -1 : 1) == end.second;
    });
  }

  // Edge by edge, so that what one of them joins closes itself at the next: where faces lie on each
  // other, any of them would do at each edge, but the same one has to at all.
  void join_by_angles() {
    if (open_.empty()) {
      return;
    }
    place_sets();
    put_in_order();
    const mesh::Shells all = mesh::shells(mesh_.triangles.size(), edges_);
    std::vector<std::optional<bool>> is_negative(all.count);
    for (OpenEdge& open : open_) {
      drop_closed(open);
      if (open.half_edges.empty()) {
        continue;
      }
      const std::uint32_t shell = all.of_face[open.half_edges.front() / 3];
      if (!is_negative[shell]) {
        const auto faces = support::selected(mesh_.triangles, all.faces_of(shell));
        is_negative[shell] =
            (mesh::volume_sign({mesh_.points, faces}) < 0) == (wedges_ == Wedges::material);
      }
      join_wedges(open, *is_negative[shell]);
    }
  }

  // Edges by their ends.
  void put_in_order() {
    std::ranges::sort(open_, {}, [&](const OpenEdge& open) {
      const mesh::Edge edge = edges_[open.edge];
      return std::minmax({places_[edge.low], places_[edge.high]});
    });
  }

  // What hangs together at open edges, by its faces.
  void place_sets() {
    if (places_.empty()) {
      places_ = places_by_coordinates(mesh_.points);
    }
    const std::vector<std::uint32_t> set_of_face = sets_.representatives();
    std::vector<std::uint8_t> is_wanted(set_of_face.size(), 0);
    for (const OpenEdge& open : open_) {
      for (const std::uint32_t h : open.half_edges) {
        is_wanted[set_of_face[h / 3]] = 1;
      }
    }
    place_of_set_ = places_of_sets(mesh_.triangles, places_, set_of_face, is_wanted);
  }

  static void add_pairs(std::span<const std::uint32_t> half_edges, ClosedShells& found) {
    constexpr std::size_t kMany = 64;
    if (half_edges.size() == 2 || half_edges.size() > kMany) {
      return;
    }
    std::vector<std::uint32_t> at_edge;
    for (const std::uint32_t h : half_edges) {
      at_edge.push_back(found.shells.of_face[h / 3]);
    }
    std::ranges::sort(at_edge);
    for (std::size_t i = 2; i < at_edge.size(); ++i) {
      if (at_edge[i - 2] == at_edge[i]) {
        found.touches_itself[at_edge[i]] = 1;
      }
    }
    support::sort_unique(at_edge);
    for (auto low = at_edge.begin(); low != at_edge.end(); ++low) {
      for (auto high = low + 1; high != at_edge.end(); ++high) {
        found.at_one_edge.emplace_back(*low, *high);
      }
    }
  }

  // Faces that begin and end one level of winding pair up around the edge: above the middle level
  // those with more winding between them, below it those with less.
  void join_wedges(const OpenEdge& open, bool is_negative) {
    const HalfEdges around = layers_around(open, is_negative);
    std::vector<int> levels;  // the lower one of the two that a face is between
    int level = 0;
    for (const std::uint32_t h : around) {
      const bool begins = is_up(h) == is_negative;
      levels.push_back(begins ? level : level - 1);
      level += begins ? 1 : -1;
    }
    const auto [lowest, highest] = std::ranges::minmax(levels);
    for (int at = lowest; at <= highest; ++at) {
      HalfEdges of_level;
      for (std::size_t i = 0; i < around.size(); ++i) {
        if (levels[i] == at) {
          of_level.push_back(around[i]);
        }
      }
      // They begin and end in turn.
      const bool is_first = (is_up(of_level[0]) == is_negative) == (2 * at >= lowest + highest);
      for (std::size_t i = is_first ? 0 : 1; i < of_level.size(); i += 2) {
        join({of_level[i], of_level[(i + 1) % of_level.size()]});
      }
    }
  }

  // By angle; at one angle ends come before beginnings, and what lies on each other in layers that
  // are the same at all edges: by the sets that hung together before any were joined by angles, and
  // copies as if each were in front of the one before.
  [[nodiscard]] HalfEdges layers_around(const OpenEdge& open, bool is_negative) const {
    const mesh::Edge whole = edges_[open.edge];
    const mesh::Edge edge{whole.low, whole.high, open.half_edges};
    HalfEdges around = mesh::sorted_around(mesh_, edges_, edge);
    const auto key = [&](std::uint32_t h) {
      const bool begins = is_up(h) == is_negative;
      const std::uint32_t set = place_of_set_[h / 3];
      const Vec3 apex = (begins ? -1 : 1) * mesh_.points[edges_.target(mesh::next_half_edge(h))];
      return std::tuple(begins, begins ? ~set : set, apex.x(), apex.y(), apex.z(),
                        begins ? ~rank(h) : rank(h));
    };
    for (auto begin = around.begin(); begin != around.end();) {
      const auto end = std::find_if(begin + 1, around.end(), [&](std::uint32_t h) {
        return face(h) != face(*begin) && !mesh::in_one_half_plane(mesh_, edges_, edge, *begin, h);
      });
      std::ranges::sort(begin, end, {}, key);
      begin = end;
    }
    return around;
  }

  mesh::MeshView mesh_;
  mesh::EdgeTable edges_;
  support::DisjointSets sets_;  // of faces
  Wedges wedges_;
  std::vector<OpenEdge> open_;
  CopyRanks copies_;
  std::vector<std::uint32_t> places_;        // of points
  std::vector<std::uint32_t> place_of_set_;  // per face
};

}  // namespace

ClosedShells closed_shells(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           Wedges wedges) {
  return ShellFinder(points, triangles, wedges).find();
}

}  // namespace dupin::healing
