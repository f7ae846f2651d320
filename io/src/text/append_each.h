#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "dupin/kernel/parallel.h"

namespace dupin::text {

/// Appends to `text` what `append(text, i)` appends for all i below `count`, in their order. Much
/// is made in parallel, by blocks that do not depend on the number of threads.
template <typename Append>
void append_each(std::string& text, std::size_t count, const Append& append) {
  constexpr std::size_t kBlock = std::size_t{1} << 13;
  const auto append_block = [&](std::string& end, std::size_t block) {
    const UsualArithmetic usual;  // a worker's is not the caller's
    const std::size_t stop = std::min(count, (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < stop; ++i) {
      append(end, i);
    }
  };
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  if (blocks <= 1) {
    append_block(text, 0);
    return;
  }
  std::vector<std::string> made(blocks);
  for_each_in_order(
      blocks, [&](std::size_t block) { append_block(made[block], block); },
      [&](std::size_t block) {
        text += made[block];
        std::string().swap(made[block]);
      });
}

}  // namespace dupin::text
