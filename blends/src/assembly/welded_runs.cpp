#include "assembly/welded_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

std::size_t at(PartEnd end) { return end == PartEnd::start ? 0 : 1; }

PartEnd other(PartEnd end) { return end == PartEnd::start ? PartEnd::end : PartEnd::start; }

// Walks from `part` out through its `exit` until an open end or back at the part.
std::vector<std::uint32_t> walk(const ResolvedAssembly& assembly, std::uint32_t part,
                                PartEnd exit) {
  std::vector<std::uint32_t> passed{part};
  for (auto next = assembly.parts[part].joined.at(at(exit)); next && next->part != part;
       next = assembly.parts[passed.back()].joined.at(at(other(next->end)))) {
    passed.push_back(next->part);
  }
  return passed;
}

struct Extent {
  double smallest, largest;

  void include(double size) { smallest = std::min(smallest, size); }
  void include(const Vec3& point, double radius) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff() + radius);
  }
};

void include(Extent& extent, const std::vector<PeArc>& pieces, double wall) {
  if (wall > 0) {
    extent.include(wall);
  }
  for (const PeArc& piece : pieces) {
    extent.include(least_radius(piece) - wall);
    extent.include(piece.start().m, piece.start().r);
    extent.include(piece.end().m, piece.end().r);
  }
}

Extent extent_of(const PartSurface& shape) {
  Extent extent{std::numeric_limits<double>::infinity(), 0};
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    extent.include(sphere->radius);
    extent.include(sphere->center, sphere->radius);
    return extent;
  }
  if (const auto* tube = std::get_if<CyclideTube>(&shape)) {
    include(extent, tube->chain.pieces, tube->wall);
  }
  if (const auto* chain = std::get_if<KneecapChain>(&shape)) {
    include(extent, chain->pieces, 0);
  }
  for (const PartEnd end : {PartEnd::start, PartEnd::end}) {
    if (const Ring* ring = port_ring(shape, end)) {
      extent.include(std::min(ring->radius, across(*ring)));
      extent.include(ring->center, largest_radius(*ring));
    }
  }
  const auto* surface = std::get_if<RingedSurface>(&shape);
  if (surface != nullptr && std::holds_alternative<LineSpine>(surface->spine)) {
    extent.include((surface->end.center - surface->start.center).norm());
  }
  return extent;
}

}  // namespace

std::vector<WeldedRun> welded_runs(const ResolvedAssembly& assembly) {
  std::vector<WeldedRun> result;
  std::vector<bool> done(assembly.parts.size(), false);
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    if (done[i]) {
      continue;
    }
    // To one end of the run, then from there to the other.
    const auto back = walk(assembly, i, PartEnd::start);
    const auto& joined = assembly.parts[back.back()].joined;
    const bool leaves_by_end = !joined.at(0);
    const auto forward = walk(assembly, back.back(), leaves_by_end ? PartEnd::end : PartEnd::start);
    // In a closed loop both walks come all the way round.
    const bool is_loop = joined.at(0) && joined.at(1);
    WeldedRun run{is_loop ? walk(assembly, i, PartEnd::end) : forward};
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
  const ResolvedPart *smallest = nullptr, *largest = nullptr;
  for (const ResolvedPart& part : resolved.parts) {
    const Extent own = extent_of(part.shape);
    if (own.smallest < extent.smallest) {
      extent.smallest = own.smallest;
      smallest = &part;
    }
    if (own.largest > extent.largest) {
      extent.largest = own.largest;
      largest = &part;
    }
  }
  const double spacing = std::ldexp(1.0, std::ilogb(extent.smallest) - 11);
  // One bit is left for bends that reach further than their ends.
  if (!(extent.largest < std::ldexp(spacing, 51))) {
    const std::string problem = decimal(extent.smallest) + ", is too small for coordinates of " +
                                decimal(extent.largest) + " (of '" + largest->name +
                                "'); it must be at least " +
                                decimal(std::ldexp(extent.largest, -39), 2);
    throw smallest == nullptr
        ? Error(Errc::invalid_argument, "the tolerance, " + problem, {},
                document_place(assembly, "/tolerance"))
        : Error(Errc::invalid_argument, "its smallest radius or length, " + problem, smallest->name,
                document_place(assembly, smallest->index));
  }
  return spacing;
}

}  // namespace dupin::assembly
