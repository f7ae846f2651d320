#include "dupin/kernel/tiled_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "checking/inspection.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exact/exact_numbers.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"
#include "support/bulk_vector.h"
#include "support/none.h"
#include "tiles/first_corners.h"
#include "tiles/shell_parts.h"
#include "tiles/tile_mesh.h"
#include "tiles/tile_tree.h"

namespace dupin {
namespace tiles {
namespace {

constexpr std::size_t kDefectCount = static_cast<std::size_t>(Defect::isolated_point) + 1;

/// What is held of the whole, per facet and per facet in several tiles (FirstCorners, SeamCorners
/// and the parts of these).
constexpr double kBytesOfWhole = 0.4, kBytesOfSeam = 32;

/// A tile's half-edges have numbers of 32 bits.
constexpr std::uint64_t kMostInTile = support::kNone / 3;

static_assert(sizeof(TileFacet) == 44);

bool has_repeated_corner(const Facet& facet) {
  const Place a = corner_of(facet, 0), b = corner_of(facet, 1), c = corner_of(facet, 2);
  return a == b || b == c || c == a;
}

/// The order in which check() comes upon findings of one kind.
std::array<std::uint32_t, 3> order_of(const Finding& finding) {
  const auto& faces = finding.faces;
  const auto& points = finding.points;
  switch (finding.defect) {
    case Defect::degenerate_face: {
      const bool is_repeated =
          points[0] == points[1] || points[1] == points[2] || points[2] == points[0];
      return {is_repeated ? 0U : 1U, faces[0], 0};
    }
    case Defect::duplicate_face:
    case Defect::self_intersection:
      return {faces[0], faces[1], 0};
    case Defect::non_manifold_vertex:
      return {points[0], 0, 0};
    default:  // edges
      return {points[0], points[1], 0};
  }
}

/// Bytes of a value, to be put aside.
template <class Items>
std::span<const char> bytes_of(const Items& items) {
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(items[0])};
}
template <class Items>
std::span<char> bytes_of(Items& items) {
  return {reinterpret_cast<char*>(items.data()), items.size() * sizeof(items[0])};
}

class TiledCheck {
 public:
  TiledCheck(const FacetSource& source, Scratch& scratch, const TiledCheckOptions& options)
      : source_(source),
        scratch_(scratch),
        options_(options),
        count_(source.count()),
        tree_({}, 1),
        first_(count_),
        kept_(kDefectCount) {
    report_.triangles = count_;
    report_.counts.assign(kDefectCount, 0);
  }

  Report run() {
    divide();
    put_aside();
    for (std::uint32_t tile = 0; tile < tree_.size(); ++tile) {
      const std::vector<TileFacet> facets = facets_of(tile);
      note_first_corners(facets, welded(facets, tree_, tile), first_, seams_);
    }
    number_points();
    for (std::uint32_t tile = 0; tile < tree_.size(); ++tile) {
      inspect(tile);
    }
    support::release(seams_);
    report_shells();
    checking::append_findings(std::move(kept_), report_);
    return std::move(report_);
  }

 private:
  /// What a source says, or a file holds, may have become otherwise meanwhile.
  static void require_the_same(bool is_the_same) {
    if (!is_the_same) {
      throw Error(Errc::invalid_argument,
                  "the facets are not those that they were, or not as many as counted; a source "
                  "must give the same ones every time");
    }
  }

  /// Calls visit(facet) for all facets of the source.
  template <class Visit>
  void for_each_given(const Visit& visit) const {
    std::uint64_t left = count_;
    source_.visit([&](std::span<const Facet> facets) {
      require_the_same(facets.size() <= left);
      left -= facets.size();
      std::ranges::for_each(facets, visit);
    });
    require_the_same(left == 0);
  }

