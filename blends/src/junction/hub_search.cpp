#include "junction/hub_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "junction/collar.h"
#include "junction/separation.h"
#include "numbers/angle.h"

namespace dupin::junction {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWidestCap = 75 * kDegree, kWidestGap = 4 * kDegree;
// Least power of a collar's start, by the radii of the hub and the cap's circle, that looks good:
// on the way to the centre, of a cap of the angle a that is k times as wide as the pipe, it is
// about 2 (1 - 1 / k) for small a.
constexpr double kGoodPower = 0.2;
// Shorter straight pieces, by the radius, are none.
constexpr double kShortest = 1.0 / 64;

std::string degrees(double angle) { return decimal(angle / kDegree, 3) + " degrees"; }

std::string named(std::size_t end) { return "end " + std::to_string(end + 1); }

struct Fault {
  std::string reason;
  std::optional<std::size_t> end = {};
  int progress = 0;  // how much else was found to be well
  bool is_want_of_room = false;
};

// An attempt at one hub.
struct Attempt {
  std::vector<double> ways;  // from the ends along their cones, negative where there is no room
  std::optional<Fault> fault;
};

// By which part more ends are moved back than they have to be.
constexpr double kSpare = 1e-6;

JunctionSearch too_near(std::vector<double> setbacks) {
  const auto worst = std::ranges::max_element(setbacks);
  const auto end = std::size_t(worst - setbacks.begin());
  std::string reason = named(end) + " is too near to the hub's centre: it would have to be " +
                       decimal_at_least(*worst) + " further back";
  const auto others = std::ranges::count_if(setbacks, [](double s) { return s > 0; }) - 1;
  if (others > 0) {
    reason += ", and " + std::to_string(others) + " more " + (others == 1 ? "end" : "ends") +
              " by at most as much";
  }
  return {{}, std::move(reason), end, std::move(setbacks)};
}

// Angle between two ends, seen from the centre.
double angle_between(const Approach& one, const Approach& other, const Vec3& center) {
  const Vec3 a = one.end.center - center, b = other.end.center - center;
  return numbers::angle_between(a, b);
}

// That two ends want the same place on the hub.
JunctionSearch crowded(std::span<const Approach> ends, const Vec3& center) {
  std::array<std::size_t, 2> closest{0, 1};
  const auto between = [&](std::size_t i, std::size_t k) {
    return angle_between(ends[i], ends[k], center);
  };
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (between(k, i) < between(closest[0], closest[1])) {
        closest = {k, i};
      }
    }
  }
  return {{},
          "no hub has room for a cap each of " + named(closest[0]) + " and " + named(closest[1]) +
              ", which lie in directions only " + degrees(between(closest[0], closest[1])) +
              " apart, seen from there: move them apart, or join them before",
          closest[1]};
}

class HubSearch {
 public:
  HubSearch(std::span<const Approach> ends, const Vec3& center, const JunctionOptions& options)
      : ends_(ends),
        center_(center),
        options_(options),
        good_power_(options.radius ? 0 : kGoodPower) {}

  /// Nothing is news then.
  void be_silent() { fault_ = Fault{{}, {}, std::numeric_limits<int>::max()}; }

  JunctionSearch run() {
    if (auto fault = directions_fault()) {
      return refused(*fault);
    }
    if (options_.smoothness == 1) {
      return smooth(std::vector<double>(ends_.size(), 0), thickest() * 0.8);
    }
    JunctionSearch compact = search_compact();
    if (!compact.junction || options_.smoothness == 0) {
      return compact;
    }
    std::vector<double> ways;
    for (const JunctionArm& arm : compact.junction->arms) {
      ways.push_back((1 - options_.smoothness) * straight_length(arm));
    }
    return smooth(without_short(std::move(ways)), compact.junction->hub.radius);
  }

 private:
  static constexpr const char* kFreeRemedy = ": ends further apart, or another centre, may do";
  static constexpr double kStep = 1.01;
  static constexpr int kSteps = 240;        // by then the hub is eleven times as large
  static constexpr int kMostOfCollars = 1;  // progress where there is no collar

  struct Cap {
    double angle, cotangent;
  };

  static JunctionSearch refused(const Fault& fault) { return {{}, fault.reason, fault.end}; }

  [[nodiscard]] double thickest() const {
    double result = 0;
    for (const Approach& end : ends_) {
      result = std::max(result, end.end.radius);
    }
    return result;
  }

  [[nodiscard]] double between(std::size_t i, std::size_t k) const {
    return angle_between(ends_[i], ends_[k], center_);
  }

  [[nodiscard]] double gap(std::size_t i, std::size_t k) const {
    return std::min(kWidestGap, between(i, k) / 4);
  }

