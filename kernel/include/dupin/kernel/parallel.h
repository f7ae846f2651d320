#pragma once

#include <cfenv>
#include <cstddef>
#include <functional>

namespace dupin {

/// Calls `visit(index)` for all indices below `count`, on as many threads as TBB may use
/// (tbb::global_control), so not in order. What an index throws does not keep the others from being
/// visited; then that of the lowest one is thrown.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& visit);

/// Calls `make(index)` for all indices below `count` as above, begun in order, and `take(index)` in
/// order, one at a time, as soon as that index is made and those before it are taken: what is large
/// need not wait until all is made. Behind an index that throws none is taken, and none begun; what
/// the lowest such index throws is thrown.
void for_each_in_order(std::size_t count, const std::function<void(std::size_t)>& make,
                       const std::function<void(std::size_t)>& take);

/// While it lives, this thread rounds to nearest and has denormal numbers, whatever its caller has
/// set for his own arithmetic; that comes back. What makes, places, combines, checks, rounds,
/// certifies, reads and writes solids sets it, so that the same input has the same result. Smaller
/// functions take the arithmetic as it is.
class UsualArithmetic {
 public:
  UsualArithmetic() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~UsualArithmetic() { std::fesetenv(&before_); }
  UsualArithmetic(const UsualArithmetic&) = delete;
  UsualArithmetic& operator=(const UsualArithmetic&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace dupin
