#include "booleans/union_in_steps.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "arrangement/arrange.h"
#include "boxes/bounds.h"
#include "boxes/main_directions.h"
#include "dupin/kernel/parallel.h"
#include "mesh/exact_mesh.h"
#include "support/operation_limits.h"

namespace dupin::booleans {
namespace {

using mesh::ExactMesh;
using Indices = std::span<std::uint32_t>;

// Of so many solids at a time, in general.
constexpr std::size_t kAtOnce = 3;

// How so many are divided.
std::vector<std::array<std::size_t, 2>> divided(std::size_t operands, std::size_t count) {
  std::vector<std::array<std::size_t, 2>> parts;
  for (std::size_t i = 0; i < count; ++i) {
    parts.push_back({operands * i / count, operands * (i + 1) / count});
  }
  return parts;
}

// Where the centres of boxes around solids lie, as long as that is near one point: within some part
// of the least of the boxes.
std::optional<Eigen::AlignedBox3d> common_centre(std::span<const Solid> solids) {
  constexpr double kNarrow = 1.0 / 8;
  Eigen::AlignedBox3d centres;
  double least = HUGE_VAL;
  for (const Solid& solid : solids) {
    const Eigen::AlignedBox3d box = boxes::bounds_of(solid.exact().points);
    if (box.isEmpty()) {
      return std::nullopt;
    }
    centres.extend(box.center());
    least = std::min(least, box.diagonal().norm());
    if (!(centres.diagonal().norm() <= kNarrow * least)) {
      return std::nullopt;
    }
  }
  return centres;
}

double extent_along(const Vec3& direction, std::span<const Vec3> points) {
  const auto along = [&direction](const Vec3& point) { return direction.dot(point); };
  const auto [lowest, highest] = std::ranges::minmax(points, {}, along);
  return along(highest) - along(lowest);
}

// Solids about axes in a plane, about one point. No more is meant than how long the union takes.
struct Fan {
  std::vector<double> angles;  // of the axes; empty if they are no fan
  bool is_close = false;       // none is so thin that it may pass others by
};

Fan fan_of(std::span<const Solid> solids) {
  constexpr double kFlat = 1e-6, kOpen = 0.1, kClose = 1.0 / 4;
  const std::optional<Eigen::AlignedBox3d> centres = common_centre(solids);
  if (!centres) {
    return {};
  }
  double thinnest = HUGE_VAL;
  std::vector<Vec3> axes;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Solid& solid : solids) {
    const Eigen::Matrix3d principal = boxes::principal_axes(solid.exact().points);
    thinnest = std::min(thinnest, extent_along(principal.row(2), solid.exact().points));
    axes.emplace_back(principal.row(0));
    spread += axes.back() * axes.back().transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vec3 values = solver.eigenvalues() / static_cast<double>(solids.size());
  if (!(values[0] <= kFlat && values[1] >= kOpen)) {
    return {};
  }
  Fan fan;
  fan.is_close = centres->diagonal().norm() <= kClose * thinnest;
  for (const Vec3& axis : axes) {
    const double angle =
        std::atan2(axis.dot(solver.eigenvectors().col(1)), axis.dot(solver.eigenvectors().col(2)));
    fan.angles.push_back(angle < 0 ? angle + std::numbers::pi : angle);
  }
  return fan;
}

// Neighbours in a fan cross each other where few others do, so that more of them at a time cost
// little: few levels of steps, each of which costs much more where points are no longer those of
// the operands, and the fewer parts the later the step is.
std::size_t levels_of_fan(std::size_t solids) {
  constexpr double kMostPerLevel = 6;
  const double levels = std::round(std::log(solids) / std::log(kMostPerLevel));
  return static_cast<std::size_t>(std::max(2.0, levels));
}

// How many parts are made of so many, at so many levels of those in all; 0 for what is no fan. Of
// more than two levels, fewer parts make surfaces that take longer to round.
std::size_t part_count(std::size_t operands, std::size_t levels, std::size_t in_all) {
  constexpr double kFewer = 0.9;
  if (levels == 0) {
    return std::min(kAtOnce, operands);
  }
  if (levels == 1) {
    return operands;
  }
  const double even = std::pow(operands, 1 / static_cast<double>(levels));
  const double count = in_all > 2 ? std::ceil(even) : kFewer * even;
  return std::clamp(static_cast<std::size_t>(count), std::size_t{2}, operands);
}

std::size_t below(std::size_t levels) { return levels > 1 ? levels - 1 : levels; }

std::size_t step_count(std::size_t operands, std::size_t levels, std::size_t in_all) {
  std::size_t count = operands > 1 ? 1 : 0;
  if (count > 0) {
    for (const auto& [begin, end] : divided(operands, part_count(operands, levels, in_all))) {
      count += step_count(end - begin, below(levels), in_all);
    }
  }
  return count;
}

class Steps {
 public:
  // Progress is told from `begin` on.
  Steps(std::span<const Solid> operands, std::vector<double> angles, double begin,
        const BooleanOptions& options)
      : operands_(operands),
        options_(options),
        angles_(std::move(angles)),
        levels_(angles_.empty() ? 0 : levels_of_fan(operands.size())),
        steps_(step_count(operands.size(), levels_, levels_)),
        begin_(begin),
        told_(begin) {
    for (const Solid& operand : operands) {
      const Eigen::AlignedBox3d box = boxes::bounds_of(operand.exact().points);
      centres_.emplace_back(box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center()));
    }
  }

