#include "assembly/bore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "assembly/fillet_part.h"
#include "assembly/narrowed_shape.h"
#include "assembly/outward_shape.h"
#include "assembly/part_context.h"
#include "assembly/part_margins.h"
#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/part_kind.h"
#include "canal/fillet_wall.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/junction.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/gap.h"
#include "numbers/point_order.h"

namespace dupin::assembly {
namespace {

constexpr double kReach = 1.0 / 8;  // beyond an end, of the wall

using SurfacePair = std::array<const PartSurface*, 2>;

[[noreturn]] void refuse(const std::string& why) { throw Error(Errc::infeasible_blend, why); }

// Where walls differ, what is left between both fillets, of the thinner wall, in what is said to
// do.
constexpr double kWallOfFillet = 1.0 / 4;

// Or, where walls are negative, what is thicker outside.
double thicker_of(const std::array<double, 2>& walls) {
  return std::abs(walls[0]) > std::abs(walls[1]) ? walls[0] : walls[1];
}

// Why the bores of pipes with these walls have no fillet within the outer one, which there is, with
// a ball that is larger by the thicker wall; none if they have, and so much of the thinner one is
// left between both.
std::optional<std::string> bore_fault(const SurfacePair& around, const SurfacePair& bores,
                                      const std::array<std::string, 2>& names, double radius,
                                      const std::array<double, 2>& walls, double left) {
  const double thicker = thicker_of(walls);
  if (auto fault = fillet_fault(bores, names, radius + thicker)) {
    return fault;
  }
  const bool are_concentric = walls[0] == walls[1];
  if (thicker <= 0 || are_concentric ||
      !canal::breaks_through(fillet_between(bores, names, radius + thicker).loops,
                             fillet_between(around, names, radius).loops,
                             left * std::min(walls[0], walls[1]))) {
    return std::nullopt;
  }
  return "the fillet breaks through the outer one, as the walls differ";
}

// Whether there are both fillets, with enough left between them.
bool both_fit(const SurfacePair& around, const std::array<std::string, 2>& names, double radius,
              const std::array<double, 2>& walls) {
  const auto bores = narrowed(around, walls);
  return !fillet_fault(around, names, radius) &&
         !bore_fault(around, {&bores[0], &bores[1]}, names, radius, walls, kWallOfFillet);
}

// A bore with this ring at its end: where it is the ring of its own, bitwise, and where it is a
// cyclide's neighbour.
struct EndChange {
  End end;
  const Ring& ring;

  Ring& stored(Piece& piece) const {
    return std::visit([&](auto& p) -> Ring& { return end == End::start ? p.start : p.end; }, piece);
  }
  void operator()(Sphere& /*sphere*/) const {}
  void operator()(Chain& chain) const {
    Piece& piece = end == End::start ? chain.pieces.front() : chain.pieces.back();
    Ring& own = stored(piece);
    const bool moves = own.center != ring.center || own.radius != ring.radius;
    own = ring;
    if (!moves || std::holds_alternative<CyclidePiece>(piece)) {
      return;
    }
    auto* tube = std::get_if<RingedSurface>(&piece);
    if (tube == nullptr || !std::holds_alternative<LineSpine>(tube->spine)) {
      refuse(
          "its bore cannot follow that of the cyclide next to it, which ends in a cone; put a "
          "straight pipe or cone between them");
    }
    if (!((tube->end.center - tube->start.center).dot(tube->end.normal) > 0)) {
      refuse("it is too short for the bore of the cyclide next to it, which reaches through it");
    }
    tube->spine = LineSpine{tube->start.center, tube->end.center};
    tube->radius = LinearRadius{tube->start.radius, tube->end.radius};
  }
};

// Goes on from an end of the bore until so far beyond the plane of its normal through `level`: as a
// cone, if the end lies before it on one.
void lengthen(ResolvedAssembly& bore, const EndIndex& end, const Vec3& level, double reach) {
  const ResolvedPart& part = bore.parts[end.part];
  const Ring ring = *port_ring(part.shape, end.end);
  const double before = (level - ring.center).dot(ring.normal);
  const double length = std::max(before, 0.0) + reach;
  const double radius = before > 0 ? ring.radius + ring.slope * length : ring.radius;
  if (!(radius > 0)) {
    refuse("the wall leaves no bore at its " + std::string(name(end.end)) +
           ": the parallel cone closes before it");
  }
  ResolvedPart next{
      part.name,
      part.kind,
      part.index,
      line(flipped(ring), ring.center + length * ring.normal, {radius, ring.ellipse}, false),
      {},
      {}};
  next.joined[0] = end;
  next.end_names.fill(part.name);
  bore.parts[end.part].joined.at(at(end.end)) =
      EndIndex{std::uint32_t(bore.parts.size()), End::start};
  bore.parts.push_back(std::move(next));
}

// Walls below 0 lead outwards.
class Borer {
 public:
  Borer(const Assembly& assembly, const ResolvedAssembly& outer, const std::vector<double>& walls,
        std::string_view suffix)
      : assembly_(assembly), walls_(walls), suffix_(suffix) {
    std::vector<bool> is_hollow(walls.size());
    std::transform(walls.begin(), walls.end(), is_hollow.begin(),
                   [](double wall) { return wall != 0; });
    bore_ = selected_parts(outer, is_hollow);
    outer_ = bore_.resolved;
  }

