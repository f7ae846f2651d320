#include "drawing/stretches.h"

#include <algorithm>
#include <cmath>

namespace dupin::drawing {
namespace {

Vec3 point_at(const std::vector<Vec3>& line, double parameter) {
  const auto i = static_cast<std::size_t>(parameter);
  const double fraction = parameter - static_cast<double>(i);
  return fraction == 0 ? line[i] : Vec3(line[i] + fraction * (line[i + 1] - line[i]));
}

}  // namespace

std::vector<Stretch> complement(const std::vector<Stretch>& stretches, double end) {
  std::vector<Stretch> result;
  double from = 0;
  for (const Stretch& stretch : stretches) {
    if (stretch.from > from) {
      result.push_back({from, stretch.from});
    }
    from = stretch.to;
  }
  if (from < end) {
    result.push_back({from, end});
  }
  return result;
}

std::vector<Stretch> intersection(const std::vector<Stretch>& a, const std::vector<Stretch>& b) {
  std::vector<Stretch> result;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size(); ++(a[i].to < b[k].to ? i : k)) {
    const double from = std::max(a[i].from, b[k].from), to = std::min(a[i].to, b[k].to);
    if (from < to) {
      result.push_back({from, to});
    }
  }
  return result;
}

std::vector<Vec3> cut(const std::vector<Vec3>& line, const Stretch& stretch) {
  std::vector<Vec3> result{point_at(line, stretch.from)};
  for (auto i = static_cast<std::size_t>(stretch.from) + 1; double(i) < stretch.to; ++i) {
    result.push_back(line[i]);
  }
  result.push_back(point_at(line, stretch.to));
  return result;
}

}  // namespace dupin::drawing