  ExactMesh run() {
    std::vector<std::uint32_t> all(operands_.size());
    std::iota(all.begin(), all.end(), 0u);
    ExactMesh result = united(all, levels_);
    order_names(result);
    return result;
  }

 private:
  ExactMesh united(Indices operands, std::size_t levels) {
    if (operands.size() == 1) {
      return with_sources(operands[0]);
    }
    sort_neighbours(operands);
    const auto ranges = divided(operands.size(), part_count(operands.size(), levels, levels_));
    std::vector<ExactMesh> parts(ranges.size());
    for_each_in_parallel(ranges.size(), [&](std::size_t i) {
      const auto [begin, end] = ranges[i];
      parts[i] = united(operands.subspan(begin, end - begin), below(levels));
    });
    return step(parts);
  }

  ExactMesh with_sources(std::uint32_t operand) const {
    ExactMesh mesh = operands_[operand].exact();
    for (std::uint32_t i = 0; i < mesh.sources.size(); ++i) {
      mesh.sources[i] = {operand, i};
    }
    return mesh;
  }

  // Around a fan, else along the longest extent. Equal ones stay in their order.
  void sort_neighbours(Indices operands) const {
    if (!angles_.empty()) {
      std::stable_sort(operands.begin(), operands.end(),
                       [&](std::uint32_t i, std::uint32_t j) { return angles_[i] < angles_[j]; });
      return;
    }
    Eigen::AlignedBox3d box;
    for (const std::uint32_t o : operands) {
      box.extend(centres_[o]);
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    std::stable_sort(operands.begin(), operands.end(), [&](std::uint32_t i, std::uint32_t j) {
      return centres_[i][axis] < centres_[j][axis];
    });
  }

  ExactMesh step(const std::vector<ExactMesh>& parts) {
    std::vector<const ExactMesh*> meshes;
    meshes.reserve(parts.size());
    for (const ExactMesh& part : parts) {
      meshes.push_back(&part);
    }
    ExactMesh result = arrangement::arrange_and_merge(
        meshes, arrangement::union_rule(meshes.size()), progress(), options_.memory_limit);
    for (Source& source : result.sources) {
      source = parts[source.operand].sources[source.triangle];
    }
    ++done_;
    return result;
  }

  // The caller hears of it on the thread it called on; on others steps only learn whether to go on.
  [[nodiscard]] Progress progress() {
    if (!options_.progress) {
      return {};
    }
    return [this](std::string_view stage, double fraction) {
      if (std::this_thread::get_id() != thread_) {
        return !is_cancelled_;
      }
      const double part =
          (static_cast<double>(done_.load()) + fraction) / static_cast<double>(steps_);
      told_ = std::clamp(begin_ + (1 - begin_) * part, told_, 1.0);  // lest rounding leads back
      is_cancelled_ = !options_.progress(stage, told_);
      return !is_cancelled_;
    };
  }

  // As if all had been united at once.
  void order_names(ExactMesh& result) const {
    std::vector<std::string> names;
    const auto number_of = [&names](const std::string& name) {
      const auto at = std::find(names.begin(), names.end(), name);
      const auto number = static_cast<std::uint32_t>(at - names.begin());
      if (at == names.end()) {
        names.push_back(name);
      }
      return number;
    };
    for (const Solid& operand : operands_) {
      std::for_each(operand.names().begin(), operand.names().end(), number_of);
    }
    std::vector<std::uint32_t> number;
    for (const std::string& name : result.names) {
      number.push_back(number_of(name));
    }
    for (std::uint32_t& label : result.labels) {
      label = number[label];
    }
    result.names = std::move(names);
  }

  std::span<const Solid> operands_;
  const BooleanOptions& options_;
  std::vector<Vec3> centres_;
  std::vector<double> angles_;  // empty if they are no fan
  std::size_t levels_;          // of steps in a fan, else 0
  std::size_t steps_;
  double begin_;
  std::atomic<std::size_t> done_{0};
  std::thread::id thread_ = std::this_thread::get_id();
  double told_;
  std::atomic<bool> is_cancelled_{false};
};

}  // namespace

ExactMesh unite_in_steps(std::span<const Solid> operands, const BooleanOptions& options) {
  constexpr double kTold = 0.4;  // by arrange_unless_crowded()
  return Steps(operands, fan_of(operands).angles, kTold, options).run();
}

// Where axes lie in a plane, not all one way, and centres are nearer to each other than the solids
// are thick, each passes through the middle of all: most meet most others there, which is what
// crowding.h asks. Where one is hidden within another instead, nothing is lost but time.
std::optional<ExactMesh> unite_close_fan(std::span<const Solid> operands,
                                         const BooleanOptions& options) {
  constexpr std::size_t kLeast = 10;  // with fewer, none are crowded
  if (operands.size() < kLeast) {
    return std::nullopt;
  }
  Fan fan = fan_of(operands);
  if (fan.angles.empty() || !fan.is_close) {
    return std::nullopt;
  }
  std::uint64_t triangles = 0;
  for (const Solid& operand : operands) {
    triangles += operand.triangle_count();
  }
  support::refuse_too_large(triangles, 0, options.memory_limit);
  return Steps(operands, std::move(fan.angles), 0, options).run();
}

}  // namespace dupin::booleans
