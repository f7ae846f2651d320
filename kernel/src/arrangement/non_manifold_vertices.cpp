#include "arrangement/non_manifold_vertices.h"

#include <algorithm>
#include <map>
#include <set>

#include "arrangement/points/implicit_predicates.h"
#include "dupin/kernel/error.h"
#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

// A triangle around a vertex: (vertex, from, to).
struct Spoke {
  PointId vertex, from, to;
  std::uint32_t face;
  std::uint8_t corner;
};

using Spokes = std::span<const Spoke>;

bool is_one_fan(Spokes spokes) {
  std::size_t steps = 0;
  PointId at = spokes.front().from;
  do {
    const Spoke* onward = nullptr;
    for (const Spoke& s : spokes) {
      if (s.from == at) {
        if (onward != nullptr) {
          return false;
        }
        onward = &s;
      }
    }
    if (onward == nullptr) {
      return false;
    }
    at = onward->to;
    ++steps;
  } while (at != spokes.front().from && steps <= spokes.size());
  return steps == spokes.size();
}

class Separator {
 public:
  Separator(ArrangementInput& input, support::BulkVector<OutputTriangle>& kept)
      : input_(input), kept_(kept) {
    const auto collect = [&](std::size_t f, std::vector<Spoke>& spokes) {
      const Triangle& t = kept[f].corners;
      for (std::uint8_t i = 0; i < 3; ++i) {
        if (input.special[t[i]]) {
          spokes.push_back(
              {t[i], t[(i + 1u) % 3], t[(i + 2u) % 3], static_cast<std::uint32_t>(f), i});
        }
      }
    };
    spokes_ = support::collect_in_order<Spoke>(kept.size(), collect);
    support::sort_by_key(
        spokes_, input.points.size(), [](const Spoke& spoke) { return spoke.vertex; },
        [](const Spoke& a, const Spoke& b) { return a.vertex < b.vertex; });
  }

  VertexDuplicates run() {
    find_tangled();
    assign_fans();
    VertexDuplicates result;
    const std::vector<EdgeKey> shared = edges_shared_by_fans();
    const PointId first_middle = input_.points.size();
    for (const EdgeKey edge : shared) {
      input_.points.add(middle(input_.points, edge));
    }
    result.first_copy = input_.points.size();
    find_touches(result);
    make_copies(result);
    for (std::size_t i = 0; i < shared.size(); ++i) {
      split_pairs(shared[i], static_cast<PointId>(first_middle + i), result);
    }
    split_faces();
    return result;
  }

 private:
  void find_tangled() {
    const std::vector<support::IndexRange> vertices =
        support::ranges_of_equal(spokes_, [](const Spoke& spoke) { return spoke.vertex; });
    tangled_ = support::collect_in_order<Spokes>(
        vertices.size(), [&](std::size_t i, std::vector<Spokes>& tangled) {
          const auto [begin, end] = vertices[i];
          const Spokes spokes = Spokes(spokes_).subspan(begin, end - begin);
          if (!is_one_fan(spokes)) {
            tangled.push_back(spokes);
          }
        });
  }

