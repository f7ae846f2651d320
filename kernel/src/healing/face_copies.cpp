#include "healing/face_copies.h"

#include <algorithm>
#include <span>

#include "healing/patch_counts.h"

namespace dupin::healing {
namespace {

/// A triangle of the soup by its corners in ascending order.
struct Copy {
  Triangle corners;
  bool is_odd;  ///< it runs the other way round
  std::uint32_t face;
};

std::vector<Copy> sorted_copies(std::span<const Triangle> triangles) {
  std::vector<Copy> copies;
  copies.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    Triangle corners = triangles[i];
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    const bool is_odd = corners[1] > corners[2];
    std::ranges::sort(corners);
    copies.push_back({corners, is_odd, i});
  }
  std::ranges::sort(copies, {},
                    [](const Copy& copy) { return std::pair(copy.corners, copy.face); });
  return copies;
}

/// All triangles that differ, in ascending order, and their copies.
struct DistinctFaces {
  explicit DistinctFaces(std::span<const Triangle> all) : copies(sorted_copies(all)) {
    for (const Copy& copy : copies) {
      if (triangles.empty() || triangles.back() != copy.corners) {
        triangles.push_back(copy.corners);
        starts.push_back(static_cast<std::uint32_t>(&copy - copies.data()));
        numbers.push_back({});
      }
      ++(copy.is_odd ? numbers.back().odd : numbers.back().even);
    }
    starts.push_back(static_cast<std::uint32_t>(copies.size()));
  }
  [[nodiscard]] std::span<const Copy> copies_of(std::size_t i) const {
    return std::span(copies).subspan(starts[i], starts[i + 1] - starts[i]);
  }

  std::vector<Copy> copies;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> starts;  // of each triangle's copies, and the end
  std::vector<CopyNumbers> numbers;
};

/// Which of the faces stay, and which of these turned.
struct Choice {
  std::vector<std::uint8_t> is_kept, is_turned;

  /// Keeps as many copies of a face as `count` says, its sign the way round: rather such as need no
  /// turning, and the first ones.
  void keep(std::span<const Copy> copies, int count) {
    for (const bool turning : {false, true}) {
      for (const Copy& copy : copies) {
        if (count != 0 && ((count < 0) != copy.is_odd) == turning) {
          is_kept[copy.face] = 1;
          is_turned[copy.face] = turning ? 1 : 0;
          count += count < 0 ? 1 : -1;
        }
      }
    }
  }
};

}  // namespace

SettledCopies settle_copies(PolygonSoup& soup) {
  const DistinctFaces distinct(soup.triangles);
  const std::vector<int> counts = closing_counts(soup.points, distinct.triangles, distinct.numbers);
  Choice choice{std::vector<std::uint8_t>(soup.triangles.size(), 0),
                std::vector<std::uint8_t>(soup.triangles.size(), 0)};
  for (std::size_t i = 0; i < distinct.triangles.size(); ++i) {
    choice.keep(distinct.copies_of(i), counts[i]);
  }
  SettledCopies settled;
  std::vector<bool>& is_turned = settled.is_turned;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (choice.is_kept[i] == 0) {
      ++settled.dropped;
      continue;
    }
    Triangle t = soup.triangles[i];
    if (choice.is_turned[i] != 0) {
      std::swap(t[1], t[2]);
    }
    soup.triangles[is_turned.size()] = t;
    soup.sources[is_turned.size()] = soup.sources[i];
    is_turned.push_back(choice.is_turned[i] != 0);
  }
  soup.triangles.resize(is_turned.size());
  soup.sources.resize(is_turned.size());
  return settled;
}

}  // namespace dupin::healing
