#include "assembly/districts/stretched_district.h"

#include <algorithm>
#include <numeric>

#include "assembly/part_box.h"

namespace dupin::assembly {

StretchedDistrict stretched(const Divisible& whole, const PipeCuts& cuts) {
  StretchedDistrict result{in_stretches(whole.resolved, cuts), whole.members, whole.common};
  DistrictParts& members = result.members;
  Boxes more;
  for (const auto& [pipe, stretches] : result.stretches.of_pipe) {
    const std::uint32_t own = whole.members.place_of(pipe);
    const Eigen::AlignedBox3d box = part_box(whole.resolved.parts[pipe].shape);
    const Vec3 before = box.min() - whole.members.boxes[own].min(),
               behind = whole.members.boxes[own].max() - box.max();
    for (const std::uint32_t stretch : stretches) {
      const Eigen::AlignedBox3d part = part_box(result.stretches.resolved.parts[stretch].shape);
      const Eigen::AlignedBox3d wider(part.min() - before, part.max() + behind);
      if (stretch == pipe) {
        members.boxes[own] = wider;
      } else {
        members.parts.push_back(stretch);
        more.push_back(wider);
        result.common.samplings.push_back(whole.common.samplings[own]);
        result.common.second_samplings.push_back(whole.common.second_samplings[own]);
      }
    }
  }
  members.boxes.insert(members.boxes.begin() + std::ptrdiff_t(whole.members.parts.size()),
                       more.begin(), more.end());
  return result;
}

FewerCuts cuts_between(const StretchedDistrict& district, const PipeCuts& cuts,
                       const std::function<std::uint32_t(std::uint32_t)>& group_of) {
  const DistrictParts& members = district.members;
  FewerCuts result;
  std::size_t pipes_and_more = members.parts.size();
  for (const auto& [pipe, stretches] : district.stretches.of_pipe) {
    pipes_and_more -= stretches.size() - 1;
  }
  result.boxes.resize(pipes_and_more);
  std::iota(result.boxes.begin(), result.boxes.end(), std::uint32_t{0});
  for (const auto& [pipe, stretches] : district.stretches.of_pipe) {
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
      const std::uint32_t before = members.place_of(stretches[i]),
                          behind = members.place_of(stretches[i + 1]);
      if (group_of(before) != group_of(behind)) {
        result.cuts[pipe].push_back(cuts.at(pipe)[i]);
        result.boxes.push_back(behind);
      }
    }
  }
  for (std::size_t i = members.parts.size(); i < members.boxes.size(); ++i) {
    result.boxes.push_back(std::uint32_t(i));
  }
  return result;
}

}  // namespace dupin::assembly
