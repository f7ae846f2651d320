#include "healing/face_copies.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <utility>

#include "healing/ordered_points.h"
#include "healing/patch_counts.h"
#include "healing/sorted_copies.h"
#include "mesh/edge_table.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

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
  /// `was_turned`: per face, or empty.
  Choice(std::size_t faces, std::span<const std::uint8_t> was_turned)
      : is_kept(faces, 0), is_turned(was_turned.begin(), was_turned.end()) {
    is_turned.resize(faces, 0);
    is_paired.resize(faces, 0);
  }

  /// Keeps as many copies of a face as `count` says, its sign the way round: rather such as need no
  /// turning, then such as were not turned, and the first ones.
  void keep(std::span<const Copy> copies, int count) {
    has_copies |= std::abs(count) > 1;
    for (const int turns : {0, 1, 2, 3}) {
      for (const Copy& copy : copies) {
        const bool turns_now = (count < 0) != copy.is_odd;
        if (count != 0 && is_kept[copy.face] == 0 &&
            (turns_now ? 2 : 0) + is_turned[copy.face] == turns) {
          is_kept[copy.face] = 1;
          is_turned[copy.face] ^= turns_now ? 1 : 0;
          count += count < 0 ? 1 : -1;
        }
      }
    }
  }

  std::vector<std::uint8_t> is_kept, is_turned, is_paired;
  bool has_copies = false;  // of one face, among those kept
};

void turn(Triangle& t) { std::swap(t[1], t[2]); }

// Drops the faces that are not kept.
SettledCopies applied(const Choice& choice, std::span<const std::uint8_t> was_turned,
                      PolygonSoup& soup) {
  SettledCopies settled{.has_copies = choice.has_copies};
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (choice.is_kept[i] == 0) {
      ++settled.dropped;
      continue;
    }
    const std::size_t at = settled.is_turned.size();
    soup.triangles[at] = soup.triangles[i];
    soup.sources[at] = soup.sources[i];
    if (choice.is_turned[i] != (was_turned.empty() ? 0 : was_turned[i])) {
      turn(soup.triangles[at]);
    }
    settled.is_turned.push_back(choice.is_turned[i]);
    settled.is_paired.push_back(choice.is_paired[i]);
  }
  soup.triangles.resize(settled.is_turned.size());
  soup.sources.resize(settled.is_turned.size());
  return settled;
}

// Per triangle 1 where what hangs together is closed as it is; there its numbers are divided by
// what they have in common.
std::vector<std::uint8_t> find_closed(DistinctFaces& distinct, std::size_t point_count) {
  const mesh::EdgeTable edges(distinct.triangles, point_count);
  const mesh::Shells shells = mesh::shells(distinct.triangles.size(), edges);
  std::vector<std::uint8_t> is_closed(distinct.triangles.size(), 1), is_open(shells.count, 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::int64_t sum = 0;
    for (const std::uint32_t h : edges[i].half_edges) {
      const auto [even, odd] = distinct.numbers[h / 3];
      sum += edges.origin(h) < edges.target(h) ? even - odd : odd - even;
    }
    is_open[shells.of_face[edges[i].half_edges[0] / 3]] |= sum != 0 ? 1 : 0;
  }
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    int common = 0;
    for (const std::uint32_t t : shells.faces_of(shell)) {
      common = std::gcd(common, std::gcd(distinct.numbers[t].even, distinct.numbers[t].odd));
    }
    for (const std::uint32_t t : shells.faces_of(shell)) {
      distinct.numbers[t].even /= common;
      distinct.numbers[t].odd /= common;
      is_closed[t] = is_open[shell] == 0 ? 1 : 0;
    }
  }
  return is_closed;
}

/// Some faces of a soup, with the points in the order of their coordinates, which does not depend
/// on how they are numbered.
struct OrderedFaces {
  OrderedFaces(const PolygonSoup& soup, std::span<const std::uint32_t> faces) {
    const std::vector<std::uint32_t> place = places_by_coordinates(soup.points);
    points.resize(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
      points[place[i]] = soup.points[i];
    }
    for (const std::uint32_t face : faces) {
      const auto& [a, b, c] = soup.triangles[face];
      triangles.push_back({place[a], place[b], place[c]});
    }
  }

  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

// Chooses among faces of which all that hang together with them are given. With `pairs`, copies
// that are not needed to close the surface stay as pairs that look opposite ways.
void close(const PolygonSoup& soup, std::vector<std::uint32_t> faces, bool pairs, Choice& choice) {
  std::ranges::sort(faces);
  const OrderedFaces ordered(soup, faces);
  DistinctFaces distinct(ordered.triangles);
  const std::vector<int> counts =
      closing_counts(ordered.points, distinct.triangles, distinct.numbers);
  for (Copy& copy : distinct.copies) {
    copy.face = faces[copy.face];
  }
  const mesh::EdgeTable edges(distinct.triangles, ordered.points.size());
  const mesh::Shells parts = mesh::shells(distinct.triangles.size(), edges);
  std::vector<std::uint8_t> vanishes(parts.count, 0);
  for (std::size_t i = 0; i < distinct.triangles.size(); ++i) {
    if (counts[i] == 0) {
      vanishes[parts.of_face[i]] = 1;
    }
  }
  for (std::size_t i = 0; i < distinct.triangles.size(); ++i) {
    const auto copies = distinct.copies_of(i);
    const int spare = pairs && (vanishes[parts.of_face[i]] != 0 || copies.size() > 2)
                          ? (static_cast<int>(copies.size()) - std::abs(counts[i])) / 2
                          : 0;
    const int front = std::max(counts[i], 0) + spare, back = std::max(-counts[i], 0) + spare;
    choice.keep(copies, counts[i] < 0 ? -back : front);
    choice.keep(copies, counts[i] < 0 ? front : -back);
    choice.has_copies |= spare > 0;
    for (const Copy& copy : copies) {
      choice.is_paired[copy.face] = spare > 0 ? 1 : 0;
    }
  }
}

}  // namespace

SettledCopies close_surface(PolygonSoup& soup) {
  DistinctFaces distinct(soup.triangles);
  const std::vector<std::uint8_t> is_closed = find_closed(distinct, soup.points.size());
  Choice choice(soup.triangles.size(), {});
  std::vector<std::uint32_t> open;
  for (std::size_t i = 0; i < distinct.triangles.size(); ++i) {
    const auto copies = distinct.copies_of(i);
    if (is_closed[i] != 0) {
      const auto first_odd =
          std::ranges::partition_point(copies, [](const Copy& copy) { return !copy.is_odd; });
      choice.keep({copies.begin(), first_odd}, distinct.numbers[i].even);
      choice.keep({first_odd, copies.end()}, -distinct.numbers[i].odd);
      choice.has_copies |= distinct.numbers[i].even > 0 && distinct.numbers[i].odd > 0;
    } else {
      for (const Copy& copy : copies) {
        open.push_back(copy.face);
      }
    }
  }
  if (!open.empty()) {
    close(soup, std::move(open), true, choice);
  }
  return applied(choice, {}, soup);
}

SettledCopies settle_copies(PolygonSoup& soup, std::span<const std::uint8_t> was_turned) {
  Choice choice(soup.triangles.size(), was_turned);
  close(soup, support::numbers_below(soup.triangles.size()), false, choice);
  return applied(choice, was_turned, soup);
}

}  // namespace dupin::healing