  SelectedParts run() {
    for (ResolvedPart& part : bore_.resolved.parts) {
      within(part.index, [&] { narrow(part); });
    }
    for (ResolvedJunction& junction : bore_.resolved.junctions) {
      within(junction.index, [&] { narrow(junction); });
    }
    for (std::uint32_t part = 0; part < outer_.parts.size(); ++part) {
      within(outer_.parts[part].index, [&] { join_ends(part); });
    }
    std::erase_if(bore_.resolved.fillets, [&](const ResolvedFillet& fillet) {
      return !fillet.shape.is_cope() && !(fillet.shape.radius + thicker_of(walls_at(fillet)) > 0);
    });
    for (ResolvedFillet& fillet : bore_.resolved.fillets) {
      within(fillet.index, [&] { enlarge(fillet); });
    }
    for (const EndIndex& end : narrower_) {
      const ResolvedPart& part = outer_.parts[end.part];
      const EndIndex& other = *part.joined.at(at(end.end));
      within(part.index, [&] {
        lengthen(bore_.resolved, end, inner_ring(outer_.parts[other.part], other.end).center,
                 kReach * walls_[part.index]);
      });
    }
    return std::move(bore_);
  }

 private:
  template <typename Work>
  void within(std::uint32_t index, const Work& work) const {
    with_part_context(assembly_, index, work);
  }

  void narrow(ResolvedPart& part) const {
    const std::string inner = part.name + std::string(suffix_);
    for (const End end : {End::start, End::end}) {
      part.end_names.at(at(end)) = part.may_open(end) ? to_string({inner, end}) : inner;
    }
    part.name = inner;
    const double wall = walls_[part.index];
    part.shape = wall < 0 ? insulation_shape(part, -wall) : narrowed_shape(part, wall);
  }

  [[nodiscard]] PartSurface narrowed_shape(const ResolvedPart& part, double wall) const {
    if (const PartKind& kind = part_kind(assembly_.parts[part.index].shape); kind.bore != nullptr) {
      return kind.bore(outer_shape(assembly_, part.index), part.shape, wall);
    }
    return part.ends_in_hub ? part.shape : narrowed(part.shape, wall);
  }

  [[nodiscard]] PartSurface insulation_shape(const ResolvedPart& part, double thickness) const {
    const auto made = [&](double tried) {
      PartSurface shape = narrowed_shape(part, -tried);
      (void)margins(shape, false, part.kind);
      return shape;
    };
    try {
      return made(thickness);
    } catch (const Error& folds) {
      refuse_insulation(thickness, folds, InsulationAdvice::largest, made);
    }
  }

  // The arms are parts, and end in the circles that the hub has, bitwise.
  void narrow(ResolvedJunction& junction) {
    junction.name += suffix_;
    const double wall = walls_[junction.index];
    const Junction outer = junction.shape;
    try {
      junction.shape = narrowed(outer, wall);
    } catch (const Error& folds) {
      if (wall > 0) {
        throw;
      }
      refuse_insulation(-wall, folds, InsulationAdvice::some,
                        [&outer](double tried) { (void)narrowed(outer, -tried); });
    }
    for (std::size_t i = 0; i < junction.arms.size(); ++i) {
      bore_.resolved.parts[junction.arms[i]].shape = tube(junction.shape.arms[i]);
    }
  }