  [[nodiscard]] std::optional<Fault> directions_fault() const {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Ring& end = ends_[i].end;
      if (!((center_ - end.center).dot(end.normal) > 0)) {
        return Fault{named(i) + " does not face the hub's centre (" +
                         decimal(center_.x(), kMessageDigits) + ", " +
                         decimal(center_.y(), kMessageDigits) + ", " +
                         decimal(center_.z(), kMessageDigits) + "): turn it, or choose the centre",
                     i};
      }
      for (std::size_t k = 0; k < i; ++k) {
        if (between(i, k) < kDegree) {
          return Fault{named(k) + " and " + named(i) + " lie in directions only " +
                           degrees(between(i, k)) +
                           " apart, seen from the hub: at least one degree is needed",
                       i};
        }
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<double> widest_caps() const {
    if (!options_.cap_angles.empty()) {
      return options_.cap_angles;
    }
    std::vector<double> caps(ends_.size(), kWidestCap);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t k = 0; k < ends_.size(); ++k) {
        if (k != i) {
          caps[i] = std::min(caps[i], cap_share(between(i, k) - gap(i, k), ends_[i].end.radius,
                                                ends_[k].end.radius, kWidestCap));
        }
      }
    }
    return caps;
  }

  [[nodiscard]] JunctionSearch search_compact() {
    constexpr double kNarrower = 0.97;
    constexpr int kNarrowings = 60;
    std::vector<double> caps = widest_caps();
    for (int i = 0; i <= (options_.cap_angles.empty() ? kNarrowings : 0); ++i) {
      if (auto found = with_caps(caps)) {
        return {std::move(found), {}, {}};
      }
      std::ranges::for_each(caps, [](double& cap) { cap *= kNarrower; });
    }
    const bool is_free = !options_.radius && options_.cap_angles.empty();
    return nearest_                             ? nearest()
           : is_free && fault_->is_want_of_room ? crowded(ends_, center_)
                                                : refused(*fault_);
  }

  // The least hub that will do. The larger it is, the more room it needs.
  [[nodiscard]] std::optional<Junction> with_caps(const std::vector<double>& caps) {
    double radius = options_.radius.value_or(0);
    for (std::size_t i = 0; i < ends_.size() && !options_.radius; ++i) {
      const PeVector& sphere = ends_[i].sphere;
      const double ahead = (center_ - sphere.m).norm() * ends_[i].tangent.r;
      radius = std::max(
          radius, 0.8 * std::min(sphere.r, std::max(0.0, sphere.r + ahead)) / std::sin(caps[i]));
    }
    if (!std::isfinite(radius)) {
      note(Fault{"caps this small need a hub too large for doubles: wider ones may do"});
      return {};
    }
    std::vector<Cap> told;
    for (const double angle : caps) {
      told.push_back({angle, 1 / std::tan(angle)});
    }
    for (int i = 0; i < (options_.radius ? 1 : kSteps) && std::isfinite(radius);
         ++i, radius *= kStep) {
      Attempt attempt = at_hub(radius, told);
      if (attempt.fault) {
        note(*attempt.fault);
        continue;
      }
      if (*std::ranges::min_element(attempt.ways) < 0) {
        note_nearness(attempt.ways);
        return {};
      }
      if (auto found = sound({center_, radius}, attempt.ways)) {
        return found;
      }
    }
    return {};
  }

  // Of the collar from an end to a cap there.
  [[nodiscard]] std::optional<double> way_to(std::size_t i, const Sphere& hub,
                                             const Cap& cap) const {
    const Slides roots =
        slides(ends_[i].sphere, ends_[i].tangent, {hub.center, hub.radius}, cap.cotangent);
    const auto found = std::ranges::find_if(
        roots, [&](double way) { return !collar_fault(i, way, hub, cap.angle); });
    return found == roots.end() ? std::nullopt : std::optional(*found);
  }

