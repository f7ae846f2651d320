#include "healing/lost_cells.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/self_contact.h"
#include "support/disjoint_sets.h"

namespace dupin::healing {
namespace {

class CellFinder {
 public:
  explicit CellFinder(const CellFaces& faces)
      : faces_(faces),
        mesh_(faces.points, faces.triangles),
        edges_(faces.triangles, faces.points.size()),
        sides_(2 * faces.triangles.size()) {}

  std::vector<LostCell> find() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      join_around(edges_[i]);
    }
    std::map<std::uint32_t, LostCell> cells;
    std::vector<std::uint8_t> is_solid(sides_of_all(), 0), is_open = is_solid,
                                                           walls_seen = is_solid;
    for (std::uint32_t side = 0; side < sides_of_all(); ++side) {
      const std::uint32_t cell = sides_.find(side);
      const bool is_boundary = solid_at(side) != solid_at(side ^ 1);
      if (solid_at(side)) {
        is_solid[cell] = 1;
      }
      if (is_boundary) {
        walls_seen[cell] |= is_turned(side / 2) ? kTurned : kOther;
      } else {
        is_open[cell] = 1;
      }
      cells[cell].walls.push_back({side / 2, side % 2 == 0});
    }
    std::vector<std::uint8_t> is_between(sides_of_all(), 0);
    for (const std::uint32_t side : between_) {
      is_between[sides_.find(side)] = 1;
    }
    spread_over_open_faces(cells, is_solid);
    std::vector<LostCell> lost;
    for (auto& [cell, found] : cells) {
      const bool was_empty =
          !faces_.is_turned.empty() && (walls_seen[cell] == kTurned || walls_seen[cell] == kOther);
      if (is_solid[cell] == 0 && is_open[cell] != 0 && !was_empty && is_bounded(found.walls)) {
        found.is_of_bodies = walls_seen[cell] == 0 || is_between[cell] != 0;
        lost.push_back(std::move(found));
      }
    }
    return lost;
  }

 private:
  static constexpr std::uint8_t kTurned = 1, kOther = 2;  // walls

  [[nodiscard]] bool is_turned(std::uint32_t face) const {
    return !faces_.is_turned.empty() && faces_.is_turned[face] != 0;
  }

  // 2f is the front of a face, 2f + 1 what is behind it.
  [[nodiscard]] std::size_t sides_of_all() const { return 2 * faces_.triangles.size(); }
  [[nodiscard]] bool solid_at(std::uint32_t side) const {
    return (side % 2 == 0 ? faces_.solid_in_front : faces_.solid_behind)[side / 2] != 0;
  }

  // A cell that is not known to be lost, as that of a cavity, may be part of a larger one.
  void spread_over_open_faces(const std::map<std::uint32_t, LostCell>& cells,
                              std::vector<std::uint8_t>& is_solid) {
    std::vector<std::uint32_t> queue;
    for (const auto& [cell, found] : cells) {
      if (is_solid[cell] != 0 && is_bounded(found.walls)) {
        queue.push_back(cell);
      }
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const auto& [face, is_turned] : cells.at(queue[i]).walls) {
        const std::uint32_t beyond = sides_.find(2 * face + (is_turned ? 1 : 0));
        if (!solid_at(2 * face) && !solid_at(2 * face + 1) && is_solid[beyond] == 0) {
          is_solid[beyond] = 1;
          if (is_bounded(cells.at(beyond).walls)) {
            queue.push_back(beyond);
          }
        }
      }
    }
  }

  // What is between one face and the next. Counter-clockwise of one that runs up is its front.
  void join_around(const mesh::Edge& edge) {
    const auto around = mesh::sorted_around(mesh_, edges_, edge);
    const auto side = [&](std::uint32_t h, bool after) {
      const bool is_up = edges_.origin(h) < edges_.target(h);
      return 2 * (h / 3) + (is_up == after ? 0 : 1);
    };
    std::vector<std::uint32_t> empty;
    std::size_t solid_ends = 0;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const std::uint32_t after = side(around[k], true);
      sides_.unite(after, side(around[(k + 1) % around.size()], false));
      if (!solid_at(after)) {
        empty.push_back(after);
        solid_ends += solid_at(after ^ 1) ? 1 : 0;
      }
    }
    if (solid_ends > 1) {
      between_.insert(between_.end(), empty.begin(), empty.end());
    }
  }

  [[nodiscard]] bool is_bounded(const std::vector<CellFace>& walls) const {
    std::vector<Triangle> surface;
    for (const CellFace& wall : walls) {
      surface.push_back(faces_.triangles[wall.face]);
      if (wall.is_turned) {
        std::swap(surface.back()[1], surface.back()[2]);
      }
    }
    return mesh::volume_sign({faces_.points, surface}) > 0;
  }

  CellFaces faces_;
  mesh::MeshView mesh_;
  mesh::EdgeTable edges_;
  support::DisjointSets sides_;
  std::vector<std::uint32_t> between_;  // sides where the solid touches itself
};

}  // namespace

std::vector<LostCell> find_lost_cells(const CellFaces& faces) { return CellFinder(faces).find(); }

}  // namespace dupin::healing
