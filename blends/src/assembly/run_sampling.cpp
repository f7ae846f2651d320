#include "assembly/run_sampling.h"

#include <algorithm>
#include <cmath>

#include "assembly/part_context.h"

namespace dupin::assembly {
namespace {

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

RingSampling run_sampling(const Assembly& assembly, const ResolvedAssembly& resolved,
                          const WeldedRun& run, std::size_t position, double grid) {
  RingSampling result{0, std::fmod(0.37 * double(position), 1), grid};
  for (const auto index : run.parts) {
    const ResolvedPart& part = resolved.parts[index];
    const auto needed = with_part_context(assembly, part.index, [&] {
      return std::visit(
          [&](const auto& shape) { return segments_for(shape, assembly.tolerance, grid); },
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
