#include "healing/count_equations.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "support/sequences.h"

namespace dupin::healing {
namespace {

using Term = CountEquation::Term;

int preferred(const UnknownCount& unknown) {
  return unknown.most == 0 || (unknown.may_vanish && unknown.least == 0) ? 0
         : unknown.majority >= 0                                         ? 1
                                                                         : -1;
}

/// Unknowns that are alike, by what they add up to.
struct Sum {
  std::vector<Term> members;  ///< and their signs, of the first one positive
  std::size_t size = 0;
  int least = 0, most = 0;  ///< of the sum's size
  int step = 1;             ///< between two sums
  int preferred = 0;

  void add(std::uint32_t number, const UnknownCount& unknown, int sign) {
    members.push_back({number, sign});
    size += unknown.size;
    preferred += sign * healing::preferred(unknown);
    most += unknown.most;
    least = members.size() == 1 ? unknown.least : most % 2;
    step = members.size() == 1 ? 1 : 2;
  }
  [[nodiscard]] bool may_be(std::int64_t sum) const {
    const std::int64_t length = std::abs(sum);
    return length >= least && length <= most && (most - length) % step == 0;
  }
};

struct System {
  System(std::span<const UnknownCount> unknowns, std::span<const CountEquation> given) {
    std::vector<std::vector<std::pair<std::uint32_t, int>>> factors(unknowns.size());
    for (std::uint32_t e = 0; e < given.size(); ++e) {
      for (const auto& [unknown, factor] : given[e].terms) {
        factors[unknown].emplace_back(e, factor);
      }
    }
    std::map<std::vector<std::pair<std::uint32_t, int>>, std::uint32_t> sum_of;
    for (std::uint32_t i = 0; i < unknowns.size(); ++i) {
      auto& key = factors[i];
      const int sign = key.empty() || key.front().second > 0 ? 1 : -1;
      for (auto& [equation, factor] : key) {
        factor *= sign;
      }
      const auto fresh = static_cast<std::uint32_t>(sums.size());
      const bool may_share = !key.empty() && unknowns[i].least == 1 && unknowns[i].most == 1;
      const std::uint32_t at = may_share ? sum_of.try_emplace(key, fresh).first->second : fresh;
      if (at == fresh) {
        sums.emplace_back();
        equations_of.push_back(key);
      }
      sums[at].add(i, unknowns[i], sign);
    }
    terms_of.resize(given.size());
    for (std::uint32_t i = 0; i < sums.size(); ++i) {
      for (const auto& [equation, factor] : equations_of[i]) {
        terms_of[equation].push_back({i, factor});
      }
    }
  }

  std::vector<Sum> sums;
  std::vector<std::vector<std::pair<std::uint32_t, int>>> equations_of;  // and the factor there
  std::vector<std::vector<Term>> terms_of;                               // each equation
};

class Solver {
 public:
  explicit Solver(const System& system)
      : system_(system), values_(system.sums.size()), states_(system.terms_of.size()) {
    for (std::size_t e = 0; e < states_.size(); ++e) {
      for (const auto& [sum, factor] : system.terms_of[e]) {
        ++states_[e].open;
        states_[e].room += std::abs(std::int64_t{factor} * system.sums[sum].most);
      }
    }
  }

  std::vector<int> solve(bool trusting) {
    const std::vector<std::uint32_t> order = by_certainty();
    for (const std::uint32_t i : order) {
      const Sum& sum = system_.sums[i];
      if (trusting && (is_settled(sum) || sum.step == 2)) {
        decide(i, sum.preferred);
      }
    }
    for (std::uint32_t e = 0; e < states_.size(); ++e) {
      queue_.push_back(e);
    }
    propagate();
    for (const std::uint32_t i : order) {
      if (!values_[i]) {
        decide(i, possible(i));
        propagate();
      }
    }
    std::vector<int> values;
    values.reserve(values_.size());
    for (const std::optional<int>& value : values_) {
      values.push_back(*value);
    }
    return values;
  }

