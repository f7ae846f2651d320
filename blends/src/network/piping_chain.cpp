#include "network/piping_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dupin::network {
namespace {

// Of a leg of a bend: the pipe that stands in for a neighbour that the bend does not have.
constexpr double kStub = 0.1;

// Of the snap tolerance, by which either bend's tangent may be longer than its leg.
constexpr double kPipeBetweenBends = 3;

// Of an eccentric part's length along its axis, what it keeps where its ends are moved.
constexpr double kKeptLength = 0.5;
// Of the snap tolerance: joints may be as wide as that, and are moved by rounded coordinates.
constexpr double kAsWide = 1 + 1e-6;

Vec3 way(const PipingSpans& spans, const ChainElement& element) {
  return end_of(spans, element).point - begin_of(spans, element).point;
}

bool is_leg(const PipingSpans& spans, const ChainElement& element) {
  return spans.spans[element.span].role == SpanRole::bend_leg;
}

// Whether no end of the shorter stretch has to move by more than `snap` for both to have one axis.
bool is_straight(const Vec3& a, const Vec3& b, double snap) {
  const double lengths = a.norm() * b.norm();
  return a.dot(b) > 0 && a.cross(b).norm() * std::min(a.norm(), b.norm()) <= 2 * snap * lengths;
}

// A chain before it has axes: what lies between its elements is nothing, or a seam.
struct Links {
  std::vector<ChainElement> elements;
  std::vector<std::optional<Seam>> seams;  ///< one more than elements; none: they pass over
  bool is_closed = false;
};

class ChainMaker {
 public:
  ChainMaker(PipingSpans& spans, double snap) : spans_(spans), snap_(snap) {}

  Chain make(const std::vector<ChainElement>& elements, bool is_closed) {
    links_ = {elements, {}, is_closed};
    links_.seams.resize(elements.size() + 1);
    for (std::size_t i = 0; i <= elements.size(); ++i) {
      links_.seams[i] = first_seam(i);
    }
    find_offsets();
    do {
      replace_bends();
    } while (split_crooked() || part_offsets());
    return with_axes();
  }

 private:
  std::optional<Seam> first_seam(std::size_t i) const {
    if (i == 0 || i == links_.elements.size()) {
      return Seam{};
    }
    const ChainElement &before = links_.elements[i - 1], &after = links_.elements[i];
    const auto& end = end_of(spans_, before);
    if (is_leg(spans_, before) && spans_.spans[before.span].other_leg == after.span &&
        !before.is_reversed && after.is_reversed) {
      return Seam{SeamKind::corner, {}, {}};
    }
    if (spans_.pairs[*end.joint].distance > snap_) {
      return is_along_axis(before, after) ? std::nullopt
                                          : std::optional(Seam{SeamKind::bridge, {end.joint}, {}});
    }
    if (!is_straight(way(spans_, before), way(spans_, after), snap_)) {
      return Seam{SeamKind::kink, {end.joint}, {}};
    }
    return std::nullopt;
  }

  // Whether the ends lie apart along the axis that both have in common, straight parts or legs of
  // bends. A bend gives nothing of its arc, so that the pipe beside it has to do alone what both
  // do else, and two bends must leave room for a pipe.
  [[nodiscard]] bool is_along_axis(const ChainElement& before, const ChainElement& after) const {
    const Vec3 own = way(spans_, before), next = way(spans_, after);
    const Vec3 gap = begin_of(spans_, after).point - end_of(spans_, before).point;
    const bool is_beside_bend = is_leg(spans_, before) || is_leg(spans_, after);
    const double overlap = std::max(-gap.dot(own) / own.norm(), 0.0);
    const auto has_room = [&](const ChainElement& element) {
      return !spans_.spans[element.span].is_eccentric &&
             spans_.spans[element.span].length() >
                 (is_beside_bend ? 4 : 2) * std::max(overlap, snap_);
    };
    const bool is_between_bends = is_leg(spans_, before) && is_leg(spans_, after);
    return has_room(before) && has_room(after) && is_straight(own, next, snap_) &&
           gap.cross(own).norm() <= snap_ * own.norm() &&
           (!is_between_bends ||
            (gap.dot(own) > kPipeBetweenBends * snap_ * own.norm() &&
             spans_.spans[before.span].radii[0] == spans_.spans[after.span].radii[0]));
  }

  // A bend whose ends have different bores is no arc of one pipe.
  [[nodiscard]] bool has_two_bores(std::size_t i) const {
    return spans_.spans[links_.elements[i].span].radii[0] !=
           spans_.spans[links_.elements[i + 1].span].radii[0];
  }

