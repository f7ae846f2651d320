#pragma once

#include <optional>
#include <vector>

#include "dupin/blends/piping_line.h"

namespace dupin::network {

/// Ends of a piping file up to this far apart, in millimetres, are meant to meet: as `dupin gaps`
/// takes them if it is not told.
constexpr double kMeant = 1;

/// An end of one of a line's components.
struct LinePort {
  std::size_t component = 0, index = 0;  ///< in PipingLine::components, in its ports
  Vec3 center;
  std::optional<Vec3> outward;   ///< unit; none: the component has none there
  std::optional<double> radius;  ///< outside
  std::size_t line = 0;
  double leg = 0;  ///< against `outward`, to the component's other end or its centre
};

/// All ends, component by component, without those of components that `is_left_out` names and those
/// that a fitting has in its very centre.
[[nodiscard]] std::vector<LinePort> line_ports(const PipingLine& line,
                                               const std::vector<bool>& is_left_out);

/// Two ends that belong together.
struct PortPair {
  std::size_t first = 0, second = 0;  ///< in the list of ports, first < second
  double distance = 0;
};

/// Each end at most once, none with one of its own component, none with one that looks the same
/// way: first those within `snap`, then those within `bridge` of which neither lies behind the
/// other by more than half of its leg; of several, those that face each other best, then equal
/// radii, then the nearest. By `first`. O(n log n): throws
/// Error{limit_exceeded} where more than two million pairs lie that near.
[[nodiscard]] std::vector<PortPair> paired(const std::vector<LinePort>& ports, double snap,
                                           double bridge);

/// The angle between the directions, in radians, 0 if the ends face each other or one has none.
[[nodiscard]] double kink(const LinePort& a, const LinePort& b);

}  // namespace dupin::network
