#include "arrangement/non_manifold_vertices.h"

#include <algorithm>
#include <map>
#include <span>

#include "arrangement/points/implicit_predicates.h"
#include "dupin/kernel/error.h"
#include "support/none.h"
#include "support/sequences.h"
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

// Vertices with several fans that one task looks at.
constexpr std::size_t kVertices = 256;

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
    const auto collect = [&](std::size_t f, const auto& found) {
      const Triangle& t = kept[f].corners;
      for (std::uint8_t i = 0; i < 3; ++i) {
        if (input.special[t[i]]) {
          found(Spoke{t[i], t[(i + 1u) % 3], t[(i + 2u) % 3], static_cast<std::uint32_t>(f), i});
        }
      }
    };
    spokes_ = support::collect_by_key<Spoke>(
        kept.size(), collect, input.points.size(), [](const Spoke& spoke) { return spoke.vertex; },
        [](const Spoke& a, const Spoke& b) { return a.vertex < b.vertex; });
  }

  VertexDuplicates run() {
    find_tangled();
    assign_fans();
    contact_edges_ = support::ranges_of_equal(pairs_, [](const Pair& pair) { return pair.edge; });
    VertexDuplicates result;
    const std::vector<support::IndexRange> shared = edges_shared_by_fans();
    const PointId first_middle = input_.points.size();
    for (const support::IndexRange& edge : shared) {
      input_.points.add(middle(input_.points, pairs_[edge.begin].edge));
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
  struct Pair {  // of faces that belong together at an edge, running up and down along it
    EdgeKey edge;
    std::uint32_t up, down;
  };

  [[nodiscard]] Spokes spokes(const support::IndexRange& range) const {
    return Spokes(spokes_).subspan(range.begin, range.end - range.begin);
  }

  void find_tangled() {
    const std::vector<support::IndexRange> vertices =
        support::ranges_of_equal(spokes_, [](const Spoke& spoke) { return spoke.vertex; });
    const auto collect = [&](std::size_t i, std::vector<support::IndexRange>& tangled) {
      if (!is_one_fan(spokes(vertices[i]))) {
        tangled.push_back(vertices[i]);
      }
    };
    tangled_ = support::collect_in_order<support::IndexRange>(vertices.size(), collect);
  }

  // The spokes that follow each one around the vertex. Appends the pairs at edges up from there.
  std::vector<std::uint32_t> successors(Spokes spokes, std::vector<Pair>& pairs) const {
    const auto sorted_by = [&](PointId Spoke::*end) {
      std::vector<std::uint32_t> order = support::numbers_below(spokes.size());
      std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return spokes[i].*end; });
      return order;
    };
    const std::vector<std::uint32_t> leaving = sorted_by(&Spoke::from);
    const std::vector<std::uint32_t> arriving = sorted_by(&Spoke::to);
    std::vector<std::uint32_t> next(spokes.size(), 0);
    for (std::size_t i = 0, past = 0; i < spokes.size(); i = past) {
      const PointId end = spokes[leaving[i]].from;
      for (past = i; past < spokes.size() && spokes[leaving[past]].from == end; ++past) {
        if (spokes[arriving[past]].to != end) {
          throw Error(Errc::boolean_failed,
                      "the arrangement's result is not closed; please report this input");
        }
      }
      if (past == i + 1) {
        next[arriving[i]] = leaving[i];
      } else {
        pair_around(spokes, edge_key(spokes[leaving[i]].vertex, end),
                    std::span(leaving).subspan(i, past - i),
                    std::span(arriving).subspan(i, past - i), next, pairs);
      }
    }
    return next;
  }

  // Going around the edge from the vertex to its other end, a spoke that leaves by it has the
  // inside before it, and so belongs with the arriving spoke before it.
  void pair_around(Spokes spokes, EdgeKey edge, std::span<const std::uint32_t> out,
                   std::span<const std::uint32_t> in, std::vector<std::uint32_t>& next,
                   std::vector<Pair>& pairs) const {
    std::vector<HalfPlane> half_planes;
    const auto add = [&](std::uint32_t i, bool leaves) {
      const OutputTriangle& face = kept_[spokes[i].face];
      const bool runs_up = (spokes[i].vertex == lower_end(edge)) == leaves;
      half_planes.push_back(
          {leaves ? spokes[i].to : spokes[i].from, face.support, runs_up != face.reversed, i});
    };
    std::ranges::for_each(out, [&](std::uint32_t i) { add(i, true); });
    std::ranges::for_each(in, [&](std::uint32_t i) { add(i, false); });
    {
      const UpwardRounding rounding;
      order_facets_around_edge(input_, half_planes);
    }
    const bool is_lower = spokes[out[0]].vertex == lower_end(edge);
    const std::size_t n = half_planes.size();
    for (std::size_t s = 0; s < n; ++s) {
      const std::uint32_t i = half_planes[s].owner;
      if (std::ranges::find(out, i) != out.end()) {
        const std::uint32_t before = half_planes[is_lower ? (s + n - 1) % n : (s + 1) % n].owner;
        next[before] = i;
        if (is_lower) {
          pairs.push_back({edge, spokes[i].face, spokes[before].face});
        }
      }
    }
  }

  // Numbers the fans of each tangled vertex, by their first spokes, and finds the pairs.
  void assign_fans() {
    fan_of_.resize(spokes_.size());
    fans_.resize(tangled_.size());
    // By vertex and other end, which is how edges ascend.
    pairs_ = support::collect_in_order<Pair>(
        tangled_.size(),
        [&](std::size_t t, std::vector<Pair>& pairs) {
          const std::vector<std::uint32_t> next = successors(spokes(tangled_[t]), pairs);
          const std::span<std::uint32_t> fan_of =
              std::span(fan_of_).subspan(tangled_[t].begin, next.size());
          std::ranges::fill(fan_of, support::kNone);
          for (std::uint32_t i = 0; i < next.size(); ++i) {
            for (std::uint32_t j = i; fan_of[j] == support::kNone; j = next[j]) {
              fan_of[j] = fans_[t];
            }
            fans_[t] += fan_of[i] == fans_[t] ? 1 : 0;
          }
        },
        kVertices);
  }

  // Contact edges at which two pairs of faces belong to the same fans at both ends, so that
  // copies of the ends do not tell them apart.
  [[nodiscard]] std::vector<support::IndexRange> edges_shared_by_fans() const {
    return support::collect_in_order<support::IndexRange>(
        contact_edges_.size(), [&](std::size_t i, std::vector<support::IndexRange>& shared) {
          const auto [begin, end] = contact_edges_[i];
          std::vector<std::pair<std::uint32_t, std::uint32_t>> fans;
          for (std::uint32_t p = begin; p < end; ++p) {
            const auto& [edge, up, down] = pairs_[p];
            fans.emplace_back(fan(lower_end(edge), up), fan(upper_end(edge), up));
          }
          support::sort_unique(fans);
          if (fans.size() < end - begin) {
            shared.push_back(contact_edges_[i]);
          }
        });
  }

  // The place of a tangled vertex among them.
  [[nodiscard]] std::size_t tangle_at(PointId vertex) const {
    const auto at = std::ranges::lower_bound(
        tangled_, vertex, {},
        [&](const support::IndexRange& range) { return spokes_[range.begin].vertex; });
    return static_cast<std::size_t>(at - tangled_.begin());
  }
  // The fan that a face belongs to at a tangled vertex.
  [[nodiscard]] std::uint32_t fan(PointId vertex, std::uint32_t face) const {
    std::uint32_t i = tangled_[tangle_at(vertex)].begin;
    while (spokes_[i].face != face) {
      ++i;
    }
    return fan_of_[i];
  }

  static mesh::ExactPoint middle(const PointTable& points, EdgeKey edge) {
    mesh::ExactPoint p_scratch, q_scratch;
    const mesh::ExactPoint& p = points.exact(lower_end(edge), p_scratch);
    const mesh::ExactPoint& q = points.exact(upper_end(edge), q_scratch);
    return {p[0] * q[3] + q[0] * p[3], p[1] * q[3] + q[1] * p[3], p[2] * q[3] + q[2] * p[3],
            p[3] * q[3] * CGAL::Mpzf(2)};
  }

  // Gives each pair of faces at the edge a copy of its middle. Their corners may be copies by now.
  void split_pairs(const support::IndexRange& pairs, PointId middle, VertexDuplicates& result) {
    const EdgeKey edge = pairs_[pairs.begin].edge;
    const auto original = [&](PointId id) {
      return id < result.first_copy ? id : result.copies[id - result.first_copy];
    };
    for (std::uint32_t p = pairs.begin; p < pairs.end; ++p) {
      PointId copy = middle;
      if (p > pairs.begin) {
        copy = static_cast<PointId>(result.first_copy + result.copies.size());
        result.copies.push_back(middle);
      }
      for (const std::uint32_t face : {pairs_[p].up, pairs_[p].down}) {
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
    std::vector<std::uint8_t> has_edge(tangled_.size(), 0);
    for (const support::IndexRange& range : contact_edges_) {
      const EdgeKey edge = pairs_[range.begin].edge;
      has_edge[tangle_at(lower_end(edge))] = has_edge[tangle_at(upper_end(edge))] = 1;
      result.touches.push_back({lower_end(edge), upper_end(edge), {}});
    }
    for (std::size_t t = 0; t < tangled_.size(); ++t) {
      if (has_edge[t] == 0) {
        const PointId vertex = spokes_[tangled_[t].begin].vertex;
        result.touches.push_back({vertex, vertex, {}});
      }
    }
    std::sort(result.touches.begin(), result.touches.end(), [](const Touch& a, const Touch& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    support::for_each_block(
        result.touches.size(),
        [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            add_faces(result.touches[i]);
          }
        },
        kVertices);
  }

  // At a vertex all, at an edge those that run up, then those that run down along it.
  void add_faces(Touch& touch) const {
    const auto add = [&](PointId vertex, PointId other_end) {
      for (const Spoke& s : spokes(tangled_[tangle_at(vertex)])) {
        if (vertex == other_end || s.from == other_end) {
          touch.faces.push_back(s.face);
        }
      }
    };
    add(touch.from, touch.to);
    if (touch.from != touch.to) {
      add(touch.to, touch.from);
    }
  }

  void make_copies(VertexDuplicates& result) {
    for (std::size_t t = 0; t < tangled_.size(); ++t) {
      const auto first = static_cast<PointId>(result.first_copy + result.copies.size());
      for (std::uint32_t i = tangled_[t].begin; i < tangled_[t].end; ++i) {
        if (const std::uint32_t fan = fan_of_[i]; fan > 0) {
          kept_[spokes_[i].face].corners[spokes_[i].corner] = first + fan - 1;
        }
      }
      result.copies.insert(result.copies.end(), fans_[t] - 1, spokes_[tangled_[t].begin].vertex);
    }
  }

  ArrangementInput& input_;
  support::BulkVector<OutputTriangle>& kept_;
  support::BulkVector<Spoke> spokes_;          // at special vertices, by vertex
  std::vector<support::IndexRange> tangled_;   // the spokes of vertices with more than one fan
  support::BulkVector<std::uint32_t> fan_of_;  // of spokes of such vertices
  std::vector<std::uint32_t> fans_;            // of each such vertex, how many
  std::vector<Pair> pairs_;                    // by edge
  std::vector<support::IndexRange> contact_edges_;
  std::map<std::uint32_t, std::map<std::uint8_t, PointId>> middles_;  // per face and edge
};

}  // namespace

VertexDuplicates duplicate_non_manifold_vertices(ArrangementInput& input,
                                                 support::BulkVector<OutputTriangle>& kept) {
  return Separator(input, kept).run();
}

}  // namespace dupin::arrangement
