#include "network/piping_reach.h"

#include <algorithm>
#include <cmath>

#include "dupin/kernel/decimal.h"

namespace dupin::network {
namespace {

// Pipes that run along each other are no branches.
constexpr double kAlong = 0.9;

// How far the pipe that ends at `end` in direction `outward` has to go to be level with the axis of
// `run`; none if it does not end in its wall.
std::optional<double> reach(const Vec3& end, const Vec3& outward, const Span& run, double snap) {
  const Vec3 &from = run.ends[0].point, way = run.ends[1].point - from;
  const double length = way.norm(), radius = std::max(run.radii[0], run.radii[1]);
  if (!(length > 0)) {
    return std::nullopt;
  }
  const Vec3 along = way / length, offset = end - from;
  const double level = offset.dot(along), cosine = outward.dot(along);
  const double aside = (offset - level * along).norm();
  if (level < 0 || level > length || aside > radius + snap || std::abs(cosine) > kAlong) {
    return std::nullopt;
  }
  // The nearest point to the run's axis on the pipe's own.
  return (level * cosine - offset.dot(outward)) / (1 - cosine * cosine);
}

}  // namespace

void reach_runs(const PipingLine& line, const PipingOptions& options, PipingSpans& spans,
                LineNotes& notes) {
  for (std::size_t i = 0; i < spans.spans.size(); ++i) {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      Span& span = spans.spans[i];
      SpanEnd& end = span.ends[side];
      if (span.role != SpanRole::straight || !end.port || end.joint || !(span.length() > 0)) {
        continue;
      }
      const Vec3 outward = (end.point - span.ends[1 - side].point) / span.length();
      for (const Span& run : spans.spans) {
        if (run.component == span.component) {
          continue;
        }
        const auto further = reach(end.point, outward, run, options.snap);
        if (further && *further > 0) {
          end.point += *further * outward;
          notes.add(line.components[span.component],
                    "ends in the wall of " + run.name + "; continued by " +
                        decimal(*further, kMessageDigits) + " to its axis");
          break;
        }
      }
    }
  }
}

}  // namespace dupin::network
