#include "dupin/blends/junction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "assembly/bore.h"
#include "assembly/narrowed_shape.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/kernel/error.h"
#include "junction/hub_advice.h"

namespace dupin::assembly {
namespace {

// How long transitions are, by the largest semi-axis of their end; the longest that leave room are
// taken.
constexpr std::array kTransitions{3.0, 2.4, 1.9, 1.5, 1.2, 0.95, 0.75, 0.6};

class JunctionSearchOfPorts {
 public:
  JunctionSearchOfPorts(const PartContext& context, const JunctionOfPorts& junction)
      : context_(context), junction_(junction) {}

  [[nodiscard]] JunctionOfEnds found() const {
    if (std::ranges::all_of(junction_.ends,
                            [&](const PortReference& end) { return is_circle(end); })) {
      return with_transitions(0, true);
    }
    std::optional<Error> last;
    for (const double length : kTransitions) {
      try {
        return with_transitions(length, length == kTransitions.back());
      } catch (const Error& error) {
        if (error.code() != Errc::infeasible_blend && error.code() != Errc::irregular_surface) {
          throw;
        }
        last = error;
      }
    }
    throw Error(
        last->code(),
        "with transitions from its elliptical and oblique ends to circles: " + last->message(), {},
        last->where());
  }

 private:
  [[nodiscard]] bool is_circle(const PortReference& end) const {
    return !context_.ring(end).ellipse && is_right(context_, end);
  }

  // What would do instead is tried out for the last ones only.
  [[nodiscard]] JunctionOfEnds with_transitions(double length, bool is_last) const {
    JunctionOfEnds result;
    std::vector<Ring> rings;
    for (const PortReference& end : junction_.ends) {
      result.transitions.push_back(is_circle(end) ? std::nullopt
                                                  : std::optional(transition(end, length)));
      const auto& made = result.transitions.back();
      rings.push_back(made ? *port_ring(*made, End::end) : context_.ring(end));
    }
    if (is_last) {
      result.shape = junction::advised_junction(rings, junction_.options, takes_wall());
      return result;
    }
    JunctionSearch search = search_junction(rings, junction_.options);
    if (!search.junction) {
      throw Error(Errc::infeasible_blend, search.reason);
    }
    result.shape = std::move(*search.junction);
    return result;
  }

  // Whether all walls leave bores; nothing to ask where there are none.
  [[nodiscard]] junction::JunctionNeed takes_wall() const {
    const double own = wall_of(context_.assembly, context_.assembly.parts[context_.index]);
    std::vector<double> walls;
    for (const PortReference& end : junction_.ends) {
      const auto part = std::ranges::find(context_.assembly.parts, end.part, &Part::name);
      walls.push_back(wall_of(context_.assembly, *part));
    }
    if (!(own > 0) && std::ranges::max(walls) <= 0) {
      return {};
    }
    return [own, walls](std::span<const Ring> ends, const Junction& junction) {
      try {
        for (std::size_t i = 0; i < ends.size(); ++i) {
          (void)narrowed(ends[i], walls[i]);
        }
        (void)(own > 0 ? narrowed(junction, own) : junction);
        return true;
      } catch (const Error&) {
        return false;
      }
    };
  }

  // To a cylinder of the same area, straight ahead.
  [[nodiscard]] Chain transition(const PortReference& end, double length) const {
    const Ring& ring = context_.ring(end);
    const Vec3 ahead =
        ring.ellipse ? ring.normal : Vec3(context_.motion(end).center_rate.normalized());
    const Ring circle{ring.center + length * largest_radius(ring) * ahead, ahead,
                      std::sqrt(ring.radius * across(ring))};
    if (ring.ellipse) {
      return Chain(elliptic_blend(ring, flipped(circle)));
    }
    const PartShape blend =
        RingedBlendBetween{end, FreeEnd{circle.center, ahead, circle.radius, CanalContact{}}};
    return std::get<Chain>(part_kind(blend).geometry(context_, blend));
  }

  const PartContext& context_;
  const JunctionOfPorts& junction_;
};

}  // namespace

template <>
struct PartRules<"junction"> {
  static References references(const JunctionOfPorts&) { return {}; }

  static std::string_view portless(const JunctionOfPorts&) { return "a junction"; }

  static References ends(const JunctionOfPorts& junction) {
    References result;
    for (const PortReference& end : junction.ends) {
      result.push_back({end, "ends"});
    }
    return result;
  }

  static JunctionOfEnds junction(const PartContext& context, const JunctionOfPorts& junction) {
    if (junction.options.center) {
      check_finite(context, *junction.options.center, "center");
    }
    if (junction.options.radius) {
      check_positive(context, *junction.options.radius, "radius");
    }
    return JunctionSearchOfPorts(context, junction).found();
  }
};
template const PartKind& part_kind<"junction">();

}  // namespace dupin::assembly
