#include "meshing/patch_topology.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace dupin::meshing {
namespace {

/// One side of an edge, low < high.
struct Side {
  std::uint32_t low, high;
  std::uint32_t triangle;
  bool is_forward;  ///< the triangle goes from low to high
  [[nodiscard]] std::array<std::uint32_t, 2> key() const { return {low, high}; }
};

std::vector<Side> sorted_sides(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[f][k], to = triangles[f][(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), f, from < to});
    }
  }
  std::ranges::stable_sort(sides, {}, &Side::key);
  return sides;
}

/// Calls visit(the sides of an edge) for all edges.
template <class Visit>
void for_each_edge(std::span<const Side> sides, const Visit& visit) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key() == sides[i].key()) {
      ++end;
    }
    visit(sides.subspan(i, end - i));
    i = end;
  }
}

struct Wanted {
  std::array<std::uint32_t, 2> key;
  std::uint32_t sides;
};

bool has_borders(std::span<const Side> sides, std::span<const BorderChain> chains) {
  std::vector<Wanted> wanted;
  for (const BorderChain& chain : chains) {
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
      const auto [low, high] = std::minmax(chain.points[i - 1], chain.points[i]);
      wanted.push_back({{low, high}, chain.sides});
    }
  }
  std::ranges::sort(wanted, {}, &Wanted::key);
  bool is_right = true;
  std::size_t next = 0;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    std::size_t expected = 2;
    if (next < wanted.size() && wanted[next].key == edge.front().key()) {
      expected = wanted[next++].sides;
    }
    is_right = is_right && edge.size() == expected;
  });
  return is_right && next == wanted.size();
}

/// Turns triangles that hang together across edges to agree.
class Turner {
 public:
  Turner(std::vector<Triangle>& triangles, std::span<const double> outward)
      : triangles_(triangles),
        outward_(outward),
        neighbours_(triangles.size()),
        turns_(triangles.size(), Turn::unknown) {}

  [[nodiscard]] bool run(std::span<const Side> sides) {
    for_each_edge(sides, [&](std::span<const Side> edge) {
      if (edge.size() == 2) {
        const bool agree = edge[0].is_forward != edge[1].is_forward;
        neighbours_[edge[0].triangle].push_back({edge[1].triangle, agree});
        neighbours_[edge[1].triangle].push_back({edge[0].triangle, agree});
      }
    });
    for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
      if (turns_[f] == Turn::unknown && !turn_piece(f)) {
        return false;
      }
    }
    return true;
  }

 private:
  enum class Turn : std::uint8_t { unknown, kept, turned };
  struct Neighbour {
    std::uint32_t triangle;
    bool agrees;
  };

  /// Nothing is turned, and `false` returned, if it has one side only.
  bool turn_piece(std::uint32_t first) {
    std::vector<std::uint32_t> piece = {first};
    turns_[first] = Turn::kept;
    double sum = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::uint32_t f = piece[i];
      sum += turns_[f] == Turn::kept ? outward_[f] : -outward_[f];
      for (const Neighbour& neighbour : neighbours_[f]) {
        const Turn turn = (turns_[f] == Turn::kept) == neighbour.agrees ? Turn::kept : Turn::turned;
        Turn& theirs = turns_[neighbour.triangle];
        if (theirs == Turn::unknown) {
          piece.push_back(neighbour.triangle);
          theirs = turn;
        } else if (theirs != turn) {
          return false;
        }
      }
    }
    for (const std::uint32_t f : piece) {
      if ((turns_[f] == Turn::turned) == (sum >= 0)) {
        std::swap(triangles_[f][1], triangles_[f][2]);
      }
    }
    return true;
  }

  std::vector<Triangle>& triangles_;
  std::span<const double> outward_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<Turn> turns_;
};

}  // namespace

bool turn_outward(std::vector<Triangle>& triangles, std::span<const double> outward,
                  std::span<const BorderChain> chains) {
  const std::vector<Side> sides = sorted_sides(triangles);
  return has_borders(sides, chains) && Turner(triangles, outward).run(sides);
}

}  // namespace dupin::meshing