 private:
  /// Of an equation.
  struct State {
    std::size_t open = 0;   // terms that are not decided
    std::int64_t sum = 0;   // of the others
    std::int64_t room = 0;  // the most that those that are open can add up to
  };

  static bool is_settled(const Sum& sum) { return sum.least == sum.most; }

  // Those of one possible size before others, the large before the small.
  [[nodiscard]] std::vector<std::uint32_t> by_certainty() const {
    std::vector<std::uint32_t> order = support::numbers_below(system_.sums.size());
    std::ranges::stable_sort(order, [this](std::uint32_t a, std::uint32_t b) {
      const Sum &p = system_.sums[a], &q = system_.sums[b];
      return is_settled(p) != is_settled(q) ? is_settled(p) : p.size > q.size;
    });
    return order;
  }

  void decide(std::uint32_t i, int value) {
    values_[i] = value;
    for (const auto& [e, factor] : system_.equations_of[i]) {
      State& state = states_[e];
      --state.open;
      state.sum += std::int64_t{factor} * value;
      state.room -= std::abs(std::int64_t{factor} * system_.sums[i].most);
      if (state.open == 1 || (state.open > 0 && std::abs(state.sum) == state.room)) {
        queue_.push_back(e);
      }
    }
  }

  // Decides what an equation leaves no choice of: its last term, or all that it needs in full.
  void propagate() {
    while (!queue_.empty()) {
      const std::uint32_t e = queue_.back();
      queue_.pop_back();
      const State state = states_[e];
      const bool needs_all = std::abs(state.sum) == state.room;
      if (state.open != 1 && !needs_all) {
        continue;
      }
      for (const auto& [i, factor] : system_.terms_of[e]) {
        if (values_[i]) {
          continue;
        }
        const Sum& sum = system_.sums[i];
        const bool is_opposite = (factor > 0) == (state.sum > 0);
        const std::int64_t value =
            needs_all ? (is_opposite ? -sum.most : sum.most) : -state.sum / factor;
        if ((needs_all || state.sum % factor == 0) && sum.may_be(value)) {
          decide(i, static_cast<int>(value));
        }
      }
    }
  }

  // Next to what is preferred, such that what is open can still close each equation; if there is
  // no such value, what is preferred.
  [[nodiscard]] int possible(std::uint32_t i) const {
    const Sum& sum = system_.sums[i];
    const auto is_possible = [&](int value) {
      return sum.may_be(value) &&
             std::ranges::all_of(system_.equations_of[i], [&](const auto& term) {
               const State& state = states_[term.first];
               const std::int64_t factor = term.second;
               return std::abs(state.sum + factor * value) <=
                      state.room - std::abs(factor * sum.most);
             });
    };
    constexpr int kFarthest = 8;
    for (int distance = 0; distance <= std::min(2 * sum.most, kFarthest); ++distance) {
      for (const int value : {sum.preferred - distance, sum.preferred + distance}) {
        if (is_possible(value)) {
          return value;
        }
      }
    }
    return sum.preferred;
  }

  const System& system_;
  std::vector<std::optional<int>> values_;  // of sums
  std::vector<State> states_;               // of equations
  std::vector<std::uint32_t> queue_;        // of equations
};

}  // namespace

std::vector<int> solved_counts(std::span<const UnknownCount> unknowns,
                               std::span<const CountEquation> equations, bool trusting) {
  const System system(unknowns, equations);
  const std::vector<int> values = Solver(system).solve(trusting);
  std::vector<int> counts(unknowns.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<Term> members = system.sums[i].members;
    if (members.size() == 1) {
      counts[members.front().unknown] = members.front().factor * values[i];
      continue;
    }
    std::ranges::stable_sort(members, std::greater(), [&](const Term& member) {
      return member.factor * unknowns[member.unknown].majority;
    });
    const auto ups = (std::ssize(members) + values[i]) / 2;
    for (std::ptrdiff_t k = 0; k < std::ssize(members); ++k) {
      counts[members[k].unknown] = k < ups ? members[k].factor : -members[k].factor;
    }
  }
  return counts;
}

}  // namespace dupin::healing
