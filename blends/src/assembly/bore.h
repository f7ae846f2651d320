#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "assembly/fillet_part.h"
#include "assembly/selected_parts.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"

namespace dupin::assembly {

constexpr std::string_view kBoreSuffix = ".bore", kInsulationSuffix = ".insulation";

/// Of one part, 0 of one without a bore.
[[nodiscard]] double wall_of(const Assembly& assembly, const Part& part);

/// The thickness of the walls of all parts, by their places in Assembly::parts; 0 of a part without
/// a bore. None of an assembly that has no walls: neither the document nor any part says one, nor
/// is there a hollow chain where a region was asked for.
[[nodiscard]] std::optional<std::vector<double>> walls_of(const Assembly& assembly,
                                                          const ResolvedAssembly& outer,
                                                          std::optional<Region> asked);

/// Whether a ring of the part is that of a cyclide, which ends a cone there.
[[nodiscard]] bool ends_cone_of_cyclide(const ResolvedPart& part, End end);

/// The parts without their walls: hollow chains become solid ones.
[[nodiscard]] ResolvedAssembly filled(ResolvedAssembly outer);

/// What the walls of the hollow parts enclose, part by part, named "part.bore", its
/// ends "part.bore.start" and "part.bore.end".
///
/// Of a ringed part the circles with radii less by the wall, in the same planes: parts that share a
/// ring share the inner one. Of cyclides and hubs the parallel surface, which is the same where
/// rings end cylinders; a straight neighbour follows where they end cones. Of fillets that of a
/// ball larger by the wall. Where walls of neighbours differ, the narrower bore reaches a little
/// into the wider one.
///
/// Throws Error{infeasible_blend} naming the part whose wall leaves no bore, or whose bore would
/// fold or not meet its neighbour's.
[[nodiscard]] SelectedParts bore_of(const Assembly& assembly, const ResolvedAssembly& outer,
                                    const std::vector<double>& walls);

/// Of these of Assembly::parts.
[[nodiscard]] PipeWalls pipe_walls(const Assembly& assembly,
                                   const std::array<std::uint32_t, 2>& parts);

/// Whether the bore of both pipes has its fillet, too, where the outer ball has this radius, as far
/// as their walls leave a bore; true where not both are hollow.
[[nodiscard]] bool bore_takes(const std::array<const PartSurface*, 2>& pipes,
                              const std::array<std::string, 2>& names, double radius,
                              const std::array<double, 2>& walls);

/// "a wall of 2", or "walls 0.5 times as thick": with which it does; none if with none.
[[nodiscard]] std::optional<std::string> thinner_walls(
    const std::array<const PartSurface*, 2>& pipes, const std::array<std::string, 2>& names,
    double radius, const PipeWalls& walls);

/// How thick the insulation of all parts is, by their places in Assembly::parts. Empty if there is
/// none.
[[nodiscard]] std::vector<double> insulation_of(const Assembly& assembly);

/// The parts that are insulated, with the outer surface of their insulation, named
/// "part.insulation": what a bore is inwards, outwards. Of fillets, balls are smaller by the
/// insulation; where that leaves none, the sharp edge.
///
/// Throws Error{irregular_surface} or Error{infeasible_blend} naming the part that is bent more
/// tightly than its insulation can follow.
[[nodiscard]] SelectedParts insulated(const Assembly& assembly, const ResolvedAssembly& outer,
                                      const std::vector<double>& insulation);

/// All parts, of which those with ends that go on nowhere reach out of them by so much, but for
/// those of these names: what is taken away from insulation, whose ends lie in the same planes.
[[nodiscard]] ResolvedAssembly reaching_out(ResolvedAssembly outer, const Assembly& assembly,
                                            double reach, const std::set<std::string>& kept = {});

/// A lattice no coarser than `grid`, and than a sixteenth of the gaps that bores reach into, where
/// coordinates can be that fine.
[[nodiscard]] double lattice_for_gaps(double grid, const ResolvedAssembly& outer,
                                      const std::vector<double>& walls);

/// Lets the bore reach out of the ends that have these names, by an eighth of the wall, or by half
/// the gap to an end that they face: there it cuts clean rims. Throws Error{infeasible_blend} where
/// a cone closes before.
void lengthen_out_of(SelectedParts& bore, const Assembly& assembly, const ResolvedAssembly& outer,
                     const std::vector<double>& walls, const std::set<std::string>& end_names);

/// The parts that are solid, which no bore cuts. Where a bore ends at the ring of one, or at its
/// face about the same centre, as a blind flange's, it reaches into it by an eighth of the wall, or
/// half of its length, to be cut off by its end alone, which has the name of the bore's: two ends
/// in one plane, each rounded by itself, cross each other.
[[nodiscard]] ResolvedAssembly kept_out_of_solids(SelectedParts& bore, const Assembly& assembly,
                                                  const ResolvedAssembly& outer,
                                                  const std::vector<double>& walls);

/// The names of the labels that the solid has.
[[nodiscard]] std::set<std::string> names_seen(const Solid& solid);

/// smooth_region() of what was built, whose solid, with labels of these names, need not be at hand.
[[nodiscard]] SmoothRegion smooth_region_seen(const Assembly& assembly, const Built& built,
                                              const std::set<std::string>& names);

}  // namespace dupin::assembly