  // Eccentric parts in a row are legs of their own where their neighbours go on beside their axes,
  // parallel to each other.
  void find_offsets() {
    for (std::size_t begin = 0; begin < links_.elements.size(); ++begin) {
      if (!is_eccentric(begin)) {
        continue;
      }
      std::size_t end = begin + 1;
      while (end < links_.elements.size() && is_eccentric(end) && meet(end)) {
        ++end;
      }
      if (const auto axis = axis_beside(begin, end)) {
        set_aside(begin, end, *axis);
      }
      begin = end - 1;
    }
  }

  [[nodiscard]] bool is_eccentric(std::size_t i) const {
    return spans_.spans[links_.elements[i].span].is_eccentric;
  }

  // Whether element i begins where the one before it ends.
  [[nodiscard]] bool meet(std::size_t i) const {
    const auto& seam = links_.seams[i];
    return !seam || seam->kind == SeamKind::kink;
  }

  // The direction of what is beside these elements, one or two that agree.
  [[nodiscard]] std::optional<Vec3> axis_beside(std::size_t begin, std::size_t end) const {
    if (!may_be_offset(begin) || !may_be_offset(end)) {
      return std::nullopt;
    }
    std::optional<Vec3> before, after;
    if (begin > 0 && !is_eccentric(begin - 1)) {
      before = way(spans_, links_.elements[begin - 1]);
    }
    if (end < links_.elements.size() && !is_eccentric(end)) {
      after = way(spans_, links_.elements[end]);
    }
    return before && after && !is_straight(*before, *after, snap_) ? std::nullopt
           : before                                                ? before
                                                                   : after;
  }

