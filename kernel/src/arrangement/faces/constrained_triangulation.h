#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/points/implicit_points.h"
#include "arrangement/points/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {

/// A constrained triangulation of points of one plane, in projection along an axis, exact. The
/// vertices lie in the triangle it starts from.
///
/// Where these conditions do not hold, as no bug-free caller has it, insert() and constrain() throw
/// Error{internal} with the place; no loop is without a bound.
///
/// Constraints carry a slot (a number that means something to the caller). Where two cross, a
/// vertex is made.
class ConstrainedTriangulation {
 public:
  using Vertex = std::uint32_t;
  struct Face {
    std::array<Vertex, 3> corners;
    std::array<std::uint32_t, 3> neighbours;  ///< across the edge opposite to each corner, or kNone
    std::array<std::uint32_t, 3> slots;       ///< of that edge, or kNone
  };
  using NewPoint = DefinedPoint;
  struct Caller {
    /// The point where constraints of two slots cross.
    std::function<ImplicitPoint(std::uint32_t, std::uint32_t)> crossing;
    /// The slot of a segment on which two constraints lie: of `present`, then of `added`.
    std::function<std::uint32_t(std::uint32_t, std::uint32_t)> both;
  };

  ConstrainedTriangulation(const PointTable& points, Caller caller);
  /// Empties it, for another plane.
  void clear(const Projection& projection);

  /// A set of lines, one bit each, that a vertex is known to lie on: three vertices with a common
  /// bit are collinear. New vertices get theirs, and others more, from those that are in line.
  using Lines = std::uint64_t;
  /// Makes a vertex without inserting it.
  Vertex add(PointId id, Lines lines = 0);
  /// The triangle that holds all other vertices, counter-clockwise in the projection.
  void start(Vertex a, Vertex b, Vertex c) { add_face(a, b, c); }
  /// A triangle around these points instead: a frame of three vertices that stand for no points.
  void start_around(std::span<const PointId> ids);
  /// A triangulated polygon instead, of all vertices: each triangle is cut off what the ones before
  /// leave of it, at its second corner; at the last one's, nothing is left.
  void start(std::span<const std::array<Vertex, 3>> ears);
  void insert(Vertex p);
  void constrain(Vertex a, Vertex b, std::uint32_t slot);
  /// Flips edges without constraint towards Delaunay, as far as doubles can tell. Vertices that are
  /// inserted after it leave that so, until the next clear().
  void improve(const Triangle& support);

  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  /// The sign of the turn from the way a to b to that from a to c, seen from the front.
  [[nodiscard]] int turn(Vertex a, Vertex b, Vertex c) const {
    const FilteredSign filtered = filtered_turn(a, b, c);
    return filtered.certain ? filtered.sign : exact_turn(a, b, c);
  }
  /// The same if intervals tell, else 0.
  [[nodiscard]] int certain_turn(Vertex a, Vertex b, Vertex c) const {
    const FilteredSign filtered = filtered_turn(a, b, c);
    return filtered.certain ? filtered.sign : 0;
  }
  /// Where a vertex lies in the projection.
  [[nodiscard]] const std::array<Interval, 2>& intervals(Vertex v) const { return intervals_[v]; }
  /// The point of a vertex; with kNewPoint set, an index into new_points();
  /// from kFirstFrameCorner on, a corner of the frame.
  [[nodiscard]] PointId point(Vertex v) const { return vertices_[v].id; }
  /// A face with a corner of the frame.
  [[nodiscard]] std::uint32_t face_at_frame() const;
  [[nodiscard]] std::vector<NewPoint>& new_points() { return new_points_; }
  static constexpr PointId kNewPoint = 0x80000000u;
  static constexpr PointId kFirstFrameCorner = kNone - 3;

 private:
  struct VertexData {
    double u, v;  ///< middles of its intervals
    PointId id;
    std::uint32_t face;  ///< one that has it as a corner
    Lines lines;
  };
  struct Location {
    std::uint32_t face;
    int corner;  ///< the edge opposite to it, or it itself; -1 inside the face
    bool at_corner;
  };
  struct Link {  // of a chain along a cavity: a vertex, and what lies beyond the edge to the next
    Vertex vertex;
    std::uint32_t outer, slot;
    bool is_fresh;  ///< `outer` was made while filling the cavity
  };
  struct Dangling {
    Vertex from, to;
    std::uint32_t face;
  };

