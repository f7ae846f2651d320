#pragma once

#include "numbers/interval.h"
#include "numbers/mpfi_interval.h"

namespace dupin::verification {

using Mpfi = numbers::MpfiInterval<128>;

/// The interval of doubles around it.
[[nodiscard]] inline numbers::Interval narrowed(const Mpfi& x) {
  const Enclosure e = x.rounded_outward();
  return {e.lower, e.upper};
}

}  // namespace dupin::verification