  // Those of them that lead along the axis, but not on it.
  void set_aside(std::size_t begin, std::size_t end, const Vec3& axis) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 own = way(spans_, links_.elements[i]);
      if (is_straight(axis, own, snap_) || !(axis.dot(own) > 0)) {
        continue;
      }
      for (const std::size_t k : {i, i + 1}) {
        auto& seam = links_.seams[k];
        if (!seam || seam->kind == SeamKind::kink || seam->kind == SeamKind::bridge) {
          seam = Seam{SeamKind::offset, {}, {}};
        }
      }
    }
  }

  [[nodiscard]] bool may_be_offset(std::size_t i) const {
    const auto& seam = links_.seams[i];
    return !seam || seam->kind == SeamKind::kink || seam->kind == SeamKind::end ||
           (seam->kind == SeamKind::bridge && is_beside_offset(i));
  }

  // Whether the gap before element i lies along the axis of the straight one of both, the other
  // being eccentric: a pipe on that axis bridges it.
  [[nodiscard]] bool is_beside_offset(std::size_t i) const {
    const ChainElement &before = links_.elements[i - 1], &after = links_.elements[i];
    const ChainElement& plain = spans_.spans[after.span].is_eccentric ? before : after;
    const Span& span = spans_.spans[plain.span];
    const Vec3 own = way(spans_, plain);
    const Vec3 gap = begin_of(spans_, after).point - end_of(spans_, before).point;
    const double overlap = std::max(-gap.dot(own) / own.norm(), 0.0);
    return !is_leg(spans_, plain) && !span.is_eccentric &&
           gap.cross(own).norm() <= snap_ * own.norm() &&
           span.length() > 4 * std::max(overlap, snap_);
  }

  // Bends that a neighbour does not meet as it should.
  void replace_bends() {
    for (std::size_t i = 0; i + 1 < links_.elements.size(); ++i) {
      const auto &before = links_.seams[i], &corner = links_.seams[i + 1],
                 &after = links_.seams[i + 2];
      const auto is_off = [](const std::optional<Seam>& seam) {
        return seam && is_blended(seam->kind);
      };
      if (corner && corner->kind == SeamKind::corner &&
          (is_off(before) || is_off(after) || has_two_bores(i))) {
        replace_bend(i);
      }
    }
  }

  // The elements at i and i + 1 are its legs.
  void replace_bend(std::size_t i) {
    const ChainElement in = links_.elements[i], out = links_.elements[i + 1];
    std::vector<ChainElement> stubs;
    std::vector<std::optional<Seam>> seams;
    Seam bend{SeamKind::bend, {}, spans_.spans[in.span].component};
    const bool has_before =
        i > 0 && !is_leg(spans_, links_.elements[i - 1]) && !is_offset(links_.seams[i]);
    const bool has_after = i + 2 < links_.elements.size() &&
                           !is_leg(spans_, links_.elements[i + 2]) &&
                           !is_offset(links_.seams[i + 2]);
    if (!has_before) {
      stubs.push_back(stub(in));
      seams.push_back(links_.seams[i]);
    } else {
      bend.joints[0] = begin_of(spans_, in).joint;
    }
    if (has_after) {
      bend.joints[1] = end_of(spans_, out).joint;
    }
    seams.emplace_back(bend);
    if (!has_after) {
      stubs.push_back(stub(out));
      seams.push_back(links_.seams[i + 2]);
    }
    const auto at = static_cast<std::ptrdiff_t>(i);
    links_.elements.erase(links_.elements.begin() + at, links_.elements.begin() + at + 2);
    links_.elements.insert(links_.elements.begin() + at, stubs.begin(), stubs.end());
    links_.seams.erase(links_.seams.begin() + at, links_.seams.begin() + at + 3);
    links_.seams.insert(links_.seams.begin() + at, seams.begin(), seams.end());
  }

  // A short pipe from the bend's end along its leg, which keeps the leg's joint.
  ChainElement stub(const ChainElement& leg) {
    Span span = spans_.spans[leg.span];
    span.name += leg.is_reversed ? "-stub2" : "-stub";
    span.role = SpanRole::straight;
    span.other_leg.reset();
    span.ends[1] = {span.ends[0].point + kStub * (span.ends[1].point - span.ends[0].point), {}, {}};
    spans_.spans.push_back(span);
    return {spans_.spans.size() - 1, leg.is_reversed};
  }

  // The point of the seam before element i: in the middle where two ends meet.
  [[nodiscard]] Vec3 node(std::size_t i, std::size_t begin, std::size_t end) const {
    if (i == begin) {
      return begin_of(spans_, links_.elements[i]).point;
    }
    if (i == end) {
      return end_of(spans_, links_.elements[i - 1]).point;
    }
    return (end_of(spans_, links_.elements[i - 1]).point +
            begin_of(spans_, links_.elements[i]).point) /
           2;
  }

  [[nodiscard]] std::size_t leg_end(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (!links_.seams[end]) {
      ++end;
    }
    return end;
  }

  // A leg with a point off its axis is two.
  bool split_crooked() {
    bool is_split = false;
    for (std::size_t begin = 0; begin < links_.elements.size();) {
      const std::size_t end = leg_end(begin);
      const Vec3 from = node(begin, begin, end);
      const Vec3 direction = (node(end, begin, end) - from).normalized();
      std::size_t worst = begin;
      double furthest = snap_;
      for (std::size_t i = begin + 1; i < end; ++i) {
        const double move = move_onto(from, direction, i, begin, end);
        if (!(move <= furthest)) {
          furthest = move;
          worst = i;
        }
      }
      if (worst != begin) {
        links_.seams[worst] = kink_at(worst);
        is_split = true;
      } else {
        begin = end;
      }
    }
    return is_split;
  }

  [[nodiscard]] Seam kink_at(std::size_t i) const {
    return {SeamKind::kink, {end_of(spans_, links_.elements[i - 1]).joint}, {}};
  }

  // How far the axis takes the ends that lie on it before element i. Those of a gap stay where they
  // are along it.
  [[nodiscard]] double move_onto(const Vec3& origin, const Vec3& direction, std::size_t i,
                                 std::size_t begin, std::size_t end) const {
    const double level = (node(i, begin, end) - origin).dot(direction);
    const auto move = [&](const SpanEnd& own) {
      const double own_level = (own.point - origin).dot(direction);
      const bool is_gap = own.joint && spans_.pairs[*own.joint].distance > snap_;
      return (origin + (is_gap ? own_level : level) * direction - own.point).norm();
    };
    return std::max(i > begin ? move(end_of(spans_, links_.elements[i - 1])) : 0,
                    i < end ? move(begin_of(spans_, links_.elements[i])) : 0);
  }

  // Eccentric parts that would take ends too far, for the circles that they share with their
  // neighbours, and for these to be parallel, are legs as others are.
  bool part_offsets() {
    if (std::ranges::none_of(links_.seams, is_offset)) {
      return false;
    }
    std::size_t begin = 0;
    for (const Leg& leg : with_axes().legs) {
      const std::size_t end = begin + leg.elements.size();
      if (leg.is_offset ? !is_kept(leg) : furthest_move(leg, begin, end) > kAsWide * snap_) {
        return part_nearest_offset(is_offset(links_.seams[end]) ? end : begin);
      }
      begin = end;
    }
    return false;
  }

  static bool is_offset(const std::optional<Seam>& seam) {
    return seam && seam->kind == SeamKind::offset;
  }

  [[nodiscard]] double furthest_move(const Leg& leg, std::size_t begin, std::size_t end) const {
    double result = 0;
    for (std::size_t i = begin; i <= end; ++i) {
      result = std::max(result, move_onto(leg.origin, leg.direction, i, begin, end));
    }
    return result;
  }

  // Whether both ends of an eccentric part stay near their places, and it most of its length.
  [[nodiscard]] bool is_kept(const Leg& leg) const {
    const Vec3 &from = begin_of(spans_, leg.elements[0]).point,
               &to = end_of(spans_, leg.elements[0]).point;
    const Vec3 way = leg.circles[1] - leg.circles[0];
    return (leg.circles[0] - from).norm() <= kAsWide * snap_ &&
           (leg.circles[1] - to).norm() <= kAsWide * snap_ &&
           way.dot(leg.direction) > kKeptLength * (to - from).dot(leg.direction);
  }

  // Those in a row about this seam, or the last ones before it, or the first ones behind it.
  bool part_nearest_offset(std::size_t begin) {
    while (begin > 0 && !is_offset(links_.seams[begin])) {
      --begin;
    }
    while (begin + 1 < links_.seams.size() && !is_offset(links_.seams[begin])) {
      ++begin;
    }
    while (begin > 0 && is_offset(links_.seams[begin - 1])) {
      --begin;
    }
    for (; begin < links_.seams.size() && is_offset(links_.seams[begin]); ++begin) {
      links_.seams[begin] = first_seam(begin);
    }
    return true;
  }

  // Of the legs in a row that eccentric parts lie between: that of the longest one that is more
  // than such a part, or of the last one.
  [[nodiscard]] Vec3 common_direction(std::size_t begin) const {
    Vec3 longest = Vec3::Zero();
    while (true) {
      const std::size_t end = leg_end(begin);
      const Vec3 own = node(end, begin, end) - node(begin, begin, end);
      const bool is_part = end == begin + 1 && is_eccentric(begin);
      if (!is_part && own.norm() > longest.norm()) {
        longest = own;
      }
      if (!is_offset(links_.seams[end])) {
        return (longest != Vec3::Zero() ? longest : own).normalized();
      }
      begin = end;
    }
  }

  // The leg that begins with this element. `common` is the direction of all that lie beside each
  // other; 0 if it lies beside none.
  [[nodiscard]] Leg leg_from(std::size_t begin, const Chain& before, const Vec3& common) const {
    const std::size_t end = leg_end(begin);
    Leg leg;
    leg.elements.assign(links_.elements.begin() + static_cast<std::ptrdiff_t>(begin),
                        links_.elements.begin() + static_cast<std::ptrdiff_t>(end));
    leg.origin = node(begin, begin, end);
    const bool is_behind_corner =
        !before.legs.empty() && before.seams.back().kind == SeamKind::corner;
    if (is_behind_corner) {
      const Leg& previous = before.legs.back();  // whose axis may have been given to it
      leg.origin = point_at(previous, previous.nodes.back());
    }
    const Vec3 along = node(end, begin, end) - leg.origin;
    const bool is_beside = common != Vec3::Zero();
    leg.direction = is_beside ? common : along.normalized();
    if (is_beside && end == begin + 1 && is_eccentric(begin)) {
      // Beside others that are, one may lead along the axis.
      const Vec3 own = way(spans_, leg.elements[0]);
      leg.is_offset = !is_straight(own, own.norm() * leg.direction, snap_);
    }
    if (is_beside && !leg.is_offset && !is_behind_corner) {  // its ends move by the same
      leg.origin += (along - along.dot(leg.direction) * leg.direction) / 2;
    }
    leg.nodes.reserve(end - begin + 1);
    for (std::size_t i = begin; i <= end; ++i) {
      leg.nodes.push_back((node(i, begin, end) - leg.origin).dot(leg.direction));
    }
    return leg;
  }

  [[nodiscard]] Chain with_axes() const {
    Chain chain;
    chain.seams.push_back(*links_.seams.front());
    Vec3 common = Vec3::Zero();
    for (std::size_t begin = 0; begin < links_.elements.size();) {
      const std::size_t end = leg_end(begin);
      if (!is_offset(links_.seams[begin])) {
        common = is_offset(links_.seams[end]) ? common_direction(begin) : Vec3::Zero();
      }
      chain.legs.push_back(leg_from(begin, chain, common));
      chain.seams.push_back(*links_.seams[end]);
      begin = end;
    }
    chain.is_closed = links_.is_closed;
    place_circles(chain);
    return chain;
  }

  // Of eccentric parts: where their neighbours begin and end, or on their axes where a gap lies
  // between.
  void place_circles(Chain& chain) const {
    const auto on_axis = [&](const Leg& leg, double level, const SpanEnd& own) {
      const bool is_gap = own.joint && spans_.pairs[*own.joint].distance > snap_;
      return point_at(leg, is_gap ? (own.point - leg.origin).dot(leg.direction) : level);
    };
    for (std::size_t k = 0; k < chain.legs.size(); ++k) {
      Leg& leg = chain.legs[k];
      if (!leg.is_offset) {
        continue;
      }
      const SpanEnd &from = begin_of(spans_, leg.elements[0]),
                    &to = end_of(spans_, leg.elements[0]);
      leg.circles = {from.point, to.point};
      if (chain.seams[k].kind == SeamKind::offset) {
        const Leg& previous = chain.legs[k - 1];
        leg.circles[0] = previous.is_offset ? previous.circles[1]
                                            : on_axis(previous, previous.nodes.back(), from);
      }
      if (chain.seams[k + 1].kind == SeamKind::offset && !chain.legs[k + 1].is_offset) {
        const Leg& next = chain.legs[k + 1];
        leg.circles[1] = on_axis(next, next.nodes.front(), to);
      }
    }
  }

  PipingSpans& spans_;
  double snap_;
  Links links_;
};

