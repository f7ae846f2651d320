#pragma once

#include <optional>

#include "dupin/kernel/rounding.h"
#include "exact/float_lattice.h"

namespace dupin::rounding {

/// How parted() does it; none where it does not do.
class ContactParting {
 public:
  ContactParting(const Rounded& touching, const RoundingOptions& options);

  [[nodiscard]] std::optional<Rounded> run(const Rounded& touching) const;

 private:
  class Attempt;

  /// What is left of the tolerance.
  [[nodiscard]] double room(const Rounded& rounded) const {
    return options_.tolerance - rounded.report().largest_move;
  }
  [[nodiscard]] std::optional<Rounded> rounded_again(const Attempt& attempt) const;

  Coordinates coordinates_;
  RoundingOptions options_;  // with a tolerance
  exact::FloatLattice lattice_;
  double step_;
};

}  // namespace dupin::rounding