  // The ring of the bore's end: both neighbours find the same.
  [[nodiscard]] Ring inner_ring(const ResolvedPart& part, End end) const {
    const Ring& ring = *port_ring(part.shape, end);
    const auto& joined = part.joined.at(at(end));
    const bool of_cone = ends_cone_of_cyclide(part, end) ||
                         (joined && ends_cone_of_cyclide(outer_.parts[joined->part], joined->end));
    return of_cone ? parallel(ring, walls_[part.index]) : narrowed(ring, walls_[part.index]);
  }

  void join_ends(std::uint32_t index) {
    const ResolvedPart& part = outer_.parts[index];
    ResolvedPart& inner = bore_.resolved.parts[index];
    for (const End end : {End::start, End::end}) {
      if (port_ring(part.shape, end) == nullptr || (part.ends_in_hub && end == End::end) ||
          part.is_closed.at(at(end))) {
        continue;
      }
      std::visit(EndChange{end, inner_ring(part, end)}, inner.shape);
      auto& joined = inner.joined.at(at(end));
      if (!joined || walls_[outer_.parts[joined->part].index] == walls_[part.index]) {
        continue;
      }
      if (walls_[part.index] > 0 && walls_[outer_.parts[joined->part].index] < walls_[part.index]) {
        narrower_.push_back({index, end});
      }
      joined.reset();
    }
  }

  void enlarge(ResolvedFillet& fillet) const {
    std::array<const PartSurface*, 2> pipes{};
    std::array<std::string, 2> names;
    for (std::size_t i = 0; i < 2; ++i) {
      const ResolvedPart& pipe = bore_.resolved.parts[fillet.between.at(i)];
      pipes.at(i) = &pipe.shape;
      names.at(i) = pipe.name;
    }
    fillet.name += suffix_;
    if (fillet.shape.is_cope()) {
      fillet.shape = cope_between(pipes, names);
      return;
    }
    const std::array<double, 2> walls = walls_at(fillet);
    const double radius = fillet.shape.radius, thicker = thicker_of(walls);
    if (const auto fault = bore_fault(around(fillet), pipes, names, radius, walls, 0)) {
      refuse((thicker > 0 ? "inside, where the ball has a radius of "
                          : "outside, where the ball has a radius of ") +
             decimal(radius + thicker, kMessageDigits) +
             (thicker > 0 ? ", larger by the wall, " : ", smaller by what is about the pipe, ") +
             *fault + what_would_do(fillet, names));
    }
    fillet.shape = fillet_between(pipes, names, radius + thicker);
  }

  // The largest ball for these walls, the thickest walls for this ball, and the thinnest wall
  // beside the thicker one.
  [[nodiscard]] std::string what_would_do(const ResolvedFillet& fillet,
                                          const std::array<std::string, 2>& names) const {
    const std::array<double, 2> walls = walls_at(fillet);
    if (thicker_of(walls) <= 0) {
      return {};
    }
    const double radius = fillet.shape.radius;
    const SurfacePair outer = around(fillet);
    std::vector<std::string> remedies;
    if (const auto smaller = largest_radius_below(
            radius, [&](double tried) { return both_fit(outer, names, tried, walls); })) {
      remedies.push_back("a fillet of radius " + decimal(*smaller));
    }
    if (auto thinner = thinner_walls(outer, names, radius, {walls, outward_at(fillet)})) {
      remedies.push_back(std::move(*thinner));
    }
    const bool are_alike = walls[0] == walls[1];
    if (const auto thicker = are_alike ? std::nullopt : fitting_thinner_wall(fillet, names)) {
      remedies.push_back(*thicker);
    }
    if (remedies.empty()) {
      return "; neither a smaller fillet nor a thinner wall would do";
    }
    std::string text = "; ";
    for (const std::string& remedy : remedies) {
      text += (text.size() > 2 ? ", or " : "") + remedy;
    }
    return text + " would do";
  }