// Takes spans one by one along joints and corners.
class Walk {
 public:
  explicit Walk(const PipingSpans& spans) : spans_(spans), is_taken_(spans.spans.size()) {}

  // The chain that begins with this span; empty if it is taken already.
  std::vector<ChainElement> from(std::size_t span, bool is_reversed) {
    std::vector<ChainElement> elements;
    std::optional<ChainElement> next = ChainElement{span, is_reversed};
    while (next && !is_taken_[next->span]) {
      is_taken_[next->span] = true;
      elements.push_back(*next);
      next = after(*next);
    }
    return elements;
  }

  // The closed chain that ends with this span.
  std::vector<ChainElement> behind(std::size_t span) {
    const auto next = after({span, false});
    return from(next->span, next->is_reversed);
  }

  [[nodiscard]] bool is_taken(std::size_t span) const { return is_taken_[span]; }

  // Whether nothing is joined to the span at this end.
  [[nodiscard]] bool is_free(std::size_t span, std::size_t side) const {
    return !after({span, side == 0});
  }

 private:
  [[nodiscard]] std::optional<ChainElement> after(const ChainElement& element) const {
    const Span& span = spans_.spans[element.span];
    if (span.role == SpanRole::bend_leg && !element.is_reversed) {
      return ChainElement{*span.other_leg, true};
    }
    const auto next = spans_.joined(end_of(spans_, element));
    return next ? std::optional(ChainElement{(*next)[0], (*next)[1] == 1}) : std::nullopt;
  }

