#include "assembly/districts/pipe_stretches.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "assembly/districts/district_plan.h"
#include "assembly/part_box.h"
#include "dupin/kernel/decimal.h"

namespace dupin::assembly {
namespace {

const RingedSurface* pipe_of(const ResolvedPart& part) {
  const auto* chain = std::get_if<Chain>(&part.shape);
  if (chain == nullptr || chain->pieces.size() != 1 || chain->closed || chain->wall > 0) {
    return nullptr;
  }
  const auto* tube = std::get_if<RingedSurface>(&chain->pieces.front());
  const bool is_pipe = tube != nullptr && std::holds_alternative<LineSpine>(tube->spine) &&
                       std::holds_alternative<ConstantRadius>(tube->radius);
  return is_pipe ? tube : nullptr;
}

// The axis of coordinates along which it runs furthest.
int main_axis(const ResolvedPart& pipe) {
  const Vec3 &from = port_ring(pipe.shape, End::start)->center,
             &to = port_ring(pipe.shape, End::end)->center;
  int axis = 0;
  (to - from).cwiseAbs().maxCoeff(&axis);
  return axis;
}

bool is_ascending(const ResolvedPart& pipe) {
  const int axis = main_axis(pipe);
  return port_ring(pipe.shape, End::start)->center[axis] <
         port_ring(pipe.shape, End::end)->center[axis];
}

Ring ring_at(const RingedSurface& pipe, int axis, double place) {
  const Vec3 &from = pipe.start.center, &to = pipe.end.center;
  Ring ring = pipe.end;
  ring.center = from + (place - from[axis]) / (to[axis] - from[axis]) * (to - from);
  ring.center[axis] = place;
  return ring;
}

class Cutter {
 public:
  explicit Cutter(ResolvedAssembly whole) { result_.resolved = std::move(whole); }

  void cut(std::uint32_t part, const std::vector<double>& places) {
    std::vector<ResolvedPart>& parts = result_.resolved.parts;
    const ResolvedPart pipe = parts[part];
    const RingedSurface whole = *pipe_of(pipe);
    std::vector<std::uint32_t>& own = result_.of_pipe[part];
    std::vector<Ring> ends;  // of stretches
    std::ranges::transform(places, std::back_inserter(ends),
                           [&](double place) { return ring_at(whole, main_axis(pipe), place); });
    ends.push_back(whole.end);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const Ring start = i == 0 ? whole.start : flipped(ends[i - 1]);
      ResolvedPart stretch = pipe;
      stretch.shape =
          RingedSurface{start, ends[i], LineSpine{start.center, ends[i].center}, whole.radius};
      own.push_back(i == 0 ? part : std::uint32_t(parts.size()));
      if (i == 0) {
        parts[part] = std::move(stretch);
      } else {
        parts.push_back(std::move(stretch));
        join(own[i - 1], own[i], places[i - 1]);
      }
    }
    if (pipe.joined[1]) {
      parts[pipe.joined[1]->part].joined.at(at(pipe.joined[1]->end)) =
          EndIndex{own.back(), End::end};
    }
  }

  // The stretch that goes through the middle of where both pipes may be.
  void move_fillet(ResolvedFillet& fillet, const std::array<Eigen::AlignedBox3d, 2>& boxes) {
    const Vec3 middle = boxes[0].intersection(boxes[1]).center();
    for (std::uint32_t& pipe : fillet.between) {
      if (const auto cut = result_.of_pipe.find(pipe); cut != result_.of_pipe.end()) {
        pipe = stretch_at(cut->second, middle);
      }
    }
  }

  PipeStretches take() { return std::move(result_); }
  [[nodiscard]] ResolvedAssembly& resolved() { return result_.resolved; }

 private:
  void join(std::uint32_t before, std::uint32_t after, double place) {
    ResolvedPart &one = result_.resolved.parts[before], &other = result_.resolved.parts[after];
    one.joined[1] = EndIndex{after, End::start};
    other.joined[0] = EndIndex{before, End::end};
    one.is_closed[1] = other.is_closed[0] = false;
    one.end_names[1] = other.end_names[0] = cut_prefix(one) + decimal(place);
  }

  [[nodiscard]] std::uint32_t stretch_at(const std::vector<std::uint32_t>& stretches,
                                         const Vec3& place) const {
    const auto& parts = result_.resolved.parts;
    const int axis = main_axis(parts[stretches.front()]);
    const bool ascends = is_ascending(parts[stretches.front()]);
    const auto found = std::ranges::find_if(stretches, [&](std::uint32_t stretch) {
      const double end = port_ring(parts[stretch].shape, End::end)->center[axis];
      return ascends ? place[axis] < end : place[axis] > end;
    });
    return found == stretches.end() ? stretches.back() : *found;
  }

  PipeStretches result_;
};

}  // namespace

std::optional<Cuttable> cuttable(const ResolvedPart& part) {
  const RingedSurface* pipe = pipe_of(part);
  if (pipe == nullptr || part.kind != "pipe" || part.is_tangent || part.ends_in_hub ||
      pipe->start.ellipse || pipe->end.ellipse) {
    return std::nullopt;
  }
  const int axis = main_axis(part);
  const auto [from, to] = std::minmax({pipe->start.center[axis], pipe->end.center[axis]});
  return Cuttable{axis, from, to, pipe->start.radius};
}

PipeCuts pipe_cuts(const ResolvedAssembly& resolved, std::span<const std::uint32_t> parts,
                   std::vector<std::vector<double>> places) {
  PipeCuts result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].empty()) {
      if (!is_ascending(resolved.parts[parts[i]])) {
        std::ranges::reverse(places[i]);
      }
      result.emplace(parts[i], std::move(places[i]));
    }
  }
  return result;
}

PipeStretches in_stretches(ResolvedAssembly whole, const PipeCuts& cuts) {
  std::vector<std::array<Eigen::AlignedBox3d, 2>> boxes;  // of fillets' pipes
  for (const ResolvedFillet& fillet : whole.fillets) {
    const auto box = [&](std::uint32_t pipe) { return part_box(whole.parts[pipe].shape); };
    const bool is_moved = cuts.contains(fillet.between[0]) || cuts.contains(fillet.between[1]);
    boxes.push_back(is_moved ? std::array{box(fillet.between[0]), box(fillet.between[1])}
                             : std::array<Eigen::AlignedBox3d, 2>());
  }
  Cutter cutter(std::move(whole));
  for (const auto& [part, places] : cuts) {
    cutter.cut(part, places);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    cutter.move_fillet(cutter.resolved().fillets[i], boxes[i]);
  }
  return cutter.take();
}

std::string cut_prefix(const ResolvedPart& part) { return kSeamMark + part.name + " at "; }

bool is_cut(const ResolvedPart& part, End end) {
  return part.end_names.at(at(end)).starts_with(kSeamMark);
}

}  // namespace dupin::assembly
