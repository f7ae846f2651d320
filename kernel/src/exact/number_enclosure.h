#pragma once

#include <utility>

#include <CGAL/Mpzf.h>

namespace dupin::exact {

/// Two doubles that enclose the number, in whatever direction doubles are rounded: a few ulp apart,
/// unless they lie near the ends of what doubles hold.
[[nodiscard]] std::pair<double, double> enclosure(const CGAL::Mpzf& number);

}  // namespace dupin::exact
