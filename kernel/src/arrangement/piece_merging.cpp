#include "arrangement/piece_merging.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <tbb/enumerable_thread_specific.h>

#include "arrangement/faces/constrained_triangulation.h"
#include "arrangement/points/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"
#include "dupin/kernel/error.h"
#include "mesh/edge_table.h"
#include "support/disjoint_sets.h"

namespace dupin::arrangement {
namespace {

using Kept = support::BulkVector<OutputTriangle>;
using Piece = std::vector<std::uint32_t>;  // kept triangles, ascending

std::vector<Triangle> corners_of(const Kept& kept) {
  std::vector<Triangle> corners(kept.size());
  std::transform(kept.begin(), kept.end(), corners.begin(),
                 [](const OutputTriangle& t) { return t.corners; });
  return corners;
}

// Which triangles are pieces of the same, and which points stay.
class Borders {
 public:
  Borders(const ArrangementInput& input, const Kept& kept)
      : input_(input),
        kept_(kept),
        corners_(corners_of(kept)),
        edges_(corners_, input.points.size()),
        pieces_(kept.size()),
        is_border_(3 * kept.size(), 0),
        at_(input.points.size()) {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      add(edges_[e]);
    }
    support::for_each_block(at_.size(), [&](const support::Block& block) {
      const UpwardRounding rounding;
      for (std::size_t i = block.begin; i < block.end; ++i) {
        at_[i].goes = is_superfluous(static_cast<PointId>(i));
      }
    });
  }

  [[nodiscard]] bool goes(PointId point) const { return at_[point].goes; }

  [[nodiscard]] std::vector<Piece> pieces() {
    std::vector<Piece> result;
    std::vector<std::uint32_t> number(kept_.size(), kNone);
    for (std::uint32_t t = 0; t < kept_.size(); ++t) {
      std::uint32_t& n = number[pieces_.find(t)];
      if (n == kNone) {
        n = static_cast<std::uint32_t>(result.size());
        result.emplace_back();
      }
      result[n].push_back(t);
    }
    return result;
  }

  // Calls visit(from, to) for each straight border of the piece between points that stay.
  template <class Visit>
  void for_each_border(const Piece& piece, const Visit& visit) const {
    for (const std::uint32_t t : piece) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const PointId from = edges_.origin(h);
        if (!is_border_[h] || goes(from)) {
          continue;
        }
        PointId previous = from, to = edges_.target(h);
        while (goes(to)) {
          const auto& ends = at_[to].neighbours;
          previous = std::exchange(to, ends[0] == previous ? ends[1] : ends[0]);
        }
        visit(from, to);
      }
    }
  }

 private:
  struct At {  // a point
    std::uint32_t borders = 0;
    bool stays = false, goes = false;
    std::array<PointId, 2> neighbours{};   // along the first two borders
    std::array<std::uint32_t, 2> faces{};  // on both sides of one of them
  };

  [[nodiscard]] Source origin_of(std::uint32_t t) const {
    const std::uint32_t source = kept_[t].source, operand = input_.operand_of(source);
    return input_.operands[operand]->sources[source - input_.first_triangle[operand]];
  }

  void add(const mesh::Edge& edge) {
    const auto& h = edge.half_edges;
    const bool is_simple = h.size() == 2 && edges_.origin(h[0]) != edges_.origin(h[1]);
    if (is_simple && origin_of(h[0] / 3) == origin_of(h[1] / 3)) {
      pieces_.unite(h[0] / 3, h[1] / 3);
      return;
    }
    for (const std::uint32_t half_edge : h) {
      is_border_[half_edge] = 1;
    }
    for (const auto& [point, other] : {std::pair(edge.low, edge.high), {edge.high, edge.low}}) {
      At& at = at_[point];
      if (at.borders < 2) {
        at.neighbours[at.borders] = other;
      }
      ++at.borders;
      at.stays = at.stays || !is_simple;
      at.faces = {h.front() / 3, h.back() / 3};
    }
  }

  [[nodiscard]] bool is_superfluous(PointId point) const {
    const At& at = at_[point];
    if (at.borders == 0) {
      return true;
    }
    return at.borders == 2 && !at.stays && is_straight(point, at);
  }

  [[nodiscard]] bool is_straight(PointId point, const At& at) const {
    const Triangle &first = input_.support(kept_[at.faces[0]].support),
                   &second = input_.support(kept_[at.faces[1]].support);
    const auto lies_off = [&](PointId p) {
      return side_of_plane(input_.points, first[0], first[1], first[2], p) != 0;
    };
    return std::any_of(second.begin(), second.end(), lies_off) ||
           turn(input_.points, at.neighbours[0], point, at.neighbours[1],
                projection_of(input_.points, first).axis) == 0;
  }

  const ArrangementInput& input_;
  const Kept& kept_;
  std::vector<Triangle> corners_;
  mesh::EdgeTable edges_;
  support::DisjointSets pieces_;
  std::vector<std::uint8_t> is_border_;  // per half-edge
  std::vector<At> at_;
};

