#pragma once

#include <array>
#include <cstddef>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "boxes/box.h"

namespace dupin::boxes {

/// Four boxes side by side, which are compared with another one at once.
class BoxQuad {
 public:
  static constexpr std::size_t kSize = 4;

  /// Four times nothing.
  BoxQuad() {
    for (std::size_t i = 0; i < kSize; ++i) {
      set(i, Box::nothing());
    }
  }

  [[nodiscard]] Box operator[](std::size_t i) const {
    return {{low_[0][i], low_[1][i], low_[2][i]}, {high_[0][i], high_[1][i], high_[2][i]}};
  }
  void set(std::size_t i, const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k][i] = box.low[k];
      high_[k][i] = box.high[k];
    }
  }
  /// A box that contains them all.
  [[nodiscard]] Box joined() const {
    Box all = (*this)[0];
    for (std::size_t i = 1; i < kSize; ++i) {
      all.join((*this)[i]);
    }
    return all;
  }

  /// Bit i: whether the box i overlaps `box`.
  [[nodiscard]] unsigned overlapping(const Box& box) const {
#ifdef __SSE2__
    __m128 all = _mm_castsi128_ps(_mm_set1_epi32(-1));
    for (std::size_t k = 0; k < 3; ++k) {
      const __m128 below = _mm_cmple_ps(_mm_loadu_ps(low_[k].data()), _mm_set1_ps(box.high[k])),
                   above = _mm_cmple_ps(_mm_set1_ps(box.low[k]), _mm_loadu_ps(high_[k].data()));
      all = _mm_and_ps(all, _mm_and_ps(below, above));
    }
    return static_cast<unsigned>(_mm_movemask_ps(all));
#else
    unsigned bits = 0;
    for (std::size_t i = 0; i < kSize; ++i) {
      bits |= ((*this)[i].overlaps(box) ? 1U : 0U) << i;
    }
    return bits;
#endif
  }

 private:
  std::array<std::array<float, kSize>, 3> low_, high_;  // per coordinate, of each box
};

}  // namespace dupin::boxes
