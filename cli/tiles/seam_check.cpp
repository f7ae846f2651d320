#include "tiles/seam_check.h"

#include <algorithm>
#include <utility>

namespace dupin::cli {

SeamCheck::SeamCheck(std::span<const Seam> seams) : seams_(seams.begin(), seams.end()) {
  for (std::uint32_t i = 0; i < seams_.size(); ++i) {
    for (const std::uint32_t piece : seams_[i].pieces) {
      of_piece_.resize(std::max<std::size_t>(of_piece_.size(), piece + 1));
      of_piece_[piece].push_back(i);
    }
  }
}

std::vector<Seam> SeamCheck::of(std::size_t piece) const {
  std::vector<Seam> result;
  if (piece < of_piece_.size()) {
    for (const std::uint32_t seam : of_piece_[piece]) {
      result.push_back(seams_[seam]);
    }
  }
  return result;
}

void SeamCheck::add(std::size_t piece, std::vector<SeamSide> sides, std::size_t shells_before) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::uint32_t seam = of_piece_.at(piece).at(i);
    const auto first = waiting_.find(seam);
    if (first == waiting_.end()) {
      waiting_.emplace(seam, Waiting{std::move(sides[i]), shells_before});
      continue;
    }
    const auto& [side, before] = first->second;
    if (fit(side, sides[i])) {
      SeamShells shells{{}, side.has_others || sides[i].has_others};
      for (std::size_t k = 0; k < side.borders.size(); ++k) {
        shells.pairs.push_back(
            {{before + side.borders[k].shell, shells_before + sides[i].borders.at(k).shell},
             side.borders[k].points});
      }
      joined_.push_back(std::move(shells));
      seam_of_joined_.push_back(seam);
    } else {
      misfits_.insert(seams_[seam].name);
    }
    waiting_.erase(first);
  }
}

const std::set<std::string>& SeamCheck::misfits() {
  for (const std::size_t i : doubtful(joined_)) {
    misfits_.insert(seams_[seam_of_joined_[i]].name);
  }
  return misfits_;
}

}  // namespace dupin::cli