  // The least wall of the part with the thinner one, where radii are those of outer surfaces.
  [[nodiscard]] std::optional<std::string> fitting_thinner_wall(
      const ResolvedFillet& fillet, const std::array<std::string, 2>& names) const {
    const std::array<double, 2> walls = walls_at(fillet);
    const std::size_t thin = walls[0] < walls[1] ? 0 : 1;
    const double most = walls.at(1 - thin), apart = most - walls.at(thin);
    if (outward_at(fillet) != std::array<double, 2>{}) {
      return std::nullopt;
    }
    const auto largest = largest_radius_below(apart, [&](double tried) {
      std::array<double, 2> changed = walls;
      changed.at(thin) = most - tried;
      return both_fit(around(fillet), names, fillet.shape.radius, changed);
    });
    const std::string& name = outer_.parts[fillet.between.at(thin)].name;
    return largest ? std::optional("a wall of " + decimal_at_most(most - *largest) + " of '" +
                                   name + "'")
                   : std::nullopt;
  }

  [[nodiscard]] SurfacePair around(const ResolvedFillet& fillet) const {
    return {&outer_.parts[fillet.between[0]].shape, &outer_.parts[fillet.between[1]].shape};
  }

  [[nodiscard]] std::array<double, 2> walls_at(const ResolvedFillet& fillet) const {
    return {walls_[outer_.parts[fillet.between[0]].index],
            walls_[outer_.parts[fillet.between[1]].index]};
  }

  [[nodiscard]] std::array<double, 2> outward_at(const ResolvedFillet& fillet) const {
    const auto of = [&](std::uint32_t pipe) {
      return outward_distance(assembly_, assembly_.parts[outer_.parts[pipe].index]);
    };
    return {of(fillet.between[0]), of(fillet.between[1])};
  }

