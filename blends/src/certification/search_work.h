#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace dupin::certification {

/// What searches may cost together, counted, not timed: the same document gives the same claims on
/// every machine. A unit is a few microseconds. It knows what would have been answered the same if
/// there had been more or less to begin with.
class SearchWork {
 public:
  explicit SearchWork(std::uint64_t units) : units_(units) {}

  void spend(std::uint64_t units) { spent_ += std::min(units, kMost - spent_); }
  [[nodiscard]] std::uint64_t spent() const { return spent_; }
  [[nodiscard]] std::uint64_t left() const { return units_ - std::min(units_, spent_); }

  [[nodiscard]] bool is_used_up() { return !exceeds(spent_); }
  [[nodiscard]] bool has(std::uint64_t units) {
    return units == 0 || exceeds(spent_ + std::min(units - 1, kMost - spent_));
  }
  /// Whether more is left than half of what was when so much was spent.
  [[nodiscard]] bool has_half_since(std::uint64_t spent) {
    const std::uint64_t more = spent_ - spent;
    return exceeds(spent_ + std::min(more, kMost - spent_));
  }

  /// Whether all answers would have been the same with so many units.
  [[nodiscard]] bool is_same_with(std::uint64_t units) const {
    return least_ <= units && units <= most_;
  }

 private:
  static constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

  bool exceeds(std::uint64_t bound) {
    if (units_ > bound) {
      least_ = std::max(least_, bound + 1);
      return true;
    }
    most_ = std::min(most_, bound);
    return false;
  }

  std::uint64_t units_, spent_ = 0, least_ = 0, most_ = kMost;
};

}  // namespace dupin::certification
