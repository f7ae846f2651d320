#include "dupin/blends/resolve.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

#include "assembly/document_bounds.h"
#include "assembly/outward_shape.h"
#include "assembly/part_context.h"
#include "assembly/parts/part_kind.h"
#include "assembly/printable_names.h"
#include "canal/straight_pipe.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

using assembly::bounds_and;
using assembly::is_within_bounds;
using assembly::part_kind;
using assembly::Reference;
using assembly::References;

References references(const PartShape& shape) { return part_kind(shape).references(shape); }

class Resolver {
 public:
  explicit Resolver(const Assembly& assembly)
      : assembly_(assembly), ends_(assembly.parts.size()), shapes_(assembly.parts.size()) {}

  ResolvedAssembly run() {
    check_header();
    check_names();
    check_walls();
    take_shapes();
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      for (const auto& reference : references(assembly_.parts[i].shape)) {
        join(i, reference);
      }
      check_needs(i);
      take_ends(i);
    }
    for (const auto part : in_order_of_need()) {
      if (part_kind(assembly_.parts[part].shape).is_part()) {
        shapes_[part] = geometry(part);
      }
    }
    return collected();
  }

 private:
  // The parts that fillets are between, and which fillet it is.
  using FilletedPairs = std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;

  struct EndState {
    std::string taken_by;
    std::optional<EndIndex> joined;
    std::string cap;
  };

  [[noreturn]] void fail(std::uint32_t part, std::string_view key,
                         const std::string& message) const {
    throw Error(Errc::invalid_argument, message, assembly_.parts[part].name,
                document_place(assembly_, part, key));
  }

  void check_header() const {
    const double tolerance = assembly_.tolerance;
    if (!is_within_bounds(tolerance)) {
      throw Error(Errc::invalid_argument,
                  "the tolerance must be a positive number " + bounds_and(tolerance), {},
                  document_place(assembly_, "/tolerance"));
    }
    const std::uint32_t segments = assembly_.segments.value_or(kFewestSegments);
    if (segments < kFewestSegments || segments > kMostSegments) {
      throw Error(Errc::invalid_argument,
                  "a ring needs " + std::to_string(kFewestSegments) + " to " +
                      std::to_string(kMostSegments) + " segments, not " + std::to_string(segments),
                  {}, document_place(assembly_, "/segments"));
    }
    if (assembly_.parts.empty()) {
      throw Error(Errc::invalid_argument, "an assembly needs at least one part", {},
                  document_place(assembly_, "/parts"));
    }
  }

  // As the outer surfaces have them.
  void take_shapes() {
    outer_shapes_.reserve(assembly_.parts.size());
    for (const Part& part : assembly_.parts) {
      outward_.push_back(assembly::outward_distance(assembly_, part));
      outer_shapes_.push_back(assembly::outward_shape(part.shape, outward_.back()));
    }
  }

  // Radii that are not the outer surfaces' are one and the same to both sides of a ring only where
  // these are as far outside.
  void check_sides(std::uint32_t part, std::uint32_t other, std::string_view key) const {
    if (outward_[part] != outward_[other] && !assembly_.parts[part].solid &&
        !assembly_.parts[other].solid) {
      fail(part, key,
           "it shares a ring with '" + assembly_.parts[other].name + "', whose outer surface is " +
               decimal(outward_[other], kMessageDigits) +
               " outside of the radii in the document, and its own " +
               decimal(outward_[part], kMessageDigits) +
               "; where radii are not outside ones, neighbours have the same wall and wall_side");
    }
  }

  void check_insulation(const std::optional<double>& thickness, const std::string& name,
                        const std::string& place) const {
    if (thickness.value_or(0) != 0 && !is_within_bounds(*thickness)) {
      throw Error(Errc::invalid_argument,
                  "the insulation must be 0 for none, or " + bounds_and(*thickness), name, place);
    }
  }

  // A document's wall is positive; a part's may be 0, which leaves it without a bore of its own.
  void check_walls() const {
    check_insulation(assembly_.insulation, {}, document_place(assembly_, "/insulation"));
    if (assembly_.wall && !is_within_bounds(*assembly_.wall)) {
      throw Error(Errc::invalid_argument,
                  "the wall must be a positive number " + bounds_and(*assembly_.wall), {},
                  document_place(assembly_, "/wall"));
    }
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      const Part& part = assembly_.parts[i];
      const auto fault = [&](const std::string& message) {
        return Error(Errc::invalid_argument, message, part.name,
                     document_place(assembly_, i) + "/wall");
      };
      const assembly::PartKind& its_kind = part_kind(part.shape);
      check_insulation(part.insulation, part.name, document_place(assembly_, i) + "/insulation");
      if (part.wall.value_or(0) != 0 && !is_within_bounds(*part.wall)) {
        throw fault("a part's wall must be 0 for none, or " + bounds_and(*part.wall));
      }
      if ((part.wall || part.solid) && !its_kind.is_part() && !its_kind.is_junction()) {
        throw fault("a " + std::string(its_kind.key) + " has the wall of the parts it is at");
      }
      if (its_kind.is_pad && part.wall.value_or(0) > 0) {
        throw fault("a " + std::string(its_kind.key) +
                    " has no bore of its own, but those of others pass through it");
      }
      if (part.solid && part.wall.value_or(0) > 0) {
        throw fault("a solid part has no wall");
      }
    }
  }

  void check_names() {
    assembly::require_printable_names(assembly_);
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      const std::string& name = assembly_.parts[i].name;
      const auto fault = [&](const std::string& message) {
        return Error(Errc::invalid_argument, message, name, document_place(assembly_, i) + "/name");
      };
      if (const auto [entry, is_new] = index_.try_emplace(name, i); !is_new) {
        const std::string& pointer = assembly_.parts[entry->second].pointer;
        throw fault("the name is already taken by " +
                    (pointer.empty() ? "/parts/" + std::to_string(entry->second) : pointer));
      }
    }
  }

  [[nodiscard]] std::uint32_t referred(std::uint32_t part, const Reference& reference) const {
    const auto found = index_.find(reference.port.part);
    if (found == index_.end()) {
      fail(part, reference.key, "there is no part named '" + reference.port.part + "'");
    }
    const PartShape& shape = assembly_.parts[found->second].shape;
    const std::string_view portless = part_kind(shape).portless(shape);
    if (!portless.empty()) {
      fail(part, reference.key,
           "'" + reference.port.part + "' is " + std::string(portless) + " and has no ports");
    }
    if (part_kind(shape).closed_ends.at(at(reference.port.end))) {
      fail(part, reference.key,
           "'" + reference.port.part + "' is closed: it has no " +
               std::string(name(reference.port.end)));
    }
    return found->second;
  }

  void check_needs(std::uint32_t part) const {
    const PartShape& shape = assembly_.parts[part].shape;
    for (const assembly::Need& need : part_kind(shape).needs(shape)) {
      const auto found = index_.find(need.part);
      if (found == index_.end()) {
        fail(part, need.key, "there is no part named '" + need.part + "'");
      }
      const assembly::PartKind& its_kind = part_kind(assembly_.parts[found->second].shape);
      if (!its_kind.is_part()) {
        fail(part, need.key,
             "'" + need.part + "' is a " + std::string(its_kind.key) +
                 ", which is no solid of its own");
      }
      for (const Reference& reference : references(shape)) {
        if (reference.port.part == need.part) {
          fail(part, need.key, "'" + need.part + "' is where it begins or ends");
        }
      }
    }
  }

  // The parts that one comes after, and under which keys they are named.
  [[nodiscard]] std::vector<assembly::Need> needs(std::uint32_t part) const {
    const PartShape& shape = assembly_.parts[part].shape;
    std::vector<assembly::Need> result = part_kind(shape).needs(shape);
    for (const Reference& reference : references(shape)) {
      result.push_back({reference.port.part, reference.key});
    }
    return result;
  }

  void take(std::uint32_t part, std::string_view key, EndIndex end, const std::string& by) {
    std::string& taken_by = ends_[end.part].at(at(end.end)).taken_by;
    if (!taken_by.empty()) {
      fail(part, key,
           "the port '" + to_string({assembly_.parts[end.part].name, end.end}) +
               "' is already taken by '" + taken_by + "'");
    }
    taken_by = by;
  }

  void join(std::uint32_t part, const Reference& reference) {
    const std::string& name = assembly_.parts[part].name;
    const EndIndex other{referred(part, reference), reference.port.end};
    take(part, reference.key, other, name);
    EndState& other_end = ends_[other.part].at(at(other.end));
    if (part_kind(assembly_.parts[part].shape).names_end) {
      other_end.cap = name;
      return;
    }
    const EndIndex own{part, reference.own_end};
    check_sides(part, other.part, reference.key);
    take(part, reference.key, own, reference.port.part);
    other_end.joined = own;
    ends_[part].at(at(own.end)).joined = other;
  }

  // Of a junction.
  void take_ends(std::uint32_t part) {
    const PartShape& shape = assembly_.parts[part].shape;
    if (!part_kind(shape).is_junction()) {
      return;
    }
    for (const Reference& reference : part_kind(shape).ends(shape)) {
      const std::uint32_t other = referred(part, reference);
      check_sides(part, other, reference.key);
      take(part, reference.key, {other, reference.port.end}, assembly_.parts[part].name);
    }
  }

  // Every part after those it refers to, otherwise in document order.
  std::vector<std::uint32_t> in_order_of_need() const {
    std::vector<std::size_t> missing(assembly_.parts.size());
    std::vector<std::vector<std::uint32_t>> dependants(assembly_.parts.size());
    std::deque<std::uint32_t> ready;
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      const auto all = needs(i);
      missing[i] = all.size();
      for (const auto& need : all) {
        dependants[index_.at(need.part)].push_back(i);
      }
      if (all.empty()) {
        ready.push_back(i);
      }
    }
    std::vector<std::uint32_t> order;
    while (!ready.empty()) {
      const auto part = ready.front();
      ready.pop_front();
      order.push_back(part);
      for (const auto dependant : dependants[part]) {
        if (--missing[dependant] == 0) {
          ready.push_back(dependant);
        }
      }
    }
    if (order.size() < assembly_.parts.size()) {
      refuse_circle(missing);
    }
    return order;
  }

  [[noreturn]] void refuse_circle(const std::vector<std::size_t>& missing) const {
    // From any unresolved part, unresolved needs lead into a circle.
    const auto unresolved_need = [&](std::uint32_t part) {
      const auto all = needs(part);
      const auto need = std::ranges::find_if(
          all, [&](const assembly::Need& one) { return missing[index_.at(one.part)] > 0; });
      return std::pair{index_.at(need->part), need->key};
    };
    auto part = std::uint32_t(
        std::find_if(missing.begin(), missing.end(), [](auto count) { return count > 0; }) -
        missing.begin());
    for (std::size_t i = 0; i < missing.size(); ++i) {  // no longer path ends before the circle
      part = unresolved_need(part).first;
    }
    std::vector<std::uint32_t> circle{part};
    while (unresolved_need(circle.back()).first != part) {
      circle.push_back(unresolved_need(circle.back()).first);
    }
    std::rotate(circle.begin(), std::min_element(circle.begin(), circle.end()), circle.end());
    std::string path;
    for (const auto member : circle) {
      path += "'" + assembly_.parts[member].name + "' -> ";
    }
    fail(circle.front(), unresolved_need(circle.front()).second,
         "parts must not begin at each other in a circle: " + path + "'" +
             assembly_.parts[circle.front()].name + "'");
  }

  [[nodiscard]] PartSurface geometry(std::uint32_t part) const {
    return assembly::with_part_context(assembly_, part, [&] {
      const PartShape& shape = outer_shapes_[part];
      return part_kind(shape).geometry(context(part), shape);
    });
  }

  [[nodiscard]] assembly::PartContext context(std::uint32_t part) const {
    return {
        assembly_, part, [this](const PortReference& port) -> const Ring& { return ring_at(port); },
        [this](const PortReference& port) { return motion_at(port); },
        [this](const std::string& name) -> const PartSurface& { return shapes_[index_.at(name)]; }};
  }

  [[nodiscard]] const Ring& ring_at(const PortReference& port) const {
    return *port_ring(shapes_[index_.at(port.part)], port.end);
  }

  [[nodiscard]] MovingRing motion_at(const PortReference& port) const {
    return leaving(shapes_[index_.at(port.part)], port.end);
  }

  ResolvedAssembly collected() {
    std::vector<std::uint32_t> position(assembly_.parts.size());
    ResolvedAssembly result;
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      position[i] = std::uint32_t(result.parts.size());
      const Part& part = assembly_.parts[i];
      const assembly::PartKind& its_kind = part_kind(part.shape);
      if (!its_kind.is_part()) {
        continue;
      }
      ResolvedPart resolved{part.name, std::string(its_kind.key), i, shapes_[i], {},
                            {},        its_kind.is_tangent};
      resolved.is_closed = its_kind.closed_ends;
      for (const auto end : {End::start, End::end}) {
        const EndState& state = ends_[i].at(at(end));
        resolved.joined.at(at(end)) = state.joined;
        resolved.end_names.at(at(end)) = end_name(part.name, end, state.cap);
      }
      if (its_kind.bore != nullptr && resolved.is_closed[1]) {
        resolved.end_names[1] = part.name;  // a head's tip is a point of it
      }
      result.parts.push_back(std::move(resolved));
    }
    for (auto& part : result.parts) {
      for (auto& joined : part.joined) {
        if (joined) {
          joined->part = position[joined->part];
        }
      }
      if (const auto* branch = std::get_if<PipeOn>(&assembly_.parts[part.index].shape)) {
        part.run = position[index_.at(branch->run)];
      }
    }
    append_fillets(position, result);
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      if (part_kind(assembly_.parts[i].shape).is_junction()) {
        append_junction(i, position, result);
      }
    }
    return result;
  }

  // One that is called as its part is no end to open.
  [[nodiscard]] std::string end_name(const std::string& part, End end,
                                     const std::string& cap) const {
    const std::string own = to_string({part, end});
    const auto other = assembly_.patches.find(own);
    return !cap.empty()                                                ? cap
           : other != assembly_.patches.end() && other->second == part ? part
                                                                       : own;
  }

  void append_fillets(const std::vector<std::uint32_t>& position, ResolvedAssembly& result) const {
    std::vector<std::uint32_t> places;
    for (std::uint32_t i = 0; i < assembly_.parts.size(); ++i) {
      if (part_kind(assembly_.parts[i].shape).fillet != nullptr) {
        places.push_back(i);
      }
    }
    std::vector<ResolvedFillet> made(places.size());
    for_each_in_parallel(places.size(),
                         [&](std::size_t i) { made[i] = fillet(places[i], position); });
    FilletedPairs filleted;
    for (ResolvedFillet& fillet : made) {
      result.fillets.push_back(std::move(fillet));
      refuse_twice(result.fillets, filleted);
    }
  }

  void append_junction(std::uint32_t part, const std::vector<std::uint32_t>& position,
                       ResolvedAssembly& result) const {
    const PartShape& shape = outer_shapes_[part];
    const assembly::PartKind& kind = part_kind(shape);
    const std::string& name = assembly_.parts[part].name;
    ResolvedJunction junction{name, part, {}, {}};
    const assembly::JunctionOfEnds made = assembly::with_part_context(
        assembly_, part, [&] { return kind.junction(context(part), shape); });
    junction.shape = made.shape;
    const References ends = kind.ends(shape);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      EndIndex neighbour{position[index_.at(ends[i].port.part)], ends[i].port.end};
      const std::string arm_name = name + "." + std::to_string(i + 1);
      if (made.transitions[i]) {
        const auto transition = std::uint32_t(result.parts.size());
        const std::string its_name = arm_name + ".transition";
        result.parts.push_back({its_name,
                                std::string(kind.key),
                                part,
                                *made.transitions[i],
                                {neighbour, std::nullopt},
                                {its_name + ".start", its_name + ".end"},
                                true});
        result.parts[neighbour.part].joined.at(at(neighbour.end)) =
            EndIndex{transition, End::start};
        neighbour = {transition, End::end};
      }
      const auto arm = std::uint32_t(result.parts.size());
      result.parts.push_back({arm_name,
                              std::string(kind.key),
                              part,
                              tube(junction.shape.arms[i]),
                              {neighbour, std::nullopt},
                              {arm_name + ".start", name},
                              true,
                              true});
      result.parts[neighbour.part].joined.at(at(neighbour.end)) = EndIndex{arm, End::start};
      junction.arms.push_back(arm);
    }
    result.junctions.push_back(std::move(junction));
  }

  [[nodiscard]] ResolvedFillet fillet(std::uint32_t part,
                                      const std::vector<std::uint32_t>& position) const {
    const assembly::PartKind& kind = part_kind(assembly_.parts[part].shape);
    const assembly::FilletPipes pipes = kind.pipes(assembly_.parts[part].shape);
    ResolvedFillet result{assembly_.parts[part].name, part, {}, {}};
    assembly::TubesToFillet given;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto found = index_.find(pipes.names.at(i));
      if (found == index_.end()) {
        fail(part, pipes.key, "there is no part named '" + pipes.names.at(i) + "'");
      }
      if (!part_kind(assembly_.parts[found->second].shape).is_part()) {
        fail(part, pipes.key, "'" + pipes.names.at(i) + "' is no pipe or cone");
      }
      given.surfaces.at(i) = &shapes_[found->second];
      given.parts.at(i) = found->second;
      result.between.at(i) = position[found->second];
    }
    result.shape = assembly::with_part_context(assembly_, part, [&] {
      return kind.fillet(context(part), assembly_.parts[part].shape, given);
    });
    refuse_joined(result, pipes);
    return result;
  }

  void refuse_twice(const std::vector<ResolvedFillet>& fillets, FilletedPairs& filleted) const {
    const ResolvedFillet& last = fillets.back();
    const auto [first, is_new] =
        filleted.try_emplace(std::minmax({last.between[0], last.between[1]}), fillets.size() - 1);
    if (!is_new) {
      const PartShape& shape = assembly_.parts[last.index].shape;
      fail(last.index, part_kind(shape).pipes(shape).key,
           "the crossing of these parts has '" + fillets[first->second].name + "' already");
    }
  }

  // An end that vanishes in the other pipe can neither be named nor joined to a part.
  void refuse_joined(const ResolvedFillet& fillet, const assembly::FilletPipes& pipes) const {
    for (std::size_t i = 0; i < 2; ++i) {
      for (const auto end : {End::start, End::end}) {
        const std::string& by = ends_[index_.at(pipes.names.at(i))].at(at(end)).taken_by;
        if (fillet.shape.buried.at(i).at(at(end)) && !by.empty()) {
          fail(fillet.index, pipes.key,
               "the port '" + to_string({pipes.names.at(i), end}) + "' lies inside '" +
                   pipes.names.at(1 - i) + "' and vanishes, but is taken by '" + by + "'");
        }
      }
    }
  }

  const Assembly& assembly_;
  std::map<std::string, std::uint32_t> index_;
  std::vector<std::array<EndState, 2>> ends_;
  std::vector<PartSurface> shapes_;
  std::vector<PartShape> outer_shapes_;
  std::vector<double> outward_;  // of the outer shapes, from the document's
};

}  // namespace