// Triangulates piece after piece without the points that go.
class PieceTriangulator {
 public:
  PieceTriangulator(const ArrangementInput& input, const Kept& kept, const Borders& borders)
      : input_(input),
        kept_(kept),
        borders_(borders),
        triangulation_(input.points,
                       {[](std::uint32_t, std::uint32_t) -> ImplicitPoint {
                          throw Error(Errc::internal,
                                      "internal error, please report it: borders "
                                      "of a piece cross each other");
                        },
                        [](std::uint32_t present, std::uint32_t) { return present; }}) {}

  void append(const Piece& piece, std::vector<OutputTriangle>& result) {
    if (std::none_of(piece.begin(), piece.end(), [this](std::uint32_t t) { return loses(t); })) {
      std::transform(piece.begin(), piece.end(), std::back_inserter(result),
                     [this](std::uint32_t t) { return kept_[t]; });
      return;
    }
    collect_points(piece);
    const Triangle& support = input_.support(kept_[piece[0]].support);
    triangulation_.clear(projection_of(input_.points, support));
    triangulation_.start_around(ids_);
    for (const PointId id : ids_) {
      triangulation_.insert(triangulation_.add(id));
    }
    constrain_borders(piece);
    triangulation_.improve(support);
    find_inside();
    emit(kept_[piece[0]], result);
  }

 private:
  using Vertex = ConstrainedTriangulation::Vertex;
  static constexpr Vertex kFirst = 3;  // behind the corners of the frame

  // Whether a corner of the triangle goes.
  [[nodiscard]] bool loses(std::uint32_t t) const {
    const Triangle& corners = kept_[t].corners;
    return std::any_of(corners.begin(), corners.end(),
                       [this](PointId id) { return borders_.goes(id); });
  }

  void collect_points(const Piece& piece) {
    ids_.clear();
    for (const std::uint32_t t : piece) {
      std::copy_if(kept_[t].corners.begin(), kept_[t].corners.end(), std::back_inserter(ids_),
                   [this](PointId id) { return !borders_.goes(id); });
    }
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  }

  [[nodiscard]] Vertex vertex(PointId id) const {
    const auto i = std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin();
    return kFirst + static_cast<Vertex>(i);
  }

  // A border with the piece on both sides of it, where the surface touches itself, bounds nothing.
  void constrain_borders(const Piece& piece) {
    lines_.clear();
    borders_.for_each_border(
        piece, [this](PointId from, PointId to) { lines_.push_back(edge_key(from, to)); });
    std::sort(lines_.begin(), lines_.end());
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      if (i == 0 || lines_[i] != lines_[i - 1]) {
        triangulation_.constrain(vertex(lower_end(lines_[i])), vertex(upper_end(lines_[i])), i);
      }
    }
  }
  [[nodiscard]] bool bounds(std::uint32_t slot) const {
    return slot != kNone && (slot + 1 == lines_.size() || lines_[slot] != lines_[slot + 1]);
  }

  // From the frame, which is outside: each border leads to the other side.
  void find_inside() {
    const auto& faces = triangulation_.faces();
    inside_.assign(faces.size(), kUnknown);
    queue_.assign(1, triangulation_.face_at_frame());
    inside_[queue_[0]] = 0;
    for (std::size_t q = 0; q < queue_.size(); ++q) {
      const ConstrainedTriangulation::Face& face = faces[queue_[q]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t n = face.neighbours[k];
        if (n != kNone && inside_[n] == kUnknown) {
          inside_[n] = static_cast<std::uint8_t>(inside_[queue_[q]] ^ int{bounds(face.slots[k])});
          queue_.push_back(n);
        }
      }
    }
  }

  void emit(const OutputTriangle& first, std::vector<OutputTriangle>& result) const {
    const auto& faces = triangulation_.faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (inside_[f] != 1) {
        continue;
      }
      OutputTriangle triangle = first;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.corners[k] = triangulation_.point(faces[f].corners[k]);
      }
      if (first.reversed) {
        std::swap(triangle.corners[1], triangle.corners[2]);
      }
      result.push_back(triangle);
    }
  }

  static constexpr std::uint8_t kUnknown = 2;
  const ArrangementInput& input_;
  const Kept& kept_;
  const Borders& borders_;
  ConstrainedTriangulation triangulation_;
  // Of the present piece:
  std::vector<PointId> ids_;
  std::vector<EdgeKey> lines_;
  std::vector<std::uint8_t> inside_;
  std::vector<std::uint32_t> queue_;
};

}  // namespace

Kept merge_pieces(const ArrangementInput& input, const Kept& kept) {
  Borders borders(input, kept);
  const std::vector<Piece> pieces = borders.pieces();
  constexpr std::size_t kBatch = 32;
  std::vector<std::vector<OutputTriangle>> batches(support::block_count(pieces.size(), kBatch));
  tbb::enumerable_thread_specific<PieceTriangulator> triangulators(
      [&] { return PieceTriangulator(input, kept, borders); });
  support::for_each_block(
      pieces.size(),
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        PieceTriangulator& triangulator = triangulators.local();
        for (std::size_t i = block.begin; i < block.end; ++i) {
          triangulator.append(pieces[i], batches[block.number]);
        }
      },
      kBatch);
  const std::vector<OutputTriangle> all = support::joined(std::move(batches));
  Kept result(all.size());
  std::copy(all.begin(), all.end(), result.begin());
  return result;
}

}  // namespace dupin::arrangement
