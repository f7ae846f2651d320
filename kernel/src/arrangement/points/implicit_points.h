#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <CGAL/Interval_nt.h>

#include "exact/ball.h"
#include "mesh/exact_mesh.h"
#include "support/bulk_vector.h"
#include "support/none.h"

namespace dupin::arrangement {

using PointId = std::uint32_t;
using support::kNone;

using Interval = CGAL::Interval_nt<false>;
using IntervalPoint = std::array<Interval, 3>;

/// Intervals are valid only while one of these lives in the thread.
using UpwardRounding = CGAL::Protect_FPU_rounding<true>;

/// How a point follows from others [Att20].
struct ImplicitPoint {
  enum class Kind : std::uint8_t {
    given,         ///< exact coordinates were handed in
    line_plane,    ///< the line through of[0..1] meets the plane through of[2..4]
    two_lines,     ///< coplanar lines through of[0..1] and of[2..3], seen along `axis`
    three_planes,  ///< the planes through of[0..2], of[3..5] and of[6..8]
  };
  Kind kind = Kind::given;
  std::uint8_t axis = 0;
  std::array<PointId, 9> of{};

  friend bool operator==(const ImplicitPoint&, const ImplicitPoint&) = default;
};

/// A point not yet in a table.
struct DefinedPoint {
  ImplicitPoint definition;
  IntervalPoint box;
  mesh::ExactPoint exact;  ///< of zero weight unless it was needed
};

/// Coordinates computed on first use, by whichever thread comes first.
template <class Point>
class Lazy {
 public:
  Lazy() = default;
  explicit Lazy(const Point& point) : value_(new Point(point)) {}
  Lazy(Lazy&& other) noexcept : value_(other.value_.exchange(nullptr)) {}
  Lazy& operator=(Lazy&& other) noexcept {
    delete value_.exchange(other.value_.exchange(nullptr));
    return *this;
  }
  Lazy(const Lazy&) = delete;
  Lazy& operator=(const Lazy&) = delete;
  ~Lazy() { delete value_.load(); }

  /// Null if not computed yet.
  [[nodiscard]] const Point* known() const { return value_.load(std::memory_order_acquire); }
  template <class Compute>
  const Point& get(Compute&& compute) const {
    const Point* known = value_.load(std::memory_order_acquire);
    if (known == nullptr) {
      auto fresh = std::make_unique<const Point>(compute());
      if (value_.compare_exchange_strong(known, fresh.get(), std::memory_order_acq_rel)) {
        known = fresh.release();
      }
    }
    return *known;
  }

 private:
  mutable std::atomic<const Point*> value_{nullptr};
};

/// All points of an arrangement: first those that doubles hold, then those known by definition, as
/// intervals and, on demand, as exact homogeneous coordinates.
class PointTable {
 public:
  /// Doubles may be added only before the first other point.
  PointId add(const Vec3& point);
  PointId add(const mesh::ExactPoint& point);
  PointId add(const ImplicitPoint& definition);
  /// Makes room for points that any threads may define, by points before these.
  void add_undefined(std::size_t count);
  void define(PointId id, const ImplicitPoint& definition);
  PointId add(DefinedPoint point);
  void remove_last() { implicit_.pop_back(); }
  /// Makes room for points that doubles hold, to be set by any threads.
  void set_double_count(std::size_t count) { doubles_.resize(count); }
  void set(PointId id, const Vec3& point) { doubles_[id] = point; }

  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(doubles_.size() + implicit_.size());
  }
  [[nodiscard]] std::uint32_t double_count() const {
    return static_cast<std::uint32_t>(doubles_.size());
  }
  [[nodiscard]] bool is_double(PointId id) const { return id < doubles_.size(); }
  [[nodiscard]] const Vec3& coordinates(PointId id) const { return doubles_[id]; }
  [[nodiscard]] Interval interval(PointId id, int axis) const {
    return is_double(id) ? Interval(doubles_[id][axis])
                         : implicit_[id - doubles_.size()].box[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] IntervalPoint interval(PointId id) const {
    return {interval(id, 0), interval(id, 1), interval(id, 2)};
  }
  /// A point within rounding of it, for choices that need not be right.
  [[nodiscard]] Vec3 approximation(PointId id) const;
  [[nodiscard]] const ImplicitPoint& definition(PointId id) const {
    return implicit_[id - doubles_.size()].definition;
  }
  /// Whether the points are the same by the same definition.
  [[nodiscard]] bool are_defined_alike(PointId a, PointId b) const {
    return !is_double(a) && !is_double(b) && definition(a).kind != ImplicitPoint::Kind::given &&
           definition(a) == definition(b);
  }
  /// Positive last coordinate. `scratch` holds the result where it is not kept.
  [[nodiscard]] const mesh::ExactPoint& exact(PointId id, mesh::ExactPoint& scratch) const;
  /// The same, without keeping it.
  [[nodiscard]] mesh::ExactPoint exact_value(PointId id) const;
  /// Whether the definition, by doubles, of a point that is not a double says the line and the
  /// plane that it is of, and these.
  [[nodiscard]] bool is_meeting(PointId id) const;
  [[nodiscard]] mesh::LinePlaneMeeting meeting(PointId id) const;
  /// To about 100 bits; needs UpwardRounding.
  [[nodiscard]] exact::BallPoint ball(PointId id) const;
  /// To make room, once few are asked for any more.
  void forget_balls();
  /// Coordinates to within a few ulp; replaces a wide interval by that of the exact point.
  void tighten(PointId id);

 private:
  struct Implicit {
    ImplicitPoint definition;
    IntervalPoint box;
    Lazy<mesh::ExactPoint> exact;
    Lazy<exact::BallPoint> ball;
  };
  void make_room(std::size_t count);
  PointId append(Implicit point);

  support::BulkVector<Vec3> doubles_;
  std::vector<Implicit> implicit_;
};

/// Exact coordinates of a point by its definition; not `given`.
[[nodiscard]] mesh::ExactPoint evaluate_exact(const PointTable& points,
                                              const ImplicitPoint& definition);
/// An enclosure of the point; needs UpwardRounding.
[[nodiscard]] IntervalPoint evaluate(const PointTable& points, const ImplicitPoint& definition);
[[nodiscard]] exact::BallPoint evaluate_ball(const PointTable& points,
                                             const ImplicitPoint& definition);
/// An enclosure of exact coordinates, each within a few ulp; needs UpwardRounding.
[[nodiscard]] IntervalPoint enclose(const mesh::ExactPoint& point);

}  // namespace dupin::arrangement
