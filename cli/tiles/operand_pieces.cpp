#include "tiles/operand_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "dupin/kernel/decimal.h"

namespace dupin::cli {
namespace {

/// Of two pipes through each other, one band of triangles long, as many as both have; of finer
/// ones so many times the roots of their numbers, measured.
constexpr double kCrossing = 10;

/// No operand is called so.
constexpr char kSeamMark = '\x1f';

double largest_of(std::span<const double> numbers) {
  return numbers.empty() ? 0 : *std::ranges::max_element(numbers);
}

/// What operands are cut across.
int longest_axis(const Eigen::AlignedBox3d& box) {
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  return axis;
}

/// Operands of a district in stretches, in their order.
struct Stretches {
  std::vector<OperandStretch> all;
  Boxes boxes;
  std::vector<double> triangles;                    ///< of the operand alone
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< that share a cut
};

class OperandDivider {
 public:
  explicit OperandDivider(const OperandDivision& division) : division_(division) {}

  void add(const std::vector<std::size_t>& operands, const Boxes& boxes) {
    if (operands.empty()) {
      append_district();
      return;
    }
    const Stretches whole = stretches(operands, boxes, {});
    const double expected = sum(triangles_of(whole, std::vector<std::uint32_t>(whole.all.size())));
    const bool is_large = division_.most > 0 && expected > division_.most;
    if (!is_large || boxes.size() < kLeastOperands) {
      append(whole, std::vector<std::uint32_t>(whole.all.size()));
      return;
    }
    const Stretches cut = stretches(operands, boxes, best_cuts(operands, boxes, expected));
    append(cut, groups_of(cut));
  }

  OperandPieces take() { return std::move(result_); }

 private:
  static double sum(std::span<const double> numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0);
  }

  [[nodiscard]] std::optional<Cuttable> cuttable(std::size_t operand) const {
    const Eigen::AlignedBox3d& box = division_.boxes[operand];
    if (division_.uncut.contains(operand)) {
      return std::nullopt;
    }
    const int axis = longest_axis(box);
    const double thickness = box.sizes().minCoeff();
    return thickness > 0
               ? std::optional(Cuttable{axis, box.min()[axis], box.max()[axis], thickness / 2})
               : std::nullopt;
  }

  /// Operands without a box are not cut. Places by those that have one.
  [[nodiscard]] Stretches stretches(const std::vector<std::size_t>& operands, const Boxes& boxes,
                                    const FreePlaces::Cuts& places) const {
    Stretches result;
    std::size_t boxed = 0;
    for (const std::size_t operand : operands) {
      if (division_.boxes[operand].isEmpty()) {
        append_stretch({operand}, {}, 0, result);
        continue;
      }
      const std::vector<double> own = places.empty() ? std::vector<double>() : places[boxed];
      append_operand(operand, boxes[boxed], own, result);
      ++boxed;
    }
    return result;
  }

  static void append_stretch(OperandStretch stretch, const Eigen::AlignedBox3d& box,
                             double triangles, Stretches& to) {
    to.all.push_back(std::move(stretch));
    to.boxes.push_back(box);
    to.triangles.push_back(triangles);
  }

  void append_operand(std::size_t operand, const Eigen::AlignedBox3d& wide,
                      const std::vector<double>& places, Stretches& to) const {
    const Eigen::AlignedBox3d& box = division_.boxes[operand];
    const int axis = longest_axis(box);
    OperandStretch next{operand, axis};
    for (std::size_t i = 0; i <= places.size(); ++i) {
      const bool is_last = i == places.size();
      Eigen::AlignedBox3d own = wide;
      if (next.from) {
        own.min()[axis] += next.from->place - box.min()[axis];
        to.pairs.push_back({std::uint32_t(to.all.size() - 1), std::uint32_t(to.all.size())});
      }
      if (!is_last) {
        own.max()[axis] -= box.max()[axis] - places[i];
        next.to =
            PlaneCut{places[i], kSeamMark + std::to_string(operand) + " at " + decimal(places[i])};
      }
      const double share = (own.max()[axis] - own.min()[axis]) / wide.sizes()[axis];
      append_stretch(next, own, share * double(division_.triangles[operand]), to);
      next = {operand, axis, next.to, {}};
    }
  }