  const Assembly& assembly_;
  const std::vector<double>& walls_;
  std::string_view suffix_;
  SelectedParts bore_;
  ResolvedAssembly outer_;          // of the hollow parts
  std::vector<EndIndex> narrower_;  // ends in the bore whose neighbours are wider
};

// Half of the distance to an end that faces this one, so that no bore cuts the other's part.
std::map<std::string, double> half_gaps(const ResolvedAssembly& outer, double connect) {
  const std::vector<Port> all = ports(outer);
  std::map<std::string, double> result;
  for (const GapPair& pair : pair_ends(all, connect)) {
    if (pair.second && pair.report.verdict == GapVerdict::gap) {
      result[all[pair.first].name] = result[all[*pair.second].name] = pair.report.axial.lower / 2;
    }
  }
  return result;
}

bool says_wall(const Assembly& assembly) {
  return assembly.wall || std::ranges::any_of(assembly.parts, [](const Part& part) {
           return part.wall.value_or(0) > 0;
         });
}

std::map<Vec3, EndIndex, numbers::PointOrder> solids_by_center(const ResolvedAssembly& outer,
                                                               const SelectedParts& solids) {
  std::map<Vec3, EndIndex, numbers::PointOrder> result;
  for (std::uint32_t i = 0; i < outer.parts.size(); ++i) {
    for (const End end : {End::start, End::end}) {
      if (const Ring* ring = port_ring(outer.parts[i].shape, end); ring && solids.position[i]) {
        result.try_emplace(ring->center, EndIndex{i, end});
      }
    }
  }
  return result;
}

}  // namespace

double wall_of(const Assembly& assembly, const Part& part) {
  const double usual = part_kind(part.shape).is_pad ? 0 : assembly.wall.value_or(0);
  return part.solid ? 0 : part.wall.value_or(usual);
}

std::optional<std::vector<double>> walls_of(const Assembly& assembly, const ResolvedAssembly& outer,
                                            std::optional<Region> asked) {
  std::vector<double> result(assembly.parts.size());
  std::ranges::transform(assembly.parts, result.begin(),
                         [&](const Part& part) { return wall_of(assembly, part); });
  bool has_hollow_chain = false;
  for (const ResolvedPart& part : outer.parts) {
    const auto* chain = std::get_if<Chain>(&part.shape);
    if (chain != nullptr && chain->wall > 0) {
      has_hollow_chain = true;
      const Part& said = assembly.parts[part.index];
      result[part.index] = said.solid ? 0 : said.wall.value_or(chain->wall);
    }
  }
  const bool has_walls = says_wall(assembly) || (asked && has_hollow_chain);
  return has_walls ? std::optional(std::move(result)) : std::nullopt;
}

bool bore_takes(const std::array<const PartSurface*, 2>& surfaces,
                const std::array<std::string, 2>& names, double radius,
                const std::array<double, 2>& walls) {
  if (!(walls[0] > 0 && walls[1] > 0)) {
    return true;
  }
  std::array<PartSurface, 2> bores;
  try {
    bores = narrowed(surfaces, walls);
  } catch (const Error&) {
    return true;  // whatever the fillet
  }
  return !bore_fault(surfaces, {&bores[0], &bores[1]}, names, radius, walls, kWallOfFillet);
}

std::optional<std::string> thinner_walls(const std::array<const PartSurface*, 2>& around,
                                         const std::array<std::string, 2>& names, double radius,
                                         const PipeWalls& walls) {
  const bool are_alike = walls.walls[0] == walls.walls[1];
  const double whole = are_alike ? walls.walls[0] : 1;
  const auto thinner = largest_radius_below(whole, [&](double tried) {
    const double share = tried / whole, less = 1 - share;
    const auto outer = narrowed(around, {walls.outward[0] * less, walls.outward[1] * less});
    return both_fit({&outer[0], &outer[1]}, names, radius,
                    {walls.walls[0] * share, walls.walls[1] * share});
  });
  return !thinner    ? std::nullopt
         : are_alike ? std::optional("a wall of " + decimal(*thinner))
                     : std::optional("walls " + decimal(*thinner) + " times as thick");
}

PipeWalls pipe_walls(const Assembly& assembly, const std::array<std::uint32_t, 2>& parts) {
  PipeWalls result;
  for (std::size_t i = 0; i < 2; ++i) {
    const Part& part = assembly.parts[parts.at(i)];
    result.walls.at(i) = wall_of(assembly, part);
    result.outward.at(i) = outward_distance(assembly, part);
  }
  result.starts = pipe_starts(assembly, parts);
  return result;
}

bool ends_cone_of_cyclide(const ResolvedPart& part, End end) {
  const auto* chain = std::get_if<Chain>(&part.shape);
  if (chain == nullptr || chain->pieces.empty()) {
    return false;
  }
  const Piece& piece = end == End::start ? chain->pieces.front() : chain->pieces.back();
  return std::holds_alternative<CyclidePiece>(piece) && end_ring(piece, end).slope != 0;
}

ResolvedAssembly filled(ResolvedAssembly outer) {
  for (ResolvedPart& part : outer.parts) {
    if (auto* chain = std::get_if<Chain>(&part.shape)) {
      chain->wall = 0;
    }
  }
  return outer;
}

SelectedParts bore_of(const Assembly& assembly, const ResolvedAssembly& outer,
                      const std::vector<double>& walls) {
  return Borer(assembly, outer, walls, kBoreSuffix).run();
}

std::vector<double> insulation_of(const Assembly& assembly) {
  std::vector<double> result(assembly.parts.size());
  std::ranges::transform(assembly.parts, result.begin(), [&](const Part& part) {
    return part.insulation.value_or(assembly.insulation.value_or(0));
  });
  return std::ranges::any_of(result, [](double thickness) { return thickness > 0; })
             ? result
             : std::vector<double>();
}

SelectedParts insulated(const Assembly& assembly, const ResolvedAssembly& outer,
                        const std::vector<double>& insulation) {
  std::vector<double> outwards(insulation.size());
  std::ranges::transform(insulation, outwards.begin(), std::negate<>());
  return Borer(assembly, outer, outwards, kInsulationSuffix).run();
}

ResolvedAssembly reaching_out(ResolvedAssembly outer, const Assembly& assembly, double reach,
                              const std::set<std::string>& kept) {
  const std::size_t count = outer.parts.size();
  const BuriedEnds buried(outer);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const End end : {End::start, End::end}) {
      const ResolvedPart& part = outer.parts[i];
      const Ring* ring = port_ring(part.shape, end);
      const bool is_pad = part_kind(assembly.parts[part.index].shape).is_pad;
      if (ring != nullptr && !part.joined.at(at(end)) && (is_pad || !part.is_closed.at(at(end))) &&
          !buried.contains({i, end}) && !kept.contains(part.end_names.at(at(end)))) {
        const std::string name = part.end_names.at(at(end));
        with_part_context(assembly, part.index, [&] {
          lengthen(outer, {i, end}, Vec3(ring->center), reach);
        });
        outer.parts.back().end_names[1] = name;
      }
    }
  }
  return outer;
}

