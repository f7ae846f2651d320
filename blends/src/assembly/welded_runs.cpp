#include "assembly/welded_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "assembly/joined_hubs.h"
#include "assembly/part_context.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::assembly {
namespace {

// Walks from `part` out through its `exit` until an open end or back at the part.
std::vector<std::uint32_t> walk(const ResolvedAssembly& assembly, std::uint32_t part, End exit) {
  std::vector<std::uint32_t> passed{part};
  for (auto next = assembly.parts[part].joined.at(at(exit)); next && next->part != part;
       next = assembly.parts[passed.back()].joined.at(at(opposite(next->end)))) {
    passed.push_back(next->part);
  }
  return passed;
}

struct Extent {
  double smallest, largest;
  double clearance = std::numeric_limits<double>::infinity();

  void include(double size) { smallest = std::min(smallest, size); }
  void include(const Vec3& point, double radius) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff() + radius);
  }
};

Extent extent_of(const PartSurface& shape) {
  Extent extent{std::numeric_limits<double>::infinity(), 0};
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    extent.include(sphere->radius);
    extent.include(sphere->center, sphere->radius);
    return extent;
  }
  const Chain& chain = std::get<Chain>(shape);
  if (chain.wall > 0) {
    extent.include(chain.wall);
  }
  for (const Piece& piece : chain.pieces) {
    const surfaces::PieceExtent own =
        std::visit([&](const auto& p) { return surfaces::extent(p, chain.wall); }, piece);
    extent.include(own.smallest);
    extent.largest = std::max(extent.largest, own.largest);
    extent.clearance = std::min(extent.clearance, own.clearance);
  }
  for (const End end : {End::start, End::end}) {
    if (const Ring* ring = port_ring(shape, end)) {
      extent.include(std::min(ring->radius, across(*ring)));
      extent.include(ring->center, largest_radius(*ring));
    }
  }
  return extent;
}

double smallest_ring(const ResolvedAssembly& resolved, const WeldedRun& run) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto part : run.parts) {
    for (const End end : {End::start, End::end}) {
      if (const Ring* ring = port_ring(resolved.parts[part].shape, end)) {
        smallest = std::min({smallest, ring->radius, across(*ring)});
      }
    }
  }
  return smallest;
}

// A ring has as many segments as the widest of its run needs. A corner of it stands out from its
// neighbours by less than the lattice may move points, if that is too coarse: then corners come to
// lie on one line, and flat ends get faces without area.
double keeping_rings_convex(double spacing, const Assembly& assembly,
                            const ResolvedAssembly& resolved, double largest) {
  double result = spacing;
  for (const WeldedRun& run : welded_runs(resolved)) {
    try {
      const double turn =
          2 * std::numbers::pi / double(run_sampling(assembly, resolved, run, 0, spacing).segments);
      const double height = smallest_ring(resolved, run) * turn * turn / 2;
      while (2 * result > height && largest < std::ldexp(result, 50)) {
        result /= 2;
      }
    } catch (const Error&) {  // it is refused where its mesh is made, which says why
    }
  }
  return result;
}

struct Mesher {
  const RingSampling& sampling;
  double tolerance;

  Tessellation operator()(const Sphere& sphere) const { return tessellate(sphere, sampling); }

  template <class Tube>
  Tessellation operator()(const Tube& tube) const {
    return tessellate(tube, sampling, {tolerance});
  }
};

}  // namespace

std::vector<WeldedRun> welded_runs(const ResolvedAssembly& assembly) {
  std::vector<WeldedRun> result;
  std::vector<bool> done(assembly.parts.size(), false);
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    if (done[i]) {
      continue;
    }
    // To one end of the run, then from there to the other.
    const auto back = walk(assembly, i, End::start);
    const auto& joined = assembly.parts[back.back()].joined;
    const bool leaves_by_end = !joined.at(0);
    const auto forward = walk(assembly, back.back(), leaves_by_end ? End::end : End::start);
    // In a closed loop both walks come all the way round.
    const bool is_loop = joined.at(0) && joined.at(1);
    WeldedRun run{is_loop ? walk(assembly, i, End::end) : forward};
    if (!is_loop && run.parts.back() < run.parts.front()) {
      std::reverse(run.parts.begin(), run.parts.end());
    }
    for (const auto part : run.parts) {
      done[part] = true;
    }
    result.push_back(std::move(run));
  }
  return result;
}

double lattice_spacing(const Assembly& assembly, const ResolvedAssembly& resolved) {
  Extent extent{assembly.tolerance, 0};
  const std::string* largest = nullptr;
  struct {
    const std::string* name = nullptr;
    std::uint32_t index = 0;
  } smallest;
  for (const ResolvedPart& part : resolved.parts) {
    const Extent own = extent_of(part.shape);
    if (own.smallest < extent.smallest) {
      extent.smallest = own.smallest;
      smallest = {&part.name, part.index};
    }
    extent.clearance = std::min(extent.clearance, own.clearance);
    if (own.largest > extent.largest) {
      extent.largest = own.largest;
      largest = &part.name;
    }
  }
  for (const ResolvedFillet& fillet : resolved.fillets) {
    const double radius = ball(fillet.shape.loops.front(), 0).radius;
    if (radius > 0 && radius < extent.smallest) {
      extent.smallest = radius;
      smallest = {&fillet.name, fillet.index};
    }
  }
  // Bends that all but touch their axis are kept off it as far as coordinates can.
  const double finest = std::ldexp(extent.largest, -38);
  const double detail = std::min(extent.smallest, std::max(extent.clearance, finest));
  const double spacing = std::ldexp(1.0, std::ilogb(detail) - 11);
  // One bit is left for bends that reach further than their ends.
  if (!(extent.largest < std::ldexp(spacing, 51))) {
    const std::string problem =
        decimal(extent.smallest, kMessageDigits) + ", is too small for coordinates of " +
        decimal(extent.largest, kMessageDigits) + " (of '" + *largest + "'); it must be at least " +
        decimal_at_most(std::ldexp(extent.largest, -39));
    throw smallest.name == nullptr
        ? Error(Errc::invalid_argument, "the tolerance, " + problem, {},
                document_place(assembly, "/tolerance"))
        : Error(Errc::invalid_argument, "its smallest radius or length, " + problem, *smallest.name,
                document_place(assembly, smallest.index));
  }
  return keeping_rings_convex(spacing, assembly, resolved, extent.largest);
}

RingSampling run_sampling(const Assembly& assembly, const ResolvedAssembly& resolved,
                          const WeldedRun& run, std::size_t position, double grid) {
  RingSampling result{0, std::fmod(0.37 * double(position), 1), grid};
  for (const auto index : run.parts) {
    const ResolvedPart& part = resolved.parts[index];
    const auto needed = with_part_context(assembly, part.index, [&] {
      return std::visit(
          [&](const auto& shape) {
            const double share = part.ends_in_hub ? kArmShare : 1;
            return segments_for(shape, share * assembly.tolerance, grid);
          },
          part.shape);
    });
    result.segments = std::max(result.segments, needed);
  }
  result.segments = assembly.segments.value_or(result.segments);
  return result;
}

Tessellation tessellated(const Assembly& assembly, const ResolvedPart& part,
                         const RingSampling& sampling) {
  return with_part_context(assembly, part.index, [&] {
    return std::visit(Mesher{sampling, assembly.tolerance}, part.shape);
  });
}

}  // namespace dupin::assembly