  /// How many are expected of each group of stretches.
  [[nodiscard]] std::vector<double> triangles_of(const Stretches& stretches,
                                                 const std::vector<std::uint32_t>& group_of) const {
    std::vector<double> result(1 + *std::ranges::max_element(group_of));
    for (std::size_t i = 0; i < group_of.size(); ++i) {
      result[group_of[i]] += stretches.triangles[i];
    }
    const auto root = [&](std::uint32_t i) {
      return std::sqrt(double(division_.triangles[stretches.all[i].operand]));
    };
    for_each_touching(stretches.boxes, [&](std::uint32_t a, std::uint32_t b) {
      if (stretches.all[a].operand != stretches.all[b].operand) {
        result[group_of[a]] += kCrossing * (root(a) + root(b));
      }
    });
    return result;
  }

  /// What the stretches fall into where they are cut.
  [[nodiscard]] static std::vector<std::uint32_t> atoms_of(const Stretches& stretches) {
    return districts_of(stretches.boxes, stretches.pairs);
  }

  [[nodiscard]] FreePlaces::Cuts best_cuts(const std::vector<std::size_t>& operands,
                                           const Boxes& boxes, double expected) const {
    std::vector<std::optional<Cuttable>> items;
    for (const std::size_t operand : operands) {
      if (!division_.boxes[operand].isEmpty()) {
        items.push_back(cuttable(operand));
      }
    }
    return FreePlaces(boxes, items)
        .best_cuts(expected, division_.most, [&](const FreePlaces::Cuts& cuts) {
          const Stretches tried = stretches(operands, boxes, cuts);
          return largest_of(triangles_of(tried, atoms_of(tried)));
        });
  }

  [[nodiscard]] std::vector<std::uint32_t> groups_of(const Stretches& stretches) const {
    const std::vector<std::uint32_t> atom_of = atoms_of(stretches);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (const auto& [before, behind] : stretches.pairs) {
      pairs.push_back({atom_of[before], atom_of[behind]});
    }
    const std::vector<std::uint32_t> group_of_atom =
        grouped(triangles_of(stretches, atom_of), pairs, division_.most);
    const auto first =
        std::ranges::find_if(stretches.boxes, [](const auto& box) { return !box.isEmpty(); });
    const std::uint32_t first_atom = atom_of[std::size_t(first - stretches.boxes.begin())];
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < atom_of.size(); ++i) {
      // What has no triangles is with what has.
      result.push_back(group_of_atom[stretches.boxes[i].isEmpty() ? first_atom : atom_of[i]]);
    }
    return result;
  }

  void append_district() {
    result_.stretches.emplace_back();
    result_.boxes.emplace_back();
    result_.triangles.push_back(0);
  }

  /// Stretches of one operand that are in one group are one.
  void append(const Stretches& stretches, const std::vector<std::uint32_t>& group_of) {
    std::map<std::uint32_t, std::uint32_t> district;  // by group
    for (std::uint32_t i = 0; i < stretches.all.size(); ++i) {
      const auto [entry, is_new] =
          district.try_emplace(group_of[i], static_cast<std::uint32_t>(result_.stretches.size()));
      if (is_new) {
        append_district();
      }
      result_.triangles[entry->second] += stretches.triangles[i];
      std::vector<OperandStretch>& own = result_.stretches[entry->second];
      Boxes& boxes = result_.boxes[entry->second];
      const OperandStretch& stretch = stretches.all[i];
      const bool goes_on = i > 0 && stretch.from && group_of[i - 1] == group_of[i];
      if (goes_on) {
        own.back().to = stretch.to;
        boxes.back().extend(stretches.boxes[i]);
      } else {
        own.push_back(stretch);
        if (!stretches.boxes[i].isEmpty()) {
          boxes.push_back(stretches.boxes[i]);
        }
      }
      if (stretch.from && !goes_on) {
        result_.seams.push_back({{district.at(group_of[i - 1]), entry->second},
                                 stretch.from->name,
                                 stretches.boxes[i - 1].intersection(stretches.boxes[i])});
        std::ranges::sort(result_.seams.back().pieces);
      }
    }
  }

  const OperandDivision& division_;
  OperandPieces result_;
};

}  // namespace

OperandPieces operand_pieces(const OperandDistricts& districts, const OperandDivision& division) {
  OperandDivider divider(division);
  for (std::size_t i = 0; i < districts.operands.size(); ++i) {
    divider.add(districts.operands[i], districts.boxes[i]);
  }
  return divider.take();
}

}  // namespace dupin::cli