  static void require_finite(const Facet& facet, std::size_t number) {
    const auto is_usual = [](float x) { return std::isfinite(x) && (x != 0 || !std::signbit(x)); };
    if (!std::ranges::all_of(facet, is_usual)) {
      throw Error(Errc::invalid_argument, "facet " + std::to_string(number) +
                                              " has a coordinate that is not finite, or is -0");
    }
  }

  /// Of about so many facets, places that tiles are divided by; and the area on the way.
  [[nodiscard]] std::vector<Place> survey() {
    constexpr std::size_t kSample = std::size_t{1} << 17;
    const std::size_t step = count_ / kSample + 1;
    std::vector<Place> sample;
    mesh::AreaSum area;
    std::size_t number = 0;
    for_each_given([&](const Facet& facet) {
      require_finite(facet, number);
      if (number++ % step == 0) {
        sample.push_back(box_of(facet).low);
      }
      if (!has_repeated_corner(facet)) {
        area.add({to_vec3(corner_of(facet, 0)), to_vec3(corner_of(facet, 1)),
                  to_vec3(corner_of(facet, 2))});
      }
    });
    report_.area = area.value();
    return sample;
  }

  /// Makes as many tiles as are asked for, or as the memory takes.
  void divide() {
    const std::vector<Place> sample = survey();
    const double all = count_;
    const double left = static_cast<double>(options_.memory) - kBytesOfWhole * all;
    constexpr double kUneven = 1.2;
    std::size_t most = options_.tiles;
    if (options_.memory > 0) {
      const double needed = kTileBytes * all * (kTileBytes * all > left ? kUneven : 1);
      most = static_cast<std::size_t>(
          std::clamp(std::ceil(needed / std::max(left, 1.0)), 1.0, double(sample.size() + 1)));
    }
    for (double before = std::numeric_limits<double>::infinity();; most *= 2) {
      tree_ = TileTree(sample, most);
      count_facets();
      const auto largest = static_cast<double>(std::ranges::max(counts_));
      const double needed = kTileBytes * largest + kBytesOfWhole * all +
                            kBytesOfSeam * static_cast<double>(seam_count_);
      if (largest > static_cast<double>(kMostInTile)) {
        throw Error(Errc::limit_exceeded, "a tile has " + decimal(largest) +
                                              " triangles, more than 1431655765; take more tiles");
      }
      if (options_.memory == 0 || needed <= static_cast<double>(options_.memory)) {
        return;
      }
      constexpr double kHardlyLess = 0.9;
      if (tree_.size() < most || largest > kHardlyLess * before) {
        throw Error(Errc::limit_exceeded, "the largest of " + std::to_string(tree_.size()) +
                                              " tiles has " + decimal(largest) +
                                              " triangles, which need " + byte_size(needed) +
                                              "; give --memory more");
      }
      before = largest;
    }
  }

  void count_facets() {
    counts_.assign(tree_.size(), 0);
    seam_count_ = 0;
    for_each_given([&](const Facet& facet) {
      std::size_t tiles = 0;
      tree_.for_each_tile(box_of(facet), [&](std::uint32_t tile) {
        ++counts_[tile];
        ++tiles;
      });
      seam_count_ += tiles > 1 ? 1 : 0;
    });
  }