double lattice_for_gaps(double grid, const ResolvedAssembly& outer,
                        const std::vector<double>& walls) {
  double largest = 0;
  for (const Port& port : ports(outer)) {
    largest = std::max(largest, port.ring.center.cwiseAbs().maxCoeff() + largest_radius(port.ring));
  }
  for (const auto& [name, half] : half_gaps(outer, kReach * std::ranges::max(walls))) {
    const double wanted = std::ldexp(1.0, std::ilogb(half) - 3);
    if (half > 0 && largest < std::ldexp(wanted, 48)) {
      grid = std::min(grid, wanted);
    }
  }
  return grid;
}

void lengthen_out_of(SelectedParts& bore, const Assembly& assembly, const ResolvedAssembly& outer,
                     const std::vector<double>& walls, const std::set<std::string>& end_names) {
  const std::map<std::string, double> room = half_gaps(outer, kReach * std::ranges::max(walls));
  const BuriedEnds buried(outer);
  for (std::uint32_t i = 0; i < outer.parts.size(); ++i) {
    for (const End end : {End::start, End::end}) {
      const ResolvedPart& part = outer.parts[i];
      const Ring* ring = port_ring(part.shape, end);
      if (bore.position[i] && ring != nullptr && !part.joined.at(at(end)) &&
          !buried.contains({i, end}) && part.may_open(end) &&
          end_names.contains(part.end_names.at(at(end)))) {
        const auto gap = room.find(to_string({part.name, end}));
        const double reach = kReach * walls[part.index];
        const double least = gap == room.end() ? reach : std::min(reach, gap->second);
        with_part_context(assembly, part.index, [&] {
          lengthen(bore.resolved, {*bore.position[i], end}, ring->center, least);
        });
      }
    }
  }
}

ResolvedAssembly kept_out_of_solids(SelectedParts& bore, const Assembly& assembly,
                                    const ResolvedAssembly& outer,
                                    const std::vector<double>& walls) {
  std::vector<bool> is_solid(assembly.parts.size());
  std::transform(assembly.parts.begin(), assembly.parts.end(), is_solid.begin(),
                 [](const Part& part) { return part.solid; });
  SelectedParts kept = selected_parts(outer, is_solid);
  const auto facing = solids_by_center(outer, kept);
  for (std::uint32_t i = 0; i < outer.parts.size(); ++i) {
    for (const End end : {End::start, End::end}) {
      const Ring* ring = port_ring(outer.parts[i].shape, end);
      if (!bore.position[i] || ring == nullptr || !facing.contains(ring->center) ||
          bore.resolved.parts[*bore.position[i]].joined.at(at(end))) {
        continue;  // what goes on there, the solid part cuts on both sides
      }
      const EndIndex solid = facing.at(ring->center);
      const PartSurface& shape = outer.parts[solid.part].shape;
      if (port_ring(shape, solid.end)->normal != -ring->normal) {
        continue;
      }
      double reach = kReach * walls[outer.parts[i].index];
      if (const Ring* beyond = port_ring(shape, opposite(solid.end))) {
        reach = std::min(reach, (beyond->center - ring->center).norm() / 2);
      }
      const EndIndex inner{*bore.position[i], end};
      with_part_context(assembly, outer.parts[i].index,
                        [&] { lengthen(bore.resolved, inner, ring->center, reach); });
      kept.resolved.parts[*kept.position[solid.part]].end_names.at(at(solid.end)) =
          bore.resolved.parts[inner.part].end_names.at(at(end));
    }
  }
  return std::move(kept.resolved);
}

}  // namespace dupin::assembly
