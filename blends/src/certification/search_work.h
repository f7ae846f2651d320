#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace dupin::certification {

/// What all searches of a certificate may cost together, counted, not timed: the same document
/// gives the same claims on every machine. A unit is a few microseconds.
class SearchWork {
 public:
  explicit SearchWork(std::uint64_t units) : left_(units) {}

  void allow(std::uint64_t units) {
    left_ += std::min(units, std::numeric_limits<std::uint64_t>::max() - left_);
  }
  void spend(std::uint64_t units) { left_ -= std::min(left_, units); }
  [[nodiscard]] std::uint64_t left() const { return left_; }
  [[nodiscard]] bool is_used_up() const { return left_ == 0; }

 private:
  std::uint64_t left_;
};

}  // namespace dupin::certification