  [[nodiscard]] Attempt at_hub(double radius, const std::vector<Cap>& caps) {
    const Sphere hub{center_, radius};
    Attempt result;
    // Where nothing new would be said of collars, that of which there was none last goes first.
    if (!is_news(kMostOfCollars) && !way_to(last_refused_, hub, caps[last_refused_])) {
      result.fault = Fault{};
      return result;
    }
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const auto found = way_to(i, hub, caps[i]);
      if (!found) {
        last_refused_ = i;
        result.fault = collar_refusal(i, radius, caps[i]);
        return result;
      }
      const double length = ends_[i].end.radius * std::hypot(1, ends_[i].tangent.r);
      result.ways.push_back(std::abs(*found) < kShortest * length ? 0 : *found);
    }
    result.fault = arms_fault(hub, result.ways,
                              !options_.cap_angles.empty() ? ": smaller caps may do"
                              : options_.radius ? ": smaller caps, or a larger hub, may do"
                                                : kFreeRemedy);
    return result;
  }

  // Text only where it is news: most attempts fail.
  [[nodiscard]] Fault collar_refusal(std::size_t i, double radius, const Cap& cap) const {
    if (!is_news(kMostOfCollars)) {
      return {};
    }
    const Slides roots =
        slides(ends_[i].sphere, ends_[i].tangent, {center_, radius}, cap.cotangent);
    const bool ends_before = std::ranges::any_of(roots, [&](double way) {
      return way < 0 && !((ends_[i].sphere + way * ends_[i].tangent).r > 0);
    });
    if (!is_news(ends_before ? kMostOfCollars : 0)) {
      return {};
    }
    const std::string what = "no collar leads from " + named(i) + " to a cap of " +
                             degrees(cap.angle) + " on a hub of radius " +
                             decimal(radius, kMessageDigits);
    if (ends_before) {
      return {what + ": it would have to be further back than its cone reaches", i, kMostOfCollars};
    }
    return {what + (has_crowded_cap(i) ? ": smaller caps may do"
                                       : ": a larger hub, or other caps, may do"),
            i, 0, true};
  }

  // Whether a chosen cap overlaps others, as the ends lie, however large the hub is.
  [[nodiscard]] bool has_crowded_cap(std::size_t i) const {
    const std::vector<double>& caps = options_.cap_angles;
    for (std::size_t k = 0; k < caps.size(); ++k) {
      if (k != i && caps[i] + caps[k] > between(i, k)) {
        return true;
      }
    }
    return false;
  }

  // Of the collar that begins after this way.
  [[nodiscard]] bool collar_fault(std::size_t i, double way, const Sphere& hub,
                                  std::optional<double> cap) const {
    const PeVector start = ends_[i].sphere + way * ends_[i].tangent, end{hub.center, hub.radius};
    if (!(start.r > 0)) {
      return true;
    }
    const ArcValidity v = rounded_validity(start, ends_[i].tangent, end);
    if (v.fault != ArcFault::none || !(v.w > 0)) {
      return true;
    }
    const double angle = cap_angle(start, ends_[i].tangent, end);
    constexpr double kSame = 1e-6;
    return !(v.least_power > good_power_ * hub.radius * hub.radius * std::sin(angle)) ||
           (cap && std::abs(angle - *cap) > kSame);
  }

  // `remedy`: of caps that are too near to each other. On a larger hub, chosen ones are as large.
  [[nodiscard]] std::optional<Fault> arms_fault(const Sphere& hub, const std::vector<double>& ways,
                                                const char* remedy) const {
    Junction junction;
    try {
      junction = arms_to(hub, ends_, ways);
    } catch (const Error& error) {
      return Fault{error.message()};
    }
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const JunctionArm &a = junction.arms[k], &b = junction.arms[i];
        const double between_caps = cap_gap(a.collar, b.collar);
        const bool is_chosen = options_.radius && !options_.cap_angles.empty();
        if (!(between_caps > (is_chosen ? 0 : gap(i, k) / 2))) {
          return !is_news(2)
                     ? Fault{}
                     : Fault{"the caps of " + named(k) + " and " + named(i) +
                                 (between_caps > 0 ? " are only " + degrees(between_caps) + " apart"
                                                   : " overlap by " + degrees(-between_caps)) +
                                 remedy,
                             i, 2, true};
        }
        if (!arms_are_apart(a, b, Arithmetic::rounded)) {
          return !is_news(3) ? Fault{}
                             : Fault{"the arms of " + named(k) + " and " + named(i) +
                                         " cannot be told apart by a plane: move these ends apart",
                                     i, 3};
        }
      }
    }
    return {};
  }

  [[nodiscard]] JunctionSearch smooth(const std::vector<double>& ways, double least) {
    double radius = options_.radius.value_or(least);
    for (int i = 0; i < (options_.radius ? 1 : kSteps); ++i, radius *= kStep) {
      const Sphere hub{center_, radius};
      std::optional<Fault> fault;
      for (std::size_t k = 0; k < ends_.size() && !fault; ++k) {
        if (collar_fault(k, ways[k], hub, {})) {
          fault = !is_news(0) ? Fault{}
                              : Fault{"no collar leads from " + named(k) + " to a hub of radius " +
                                          decimal(radius, kMessageDigits) +
                                          ": another radius may do, or an end that is further off",
                                      k};
        }
      }
      fault = fault
                  ? fault
                  : arms_fault(hub, ways, options_.radius ? ": a larger hub may do" : kFreeRemedy);
      if (fault) {
        note(*fault);
      } else if (auto found = sound(hub, ways)) {
        return {std::move(found), {}, {}};
      }
    }
    return refused(*fault_);
  }

  [[nodiscard]] std::optional<Junction> sound(const Sphere& hub, const std::vector<double>& ways) {
    Junction junction = arms_to(hub, ends_, ways);
    const std::string why = unsoundness(junction);
    if (why.empty()) {
      return junction;
    }
    note({why, {}, 4});
    return {};
  }

  [[nodiscard]] std::vector<double> without_short(std::vector<double> ways) const {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i] = ways[i] < kShortest * ends_[i].sphere.r ? 0 : ways[i];
    }
    return ways;
  }

  [[nodiscard]] bool is_news(int progress) const { return !fault_ || progress > fault_->progress; }

  // The first of those that came furthest.
  void note(const Fault& fault) {
    if (is_news(fault.progress)) {
      fault_ = fault;
    }
  }

  void note_nearness(const std::vector<double>& ways) {
    const auto shortage = [](const std::vector<double>& all) {
      return -*std::ranges::min_element(all);
    };
    if (!nearest_ || shortage(ways) < shortage(*nearest_)) {
      nearest_ = ways;
    }
  }

  [[nodiscard]] JunctionSearch nearest() const {
    std::vector<double> setbacks;
    for (const double way : *nearest_) {
      setbacks.push_back(std::max(0.0, -way));
    }
    return too_near(std::move(setbacks));
  }

  std::span<const Approach> ends_;
  Vec3 center_;
  const JunctionOptions& options_;
  double good_power_;
  std::optional<Fault> fault_;
  std::size_t last_refused_ = 0;
  std::optional<std::vector<double>> nearest_;
};

}  // namespace

