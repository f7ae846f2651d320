#include "assembly/districts/divided_districts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "assembly/cost_limit.h"
#include "assembly/districts/common_rings.h"
#include "assembly/districts/dividing_rings.h"
#include "assembly/districts/stretched_district.h"
#include "assembly/groups.h"
#include "assembly/welded_runs.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/parallel.h"

namespace dupin::assembly {
namespace {

double largest_of(std::span<const double> numbers) {
  return numbers.empty() ? 0 : *std::ranges::max_element(numbers);
}

class Divider {
 public:
  Divider(const Assembly& assembly, const ResolvedAssembly& resolved, const Division& division)
      : assembly_(assembly),
        whole_(resolved),
        division_(division),
        distances_(distances_between(assembly, resolved, division.region)),
        rule_{division.kept, distances_, division.region},
        fillets_(resolved.fillets.size()) {}

  void add(DistrictParts members) {
    if (members.parts.size() < kLeastParts) {
      districts_.push_back(std::move(members));
      return;
    }
    const District whole = district_with_loops(assembly_, resolved(), members);
    for (std::size_t i = 0; i < members.fillets.size(); ++i) {
      fillets_[members.fillets[i]] = whole.resolved.fillets[i].shape;
    }
    const double enough = std::max(division_.most, division_.undivided);
    if (!(expected_triangles(whole, division_.region, enough) > enough)) {
      districts_.push_back(std::move(members));
      return;
    }
    const Divisible own{resolved(), members, common_rings(whole, division_.region)};
    const Atoms atoms = atoms_of(own, rule_);
    const std::vector<double> triangles = expected(own, atoms);
    if (!(largest_of(triangles) > division_.most && append_cut(own, atoms, triangles))) {
      Groups groups = groups_of(atoms, triangles);
      std::vector<std::uint32_t> group_of;
      std::ranges::transform(atoms.of, std::back_inserter(group_of),
                             [&](std::uint32_t atom) { return groups.of(atom); });
      append(own, atoms.boxes, atoms.rings, group_of);
    }
  }

  DividedDistricts take() {
    std::vector<std::uint32_t> order(districts_.size()), place(districts_.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto first = [&](std::uint32_t i) {
      return districts_[i].parts.empty() ? std::uint32_t(resolved().parts.size())
                                         : districts_[i].parts.front();
    };
    std::ranges::stable_sort(order, {}, first);
    DividedDistricts result;
    for (const std::uint32_t i : order) {
      place[i] = std::uint32_t(result.districts.size());
      result.districts.push_back(std::move(districts_[i]));
    }
    for (Seam& seam : seams_) {
      for (std::uint32_t& piece : seam.pieces) {
        piece = place[piece];
      }
      std::ranges::sort(seam.pieces);
      result.seams.push_back(std::move(seam));
    }
    result.cut = std::move(cut_);
    return result;
  }

 private:
  /// The document's parts, some of them in stretches.
  [[nodiscard]] const ResolvedAssembly& resolved() const { return cut_ ? *cut_ : whole_; }

  /// Of each atom.
  [[nodiscard]] std::vector<double> expected(const Divisible& whole, const Atoms& atoms) const {
    const std::vector<DistrictParts> parts = pieces_of(whole, atoms.boxes, atoms.rings, atoms.of);
    std::vector<double> result(parts.size());
    for_each_in_parallel(parts.size(), [&](std::size_t i) {
      District own = district(assembly_, whole.resolved, parts[i]);
      for (std::size_t k = 0; k < parts[i].fillets.size(); ++k) {
        own.resolved.fillets[k].shape = fillets_[parts[i].fillets[k]];
      }
      result[i] = expected_triangles(own, division_.region);
    });
    return result;
  }

  /// Of atoms, as long as no more triangles than wanted are expected of a group.
  [[nodiscard]] Groups groups_of(const Atoms& atoms, std::vector<double> triangles) const {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (const SharedRing& ring : atoms.rings) {
      pairs.push_back({atoms.of[ring.parts[0]], atoms.of[ring.parts[1]]});
    }
    const std::vector<std::uint32_t> first = grouped(std::move(triangles), pairs, division_.most);
    Groups groups(atoms.count);
    for (std::uint32_t atom = 0; atom < atoms.count; ++atom) {
      groups.unite(first[atom], atom);
    }
    return groups;
  }

  /// Whether pieces did not fit where it was cut.
  [[nodiscard]] bool is_kept(const ResolvedPart& part) const {
    const std::string prefix = cut_prefix(part);
    const auto found = division_.kept.lower_bound(prefix);
    return found != division_.kept.end() && found->starts_with(prefix);
  }

  /// Pipes of atoms that are too large are cut where nothing else is near; planes come closer until
  /// no atom is. Whether that divided anything.
  bool append_cut(const Divisible& whole, const Atoms& atoms,
                  const std::vector<double>& triangles) {
    const std::vector<std::uint32_t>& parts = whole.members.parts;
    std::vector<std::optional<Cuttable>> items(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const ResolvedPart& part = whole.resolved.parts[parts[i]];
      if (triangles[atoms.of[i]] > division_.most && !is_kept(part)) {
        items[i] = cuttable(part);
      }
    }
    const auto largest = [&](const FreePlaces::Cuts& cuts) {
      const StretchedDistrict tried = stretched(whole, pipe_cuts(whole.resolved, parts, cuts));
      return largest_of(expected(tried.divisible(), atoms_of(tried.divisible(), rule_)));
    };
    const PipeCuts best = pipe_cuts(
        whole.resolved, parts,
        FreePlaces(atoms.boxes, items).best_cuts(largest_of(triangles), division_.most, largest));
    if (!best.empty()) {
      append_stretched(whole, best);
    }
    return !best.empty();
  }

  /// Stretches that stay together are one again. Boxes about these are larger: if those of two
  /// pieces touch, but for seams, these are one, too.
  void append_stretched(const Divisible& whole, const PipeCuts& cuts) {
    const StretchedDistrict fine = stretched(whole, cuts);
    const Atoms atoms = atoms_of(fine.divisible(), rule_);
    Groups groups = groups_of(atoms, expected(fine.divisible(), atoms));
    for (bool is_apart = false; !is_apart;) {
      const auto group_of_fine = [&](std::uint32_t box) { return groups.of(atoms.of[box]); };
      const FewerCuts fewer = cuts_between(fine, cuts, group_of_fine);
      StretchedDistrict made = stretched(whole, fewer.cuts);
      const Atoms own = atoms_of(made.divisible(), rule_);
      std::vector<std::uint32_t> group_of;
      std::ranges::transform(fewer.boxes, std::back_inserter(group_of), group_of_fine);
      is_apart = !united(own, group_of, groups);
      if (is_apart) {
        append(made.divisible(), own.boxes, own.rings, group_of);
        cut_ = std::move(made.stretches.resolved);
      }
    }
  }

  /// Groups of what is in one atom become one. Whether there were any.
  static bool united(const Atoms& atoms, std::span<const std::uint32_t> group_of, Groups& groups) {
    std::map<std::uint32_t, std::uint32_t> group_of_atom;
    bool is_any = false;
    for (std::size_t i = 0; i < group_of.size(); ++i) {
      const std::uint32_t first = group_of_atom.try_emplace(atoms.of[i], group_of[i]).first->second;
      if (groups.of(first) != groups.of(group_of[i])) {
        groups.unite(first, group_of[i]);
        is_any = true;
      }
    }
    return is_any;
  }

  /// Groups of boxes become districts.
  void append(const Divisible& whole, const Boxes& boxes, std::span<const SharedRing> rings,
              std::span<const std::uint32_t> group_of) {
    std::map<std::uint32_t, std::uint32_t> number;
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t group : group_of) {
      const auto next = std::uint32_t(number.size());
      numbers.push_back(number.try_emplace(group, next).first->second);
    }
    if (number.size() == 1) {
      districts_.push_back(whole.members);
      return;
    }
    const auto first = std::uint32_t(districts_.size());
    for (const SharedRing& ring : rings) {
      const std::uint32_t one = numbers[ring.parts[0]], other = numbers[ring.parts[1]];
      if (one != other) {
        seams_.push_back({{first + one, first + other},
                          ring.name,
                          boxes[ring.parts[0]].intersection(boxes[ring.parts[1]])});
      }
    }
    std::ranges::move(pieces_of(whole, boxes, rings, numbers), std::back_inserter(districts_));
  }

