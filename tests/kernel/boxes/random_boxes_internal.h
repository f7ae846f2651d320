#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "boxes/box_quantizer.h"

namespace dupin::boxes {

inline std::vector<Box> random_boxes(std::uint32_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 0.9F), size(0, 0.1F);
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    Box& box = boxes.emplace_back();
    for (int k = 0; k < 3; ++k) {
      box.low[k] = place(random);
      box.high[k] = box.low[k] + size(random);
    }
  }
  return boxes;
}

}  // namespace dupin::boxes
