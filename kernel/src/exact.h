#pragma once

#include <CGAL/Mpzf.h>
#include <gmpxx.h>

namespace dupin::detail {

[[nodiscard]] mpq_class rational(const CGAL::Mpzf& number);

/// The double nearest to `value` (ties to even); infinite beyond the largest double.
[[nodiscard]] double nearest_double(const mpq_class& value);

}  // namespace dupin::detail