  const Assembly& assembly_;
  const ResolvedAssembly& whole_;
  const Division& division_;
  std::optional<std::vector<double>> distances_;
  DividingRule rule_;
  std::vector<Fillet> fillets_;  // with their loops, of districts that are divided
  std::optional<ResolvedAssembly> cut_;
  std::vector<DistrictParts> districts_;
  std::vector<Seam> seams_;
};

/// What is expected of a district, each when it is asked for.
class Expectation {
 public:
  explicit Expectation(const District& own)
      : own_(own),
        runs_(welded_runs(own.resolved)),
        grid_(own.piece ? own.piece->grid : lattice_spacing(own.assembly, own.resolved)) {}

  [[nodiscard]] double surface(double enough = std::numeric_limits<double>::infinity()) const {
    return expected_triangles(own_.assembly, own_.resolved, runs_, grid_, given(), enough);
  }
  [[nodiscard]] double crossings() const {
    return expected_crossings(own_.assembly, own_.resolved, own_.boxes, runs_, grid_, given());
  }

 private:
  [[nodiscard]] std::span<const RingSampling> given() const {
    return own_.piece ? std::span<const RingSampling>(own_.piece->samplings)
                      : std::span<const RingSampling>();
  }

  const District& own_;
  std::vector<WeldedRun> runs_;
  double grid_;
};

}  // namespace

ExpectedTriangles expected_of(const District& own) {
  const Expectation expectation(own);
  return {expectation.surface(), expectation.crossings()};
}

double expected_triangles(const District& own, std::optional<Region> region, double enough) {
  const Expectation expectation(own);
  const auto distances = distances_between(own.assembly, own.resolved, region);
  const bool has_second =
      region == Region::insulation ||
      (distances && std::ranges::any_of(*distances, [](double distance) { return distance > 0; }));
  // These surfaces have about as many triangles as the first ones, and cross those of others, too.
  const double share = has_second ? 2 : 1;
  const double surface = share * expectation.surface(enough / share);
  return surface > enough ? surface : surface + (has_second ? 4 : 1) * expectation.crossings();
}

DividedDistricts divided(const Assembly& assembly, const ResolvedAssembly& resolved,
                         std::vector<DistrictParts> districts, const Division& division) {
  Divider divider(assembly, resolved, division);
  for (DistrictParts& members : districts) {
    divider.add(std::move(members));
  }
  return divider.take();
}

}  // namespace dupin::assembly