  /// Puts the facets aside, tile by tile.
  void put_aside() {
    begin_.assign(1, 0);
    for (const std::uint64_t count : counts_) {
      begin_.push_back(begin_.back() + count);
    }
    seams_.assign(3 * seam_count_, 0);
    seam_parts_.assign(seam_count_, support::kNone);
    const std::size_t most =
        std::clamp<std::size_t>((std::size_t{1} << 18) / tree_.size(), 16, 4096);
    std::vector<std::vector<TileFacet>> waiting(tree_.size());
    std::vector<std::uint64_t> end(begin_.begin(), begin_.end() - 1);
    const auto flush = [&](std::uint32_t tile) {
      require_the_same(end[tile] + waiting[tile].size() <= begin_[tile + 1]);
      scratch_.write(sizeof(TileFacet) * end[tile], bytes_of(std::as_const(waiting[tile])));
      end[tile] += waiting[tile].size();
      waiting[tile].clear();
    };
    std::uint32_t number = 0, seam = 0;
    std::vector<std::uint32_t> in;
    for_each_given([&](const Facet& facet) {
      require_finite(facet, number);
      in.clear();
      tree_.for_each_tile(box_of(facet), [&](std::uint32_t tile) { in.push_back(tile); });
      const std::uint32_t own_seam = in.size() > 1 ? seam++ : support::kNone;
      for (const std::uint32_t tile : in) {
        waiting[tile].push_back({facet, number, own_seam});
        if (waiting[tile].size() >= most) {
          flush(tile);
        }
      }
      ++number;
    });
    require_the_same(seam == seam_count_);
    for (std::uint32_t tile = 0; tile < tree_.size(); ++tile) {
      flush(tile);
      require_the_same(end[tile] == begin_[tile + 1]);
    }
  }

  [[nodiscard]] std::vector<TileFacet> facets_of(std::uint32_t tile) const {
    std::vector<TileFacet> facets(counts_[tile]);
    scratch_.read(sizeof(TileFacet) * begin_[tile], bytes_of(facets));
    return facets;
  }

  /// Where the parts of shells are put that a tile's facets are of.
  [[nodiscard]] std::uint64_t place_of_parts(std::uint32_t tile) const {
    return sizeof(TileFacet) * begin_.back() + sizeof(std::uint32_t) * begin_[tile];
  }

  void number_points() {
    first_.count();
    if (first_.size() >= support::kNone) {
      throw Error(Errc::limit_exceeded, "there are " + std::to_string(first_.size()) +
                                            " points; the limit is 4294967294");
    }
    report_.points = first_.size();
  }