  Vertex add_frame_corner(const Eigen::Vector2d& place);
  Vertex add_vertex(const Interval& u, const Interval& v, PointId id, Lines lines);
  [[nodiscard]] FilteredSign filtered_turn(Vertex a, Vertex b, Vertex c) const {
    const VertexData &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
    if ((p.lines & q.lines & r.lines) != 0) {
      return {0, true};
    }
    const double value = (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
    if (std::abs(value) > turn_bound_) {
      return {value > 0 ? projection_.orientation : -projection_.orientation, true};
    }
    const auto& [pu, pv] = intervals_[a];
    const auto& [qu, qv] = intervals_[b];
    const auto& [ru, rv] = intervals_[c];
    const FilteredSign filtered = sign_of((qu - pu) * (rv - pv) - (qv - pv) * (ru - pu));
    return {projection_.orientation * filtered.sign, filtered.certain};
  }
  [[nodiscard]] int exact_turn(Vertex a, Vertex b, Vertex c) const;
  /// The third one has been found to be in line with the two.
  void align(Vertex a, Vertex b, Vertex on) const {
    vertices_[on].lines |= vertices_[a].lines & vertices_[b].lines;
  }
  const mesh::ExactPoint& exact(Vertex v, mesh::ExactPoint& scratch) const;
  [[nodiscard]] exact::BallPoint ball(Vertex v) const;
  /// Within rounding; of a corner of the frame, in the projection.
  [[nodiscard]] Vec3 approximation(Vertex v) const;
  [[nodiscard]] Location locate(Vertex p);
  [[nodiscard]] Location search(Vertex p) const;
  [[nodiscard]] static Location location_in(std::uint32_t face, const std::array<int, 3>& sides);
  [[noreturn]] void fail(Vertex v, const char* what) const;
  void split_face(std::uint32_t face, Vertex p);
  void split_edge(std::uint32_t face, int corner, Vertex p);
  void connect(std::uint32_t face, int corner, std::uint32_t neighbour, std::uint32_t slot);
  std::uint32_t add_face(Vertex a, Vertex b, Vertex c);
  void set_face(std::uint32_t face, Vertex a, Vertex b, Vertex c);
  [[nodiscard]] int corner_of(std::uint32_t face, Vertex v) const {
    const auto& c = faces_[face].corners;
    return c[0] == v ? 0 : c[1] == v ? 1 : 2;
  }
  [[nodiscard]] int corner_facing(std::uint32_t face, std::uint32_t neighbour) const {
    const auto& n = faces_[face].neighbours;
    return n[0] == neighbour ? 0 : n[1] == neighbour ? 1 : 2;
  }
  void mark(std::uint32_t face, int corner, std::uint32_t slot);
  /// Advances from `a` towards `b` by one vertex, constraining the way; returns that vertex.
  Vertex advance(Vertex a, Vertex b, std::uint32_t slot);
  Vertex cross(std::uint32_t face, int corner, Vertex a, Vertex b, std::uint32_t slot);
  Vertex split_crossed_edge(std::uint32_t face, int corner, std::uint32_t slot);
  void fill_cavity(std::uint32_t slot);
  std::uint32_t fill(const std::vector<Link>& chain, bool is_left);
  void attach(std::uint32_t face, int corner, const Link& link);
  void flip(std::uint32_t face, int corner);
  /// Puts the edges of faces among those that may be flipped.
  void push_edges(std::size_t begin, std::size_t end);
  /// Of these, and what changes for it; vertices are at place(vertex).
  template <class Place>
  void flip_towards_delaunay(const Place& place, bool also_at_frame);
  [[nodiscard]] std::uint32_t next_random();

  const PointTable& points_;
  Projection projection_;
  Caller caller_;
  mutable std::vector<VertexData> vertices_;        // for their lines
  std::vector<std::array<Interval, 2>> intervals_;  // of vertices
  // Of vertices' middles from that of the first, of intervals about their middles, and of what a
  // turn in doubles may be off.
  double reach_ = 0, radius_ = 0, turn_bound_ = 0;
  std::vector<std::uint32_t> after_;  // the face beyond the edge from each corner of what is left
  std::vector<Face> faces_;
  mutable std::vector<NewPoint> new_points_;
  mutable std::vector<std::optional<exact::BallPoint>>
      balls_;  // of them, as far as they were asked for
  std::vector<Vec3> frame_corners_;
  // How many more turns were such as only exact numbers tell than such as balls do: where by that
  // many most points are collinear, balls are not tried.
  static constexpr int kMostCollinear = 32;
  mutable int collinear_ = 0;
  bool is_improved_ = false;
  std::uint32_t hint_ = 0, random_ = 1;
  std::vector<std::uint32_t> cavity_, spare_;
  std::vector<std::uint8_t> in_cavity_;
  std::vector<Link> left_, right_, stack_;
  std::vector<Dangling> dangling_;
  std::vector<std::array<double, 2>> planar_;
  std::vector<std::pair<std::uint32_t, int>> edges_;
};

}  // namespace dupin::arrangement