ResolvedAssembly resolve(const Assembly& assembly) {
  ResolvedAssembly resolved = resolve_unproved(assembly);
  prove_fillets(assembly, resolved);
  return resolved;
}

ResolvedAssembly resolve_unproved(const Assembly& assembly) { return Resolver(assembly).run(); }

namespace {

// work(kind, shape, pipes, fillet) for each; throws for the first of those for which that does.
template <typename Work>
void for_each_fillet(const Assembly& assembly, ResolvedAssembly& resolved, const Work& work) {
  for_each_in_parallel(resolved.fillets.size(), [&](std::size_t i) {
    ResolvedFillet& fillet = resolved.fillets[i];
    const PartShape& shape = assembly.parts[fillet.index].shape;
    const ResolvedPart &first = resolved.parts[fillet.between[0]],
                       &second = resolved.parts[fillet.between[1]];
    const assembly::TubesToFillet pipes{{&first.shape, &second.shape}, {first.index, second.index}};
    assembly::with_part_context(assembly, fillet.index,
                                [&] { work(part_kind(shape), shape, pipes, fillet.shape); });
  });
}

}  // namespace

void find_loops(const Assembly& assembly, ResolvedAssembly& resolved) {
  for_each_fillet(assembly, resolved,
                  [&](const auto& kind, const auto& shape, const auto& pipes, Fillet& fillet) {
                    if (fillet.loops.empty()) {
                      kind.find_loops(assembly, shape, pipes, fillet);
                    }
                  });
}