  const PipingSpans& spans_;
  std::vector<bool> is_taken_;
};

}  // namespace

bool is_blended(SeamKind kind) {
  return kind == SeamKind::kink || kind == SeamKind::bridge || kind == SeamKind::bend;
}

Vec3 point_at(const Leg& leg, double level) { return leg.origin + level * leg.direction; }

const SpanEnd& begin_of(const PipingSpans& spans, const ChainElement& element) {
  return spans.spans[element.span].ends[element.is_reversed ? 1 : 0];
}

const SpanEnd& end_of(const PipingSpans& spans, const ChainElement& element) {
  return spans.spans[element.span].ends[element.is_reversed ? 0 : 1];
}

std::vector<Chain> chains_of(PipingSpans& spans, double snap) {
  Walk walk(spans);
  ChainMaker maker(spans, snap);
  std::vector<std::vector<ChainElement>> open, closed;
  const std::size_t count = spans.spans.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (walk.is_free(i, side)) {
        open.push_back(walk.from(i, side == 1));
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (spans.spans[i].role == SpanRole::straight && !walk.is_taken(i)) {
      closed.push_back(walk.behind(i));
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    closed.push_back(walk.from(i, false));  // of bends alone
  }
  std::vector<Chain> result;
  for (const auto* group : {&open, &closed}) {
    for (const auto& elements : *group) {
      if (!elements.empty()) {
        result.push_back(maker.make(elements, group == &closed));
      }
    }
  }
  return result;
}

}  // namespace dupin::network