std::vector<Approach> approaches_of(std::span<const Ring> ends) {
  std::vector<Approach> result;
  for (const Ring& end : ends) {
    result.push_back({end, contact_sphere(end), contact_tangent(end)});
  }
  return result;
}

Vec3 nearest_to_axes(std::span<const Approach> ends) {
  // Axes within a few degrees of each other tell little of where along them.
  constexpr double kParallel = 1e-3;
  Vec3 middle = Vec3::Zero(), sum = Vec3::Zero();
  for (const Approach& end : ends) {
    middle += end.end.center / double(ends.size());
  }
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (const Approach& end : ends) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - end.end.normal * end.end.normal.transpose();
    matrix += across;
    sum += across * (end.end.center - middle);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Vec3 result = middle;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = solver.eigenvectors().col(i);
    if (solver.eigenvalues()(i) > kParallel * double(ends.size())) {
      result += axis.dot(sum) / solver.eigenvalues()(i) * axis;
    }
  }
  return result;
}

Junction arms_to(const Sphere& hub, std::span<const Approach> ends, std::span<const double> ways) {
  const PeVector last{hub.center, hub.radius};
  Junction result{hub, {}};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Approach& from = ends[i];
    const PeVector start = from.sphere + ways[i] * from.tangent;
    if (ways[i] > 0) {
      PeArc straight = PeArc::from(from.sphere, from.tangent, start);
      PeArc collar = PeArc::from(start, straight.end_tangent(), last);
      result.arms.push_back({from.end, std::move(straight), std::move(collar)});
    } else {
      const Ring end = ways[i] < 0 ? contact_ring(start, from.tangent) : from.end;
      result.arms.push_back({end, {}, PeArc::from(start, from.tangent, last)});
    }
  }
  return result;
}

JunctionSearch search_hub(std::span<const Approach> ends, const Vec3& center,
                          const JunctionOptions& options) {
  JunctionSearch first = HubSearch(ends, center, options).run();
  if (first.setbacks.empty()) {
    return first;
  }
  // Ends that pass the centre are seen in other directions from further back: what is said is
  // tried.
  constexpr int kTrials = 12;
  std::vector<double> setbacks(ends.size(), 0);
  std::vector<Approach> moved(ends.begin(), ends.end());
  JunctionSearch search = first;
  for (int i = 0; i < kTrials && !search.setbacks.empty(); ++i) {
    for (std::size_t k = 0; k < ends.size(); ++k) {
      setbacks[k] += search.setbacks[k] * (1 + kSpare);
      moved[k].sphere = ends[k].sphere - setbacks[k] * ends[k].tangent;
      moved[k].end = contact_ring(moved[k].sphere, ends[k].tangent);
    }
    search = HubSearch(moved, center, options).run();
  }
  if (!search.junction) {
    return crowded(ends, center);
  }
  return too_near(std::move(setbacks));
}

std::optional<Junction> find_hub(std::span<const Approach> ends, const Vec3& center,
                                 const JunctionOptions& options) {
  HubSearch search(ends, center, options);
  search.be_silent();
  return search.run().junction;
}

}  // namespace dupin::junction