void prove_fillets(const Assembly& assembly, ResolvedAssembly& resolved) {
  find_loops(assembly, resolved);
  for_each_fillet(assembly, resolved,
                  [&](const auto& kind, const auto& shape, const auto& pipes, Fillet& fillet) {
                    if (kind.prove != nullptr && !fillet.regularity) {
                      kind.prove(assembly, shape, pipes, fillet);
                    }
                  });
}

BuriedEnds::BuriedEnds(const ResolvedAssembly& assembly) : is_buried_(assembly.parts.size()) {
  for (std::size_t i = 0; i < assembly.parts.size(); ++i) {
    is_buried_[i].at(at(End::end)) = assembly.parts[i].ends_in_hub;
  }
  for (const ResolvedFillet& fillet : assembly.fillets) {
    for (std::size_t i = 0; i < 2; ++i) {
      std::array<bool, 2>& of_pipe = is_buried_.at(fillet.between.at(i));
      for (std::size_t end = 0; end < 2; ++end) {
        of_pipe.at(end) = of_pipe.at(end) || fillet.shape.buried.at(i).at(end);
      }
    }
  }
}

std::vector<Port> ports(const ResolvedAssembly& assembly) {
  const BuriedEnds buried(assembly);
  std::vector<Port> result;
  for (const auto& part : assembly.parts) {
    for (const End end : {End::start, End::end}) {
      const Ring* ring = port_ring(part.shape, end);
      const EndIndex index{std::uint32_t(&part - assembly.parts.data()), end};
      const bool is_in_run = ring != nullptr && part.run && !part.joined.at(at(end)) &&
                             canal::is_within_run(assembly.parts[*part.run].shape, *ring);
      if (ring != nullptr && !buried.contains(index) && part.may_open(end) && !is_in_run) {
        result.push_back({to_string({part.name, end}), *ring, part.name});
      }
    }
  }
  return result;
}

}  // namespace dupin
