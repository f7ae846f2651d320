#pragma once

#include "../interval.h"
#include "../mpfi_interval.h"

namespace dupin::verifier {

using Mpfi = detail::MpfiInterval<128>;

/// The interval of doubles around it.
[[nodiscard]] inline detail::Interval narrowed(const Mpfi& x) {
  const Enclosure e = x.rounded_outward();
  return {e.lower, e.upper};
}

}  // namespace dupin::verifier