  void inspect(std::uint32_t tile) {
    std::vector<TileFacet> facets = facets_of(tile);
    if (facets.empty()) {
      return;
    }
    const TileMesh own = tile_mesh(facets, welded(facets, tree_, tile), first_, seams_);
    std::vector<std::uint32_t> numbers, seams;
    numbers.reserve(facets.size());
    seams.reserve(facets.size());
    for (const TileFacet& facet : facets) {
      numbers.push_back(facet.number);
      seams.push_back(facet.seam);
    }
    support::release(facets);
    const auto counts_pair = [&](std::uint32_t a, std::uint32_t b) {
      return seams[a] == support::kNone || seams[b] == support::kNone ||
             tree_.tile_of(lowest_in_common(own.mesh, a, b)) == tile;
    };
    const checking::Inspection inspection = checking::inspect_tile(
        own.mesh, {.limit = options_.limit}, {{own.owns_point, own.owns_face}, counts_pair});
    add_findings(inspection.report, own.points, numbers);
    const std::uint32_t first_part = add_parts(inspection, own, numbers);
    std::vector<std::uint32_t> parts = inspection.shell_of_face;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i] == support::kNone) {
        continue;
      }
      parts[i] += first_part;
      if (seams[i] != support::kNone) {
        std::uint32_t& known = seam_parts_[seams[i]];
        known = known == support::kNone ? parts[i] : known;
        parts_.unite(known, parts[i]);
      }
    }
    scratch_.write(place_of_parts(tile), bytes_of(std::as_const(parts)));
  }

  /// Of the boxes of two faces.
  static Place lowest_in_common(const TriMesh& mesh, std::uint32_t a, std::uint32_t b) {
    const auto low = [&](std::uint32_t face) {
      const auto& [p, q, r] = mesh.triangles[face];
      return mesh.points[p].cwiseMin(mesh.points[q]).cwiseMin(mesh.points[r]).eval();
    };
    const Vec3 lowest = low(a).cwiseMax(low(b));
    return {static_cast<float>(lowest.x()), static_cast<float>(lowest.y()),
            static_cast<float>(lowest.z())};
  }

  /// In the numbers of the whole.
  void add_findings(const Report& found, std::span<const std::uint32_t> points,
                    std::span<const std::uint32_t> faces) {
    report_.euler_number += found.euler_number;
    for (std::size_t i = 0; i < kDefectCount; ++i) {
      report_.counts[i] += found.counts[i];
    }
    for (Finding finding : found.findings) {
      for (std::uint32_t& point : finding.points) {
        point = points[point];
      }
      for (std::uint32_t& face : finding.faces) {
        face = faces[face];
      }
      kept_[static_cast<std::size_t>(finding.defect)].push_back(std::move(finding));
    }
    for (std::vector<Finding>& kept : kept_) {
      std::ranges::sort(kept, {}, order_of);
      kept.resize(std::min(kept.size(), options_.limit));
    }
  }

  /// Returns the first one's number.
  std::uint32_t add_parts(const checking::Inspection& inspection, const TileMesh& own,
                          std::span<const std::uint32_t> numbers) {
    const std::vector<ShellReport>& shells = inspection.report.shells;
    std::vector<std::uint32_t> begin(shells.size() + 1, 0), faces;
    for (std::size_t i = 0; i < shells.size(); ++i) {
      begin[i + 1] = begin[i] + static_cast<std::uint32_t>(shells[i].triangles);
    }
    faces.resize(begin.back());
    std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
    for (std::uint32_t face = 0; face < numbers.size(); ++face) {
      const std::uint32_t shell = inspection.shell_of_face[face];
      if (shell != support::kNone && own.owns_face[face] != 0) {
        faces[end[shell]++] = face;
      }
    }
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
      ShellPart part =
          part_of(own.mesh, std::span(faces).subspan(begin[i], shells[i].triangles), numbers);
      part.first_face = numbers[shells[i].first_face];
      part.euler_number = shells[i].euler_number;
      const std::uint32_t number = parts_.add(std::move(part));
      first = i == 0 ? number : first;
    }
    return first;
  }

  static ShellPart part_of(const TriMesh& mesh, std::span<const std::uint32_t> faces,
                           std::span<const std::uint32_t> numbers) {
    ShellPart part;
    part.triangles = faces.size();
    const mesh::MeshView view(mesh.points, mesh.triangles);
    std::vector<Triangle> triangles;
    triangles.reserve(faces.size());
    for (const std::uint32_t face : faces) {
      triangles.push_back(mesh.triangles[face]);
      part.box.extend(mesh::bounds_of(view, face).cast<float>());
      if (const double cost = mesh::ray_cost(view, face); cost < part.test_cost) {
        part.test_cost = cost;
        part.test_face = face;
      }
    }
    part.volume = mesh::exact_volume({mesh.points, triangles});
    if (!faces.empty()) {
      for (std::size_t k = 0; k < 9; ++k) {
        part.test_facet[k] = static_cast<float>(
            mesh.points[mesh.triangles[part.test_face][k / 3]][static_cast<Eigen::Index>(k % 3)]);
      }
      part.test_face = numbers[part.test_face];
    }
    return part;
  }

  /// Calls visit(shell, facet) once for each facet of a shell, tile by tile.
  template <class Visit>
  void for_each_facet(std::span<const std::uint32_t> shell_of_part, const Visit& visit) const {
    constexpr std::uint64_t kAtOnce = 1 << 16;
    std::vector<TileFacet> facets;
    std::vector<std::uint32_t> parts;
    for (std::uint32_t tile = 0; tile < tree_.size(); ++tile) {
      for (std::uint64_t at = 0; at < counts_[tile]; at += kAtOnce) {
        const std::uint64_t count = std::min(kAtOnce, counts_[tile] - at);
        facets.resize(count);
        parts.resize(count);
        scratch_.read(sizeof(TileFacet) * (begin_[tile] + at), bytes_of(facets));
        scratch_.read(place_of_parts(tile) + sizeof(std::uint32_t) * at, bytes_of(parts));
        for (std::size_t i = 0; i < count; ++i) {
          const TileFacet& facet = facets[i];
          if (parts[i] != support::kNone && (facet.seam == support::kNone ||
                                             tree_.tile_of(corner_of(facet.corners, 0)) == tile)) {
            visit(shell_of_part[parts[i]], facet);
          }
        }
      }
    }
  }

  void report_shells() {
    const JoinedShells joined = std::move(parts_).joined();
    support::release(seam_parts_);
    mpq_class volume;
    for (const ShellPart& shell : joined.shells) {
      report_.shells.push_back({shell.first_face, shell.triangles,
                                exact::nearest_double(shell.volume), 0, shell.euler_number});
      report_.genus += (2 - shell.euler_number) / 2;
      volume += shell.volume;
    }
    report_.components = joined.shells.size();
    report_.volume = exact::nearest_double(volume);
    if (report_.is_solid()) {
      check_nesting(joined);
    }
  }

  void check_nesting(const JoinedShells& joined) {
    ShellDepths nesting(joined.shells);
    if (!nesting.are_known()) {
      for_each_facet(joined.of_part, [&](std::uint32_t shell, const TileFacet& facet) {
        nesting.add(shell, facet.corners);
      });
    }
    const std::vector<int> depths = nesting.depths();
    std::vector<std::uint32_t> wrong;
    report_.components = 0;
    for (std::uint32_t i = 0; i < depths.size(); ++i) {
      report_.shells[i].depth = depths[i];
      const bool is_outer = depths[i] % 2 == 0;
      report_.components += is_outer ? 1 : 0;
      if (sgn(joined.shells[i].volume) != (is_outer ? 1 : -1)) {
        wrong.push_back(i);
      }
    }
    report_.counts[static_cast<std::size_t>(Defect::inside_out_component)] = wrong.size();
    wrong.resize(std::min(wrong.size(), options_.limit));
    add_inside_out(joined, wrong);
  }

  void add_inside_out(const JoinedShells& joined, std::span<const std::uint32_t> shells) {
    if (shells.empty()) {
      return;
    }
    std::vector<Finding>& kept = kept_[static_cast<std::size_t>(Defect::inside_out_component)];
    kept.resize(shells.size(), {Defect::inside_out_component, {}, {}, Vec3::Zero()});
    for_each_facet(joined.of_part, [&](std::uint32_t shell, const TileFacet& facet) {
      const auto place = std::ranges::lower_bound(shells, shell);
      if (place == shells.end() || *place != shell) {
        return;
      }
      Finding& finding = kept[static_cast<std::size_t>(place - shells.begin())];
      finding.faces.push_back(facet.number);
      if (facet.number == joined.shells[shell].first_face) {
        finding.place = to_vec3(corner_of(facet.corners, 0));
      }
    });
    for (Finding& finding : kept) {
      std::ranges::sort(finding.faces);
    }
  }

  const FacetSource& source_;
  Scratch& scratch_;
  const TiledCheckOptions options_;
  const std::uint32_t count_;  // of the source's facets
  TileTree tree_;
  std::vector<std::uint64_t> counts_, begin_;  // of facets in each tile, and before it
  std::uint64_t seam_count_ = 0;
  FirstCorners first_;
  SeamCorners seams_;
  std::vector<std::uint32_t> seam_parts_;  // of each facet in several tiles one of its parts
  ShellParts parts_;
  std::vector<std::vector<Finding>> kept_;  // by defect
  Report report_;
};

}  // namespace
}  // namespace tiles

Report check_in_tiles(const FacetSource& source, Scratch& scratch,
                      const TiledCheckOptions& options) {
  const UsualArithmetic usual;
  return tiles::TiledCheck(source, scratch, options).run();
}

}  // namespace dupin
