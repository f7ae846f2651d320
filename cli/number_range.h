#pragma once

#include <cmath>
#include <limits>
#include <string>

#include <CLI/App.hpp>

#include "dupin/kernel/decimal.h"

namespace dupin::cli {

/// What an option takes: numbers from `lowest` to `highest`. CLI::Range lets what is no number
/// ("nan") pass, which is not less than anything.
[[nodiscard]] inline CLI::Validator number_range(double lowest, double highest) {
  const std::string ends = decimal(lowest) + " - " + decimal(highest);
  return {[lowest, highest, ends](std::string& typed) {
            double value = std::numeric_limits<double>::quiet_NaN();
            const bool is_read = CLI::detail::lexical_cast(typed, value);
            return is_read && value >= lowest && value <= highest
                       ? std::string()
                       : "Value " + typed + " not in range " + ends;
          },
          "FLOAT in [" + ends + "]"};
}

}  // namespace dupin::cli