  // The spokes that follow each one around the vertex.
  std::vector<std::size_t> successors(Spokes spokes) {
    std::map<PointId, std::vector<std::size_t>> arriving, leaving;
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      leaving[spokes[i].from].push_back(i);
      arriving[spokes[i].to].push_back(i);
    }
    std::vector<std::size_t> next(spokes.size(), 0);
    for (const auto& [end, out] : leaving) {
      const std::vector<std::size_t>& in = arriving[end];
      if (out.size() != in.size()) {
        throw Error(Errc::boolean_failed,
                    "the arrangement's result is not closed; please report this input");
      }
      if (out.size() == 1) {
        next[in[0]] = out[0];
      } else {
        pair_around(spokes, edge_key(spokes[out[0]].vertex, end), out, in, next);
      }
    }
    return next;
  }

  // Going around the edge from the vertex to its other end, a spoke that leaves by it has the
  // inside before it, and so belongs with the arriving spoke before it.
  void pair_around(Spokes spokes, EdgeKey edge, const std::vector<std::size_t>& out,
                   const std::vector<std::size_t>& in, std::vector<std::size_t>& next) {
    std::vector<HalfPlane> half_planes;
    const auto add = [&](std::size_t i, bool leaves) {
      const OutputTriangle& face = kept_[spokes[i].face];
      const bool runs_up = (spokes[i].vertex == lower_end(edge)) == leaves;
      half_planes.push_back({leaves ? spokes[i].to : spokes[i].from, face.support,
                             runs_up != face.reversed, static_cast<std::uint32_t>(i)});
    };
    std::for_each(out.begin(), out.end(), [&](std::size_t i) { add(i, true); });
    std::for_each(in.begin(), in.end(), [&](std::size_t i) { add(i, false); });
    order_facets_around_edge(input_, half_planes);
    const bool is_lower = spokes[out[0]].vertex == lower_end(edge);
    const std::size_t n = half_planes.size();
    for (std::size_t s = 0; s < n; ++s) {
      const std::size_t i = half_planes[s].owner;
      if (std::find(out.begin(), out.end(), i) != out.end()) {
        const std::size_t before = half_planes[is_lower ? (s + n - 1) % n : (s + 1) % n].owner;
        next[before] = i;
        if (is_lower) {
          contact_edges_[edge].push_back({spokes[i].face, spokes[before].face});
        }
      }
    }
  }

  // Numbers the fans of each tangled vertex.
  void assign_fans() {
    for (const Spokes spokes : tangled_) {
      const std::vector<std::size_t> next = successors(spokes);
      std::uint32_t fans = 0;
      for (std::size_t i = 0; i < spokes.size(); ++i) {
        if (fan_of_.count({spokes[i].face, spokes[i].corner}) != 0) {
          continue;
        }
        for (std::size_t j = i;
             fan_of_.emplace(Corner{spokes[j].face, spokes[j].corner}, fans).second; j = next[j]) {
        }
        ++fans;
      }
    }
  }

  // Contact edges at which two pairs of faces belong to the same fans at both ends, so that
  // copies of the ends do not tell them apart.
  std::vector<EdgeKey> edges_shared_by_fans() const {
    std::vector<EdgeKey> shared;
    for (const auto& [edge, pairs] : contact_edges_) {
      std::set<std::pair<std::uint32_t, std::uint32_t>> fans;
      for (const Neighbours& pair : pairs) {
        const int i = corner_at(pair.up, lower_end(edge)), j = corner_at(pair.up, upper_end(edge));
        fans.emplace(fan(pair.up, i), fan(pair.up, j));
      }
      if (fans.size() < pairs.size()) {
        shared.push_back(edge);
      }
    }
    return shared;
  }

  [[nodiscard]] std::uint32_t fan(std::uint32_t face, int corner) const {
    return fan_of_.at({face, static_cast<std::uint8_t>(corner)});
  }
  [[nodiscard]] int corner_at(std::uint32_t face, PointId id) const {
    const Triangle& t = kept_[face].corners;
    return static_cast<int>(std::find(t.begin(), t.end(), id) - t.begin());
  }

  static mesh::ExactPoint middle(const PointTable& points, EdgeKey edge) {
    mesh::ExactPoint p_scratch, q_scratch;
    const mesh::ExactPoint& p = points.exact(lower_end(edge), p_scratch);
    const mesh::ExactPoint& q = points.exact(upper_end(edge), q_scratch);
    return {p[0] * q[3] + q[0] * p[3], p[1] * q[3] + q[1] * p[3], p[2] * q[3] + q[2] * p[3],
            p[3] * q[3] * CGAL::Mpzf(2)};
  }

  // Gives each pair of faces at the edge a copy of its middle. Their corners may be copies by now.
  void split_pairs(EdgeKey edge, PointId middle, VertexDuplicates& result) {
    const auto original = [&](PointId id) {
      return id < result.first_copy ? id : result.copies[id - result.first_copy];
    };
    bool is_first = true;
    for (const Neighbours& pair : contact_edges_.at(edge)) {
      PointId copy = middle;
      if (!is_first) {
        copy = static_cast<PointId>(result.first_copy + result.copies.size());
        result.copies.push_back(middle);
      }
      is_first = false;
      for (const std::uint32_t face : {pair.up, pair.down}) {
        std::uint8_t i = 0;
        while (edge_key(original(kept_[face].corners[i]),
                        original(kept_[face].corners[(i + 1u) % 3])) != edge) {
          ++i;
        }
        middles_[face][i] = copy;
      }
    }
  }

  // Splits faces at the middles of their edges (edge i runs from corner i to the next).
  void split_faces() {
    for (const auto& [split_face, middles] : middles_) {
      const auto face = split_face;  // Clang's lambdas take no names of structured bindings
      const OutputTriangle whole = kept_[face];
      std::vector<PointId> outline;
      for (std::uint8_t i = 0; i < 3; ++i) {
        outline.push_back(whole.corners[i]);
        if (const auto middle = middles.find(i); middle != middles.end()) {
          outline.push_back(middle->second);
        }
      }
      bool is_first = true;
      const auto add = [&](PointId a, PointId b, PointId c) {
        OutputTriangle part = whole;
        part.corners = {a, b, c};
        if (is_first) {
          kept_[face] = part;
        } else {
          kept_.push_back(part);
        }
        is_first = false;
      };
      // From a middle, all other points can be joined but the ends of its edge; cutting corners
      // off until three points are left never takes three on a line.
      const std::size_t start = static_cast<std::size_t>(middles.begin()->first) + 1;
      const std::size_t n = outline.size();
      for (std::size_t i = 1; i + 1 < n; ++i) {
        add(outline[start], outline[(start + i) % n], outline[(start + i + 1) % n]);
      }
    }
  }

  void find_touches(VertexDuplicates& result) const {
    std::set<PointId> ends;
    std::map<EdgeKey, std::size_t> number;
    for (const auto& [edge, pairs] : contact_edges_) {
      number.emplace(edge, result.touches.size());
      result.touches.push_back({lower_end(edge), upper_end(edge), {}});
      ends.insert({lower_end(edge), upper_end(edge)});
    }
    for (const Spokes spokes : tangled_) {
      const PointId vertex = spokes.front().vertex;
      if (ends.count(vertex) == 0) {
        result.touches.push_back({vertex, vertex, {}});
        for (const Spoke& s : spokes) {
          result.touches.back().faces.push_back(s.face);
        }
      }
      for (const Spoke& s : spokes) {
        if (const auto touch = number.find(edge_key(vertex, s.from)); touch != number.end()) {
          result.touches[touch->second].faces.push_back(s.face);
        }
      }
    }
    std::sort(result.touches.begin(), result.touches.end(), [](const Touch& a, const Touch& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
  }

  void make_copies(VertexDuplicates& result) {
    for (const Spokes spokes : tangled_) {
      std::map<std::uint32_t, PointId> copies;  // by fan
      for (const Spoke& s : spokes) {
        const std::uint32_t fan = fan_of_.at({s.face, s.corner});
        if (fan == 0) {
          continue;
        }
        const auto [copy, is_new] =
            copies.emplace(fan, static_cast<PointId>(result.first_copy + result.copies.size()));
        if (is_new) {
          result.copies.push_back(s.vertex);
        }
        kept_[s.face].corners[s.corner] = copy->second;
      }
    }
  }

  struct Neighbours {  // that belong together at an edge, running up and down along it
    std::uint32_t up, down;
  };
  using Corner = std::pair<std::uint32_t, std::uint8_t>;  // of a kept triangle

  ArrangementInput& input_;
  support::BulkVector<OutputTriangle>& kept_;
  std::vector<Spoke> spokes_;    // at special vertices, by vertex
  std::vector<Spokes> tangled_;  // of vertices with more than one fan
  std::map<EdgeKey, std::vector<Neighbours>> contact_edges_;
  std::map<Corner, std::uint32_t> fan_of_;
  std::map<std::uint32_t, std::map<std::uint8_t, PointId>> middles_;  // per face and edge
};

}  // namespace

VertexDuplicates duplicate_non_manifold_vertices(ArrangementInput& input,
                                                 support::BulkVector<OutputTriangle>& kept) {
  return Separator(input, kept).run();
}

}  // namespace dupin::arrangement
