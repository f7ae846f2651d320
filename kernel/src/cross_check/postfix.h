#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dupin/kernel/boolean_expression.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/set_operation.h"

namespace dupin::cross_check {

/// A set expression in reverse Polish notation. No steps stand for the empty set.
using Postfix = std::span<const Expression::Step>;

/// What an engine is asked for.
struct Request {
  Postfix steps;
  std::span<const Solid> operands;
};

/// Tells of one operation after the other. Throws Error{cancelled}.
class Steps {
 public:
  Steps(Postfix steps, const Progress& progress)
      : total_(std::ranges::count_if(
            steps, [](const auto& step) { return step.kind != Expression::Kind::operand; })),
        progress_(progress) {}

  void next() {
    const double done = static_cast<double>(done_++) / static_cast<double>(total_);
    if (progress_ && !progress_("cross-check", done)) {
      throw Error(Errc::cancelled, "the cross-check was cancelled");
    }
  }

 private:
  std::ptrdiff_t total_, done_ = 0;
  const Progress& progress_;
};

/// Sets that one operation is still to be applied to.
template <class Set>
struct Pending {
  std::optional<SetOperation> operation;  ///< none for a single set
  std::vector<Set> sets;
};

template <class Set, class Combine>
Set settled(Pending<Set> pending, const Combine& combine) {
  return pending.operation ? combine(*pending.operation, std::move(pending.sets))
                           : std::move(pending.sets.front());
}

/// left - (b + c) is left - b - c; a union of unions is one union.
template <class Set, class Combine>
Pending<Set> joined(SetOperation operation, Pending<Set> left, Pending<Set> right,
                    const Combine& combine) {
  const bool is_subtraction = operation == SetOperation::subtract;
  const SetOperation kind_of_right = is_subtraction ? SetOperation::unite : operation;
  Pending<Set> result{operation, {}};
  if (left.operation == operation) {
    result.sets = std::move(left.sets);
  } else {
    result.sets.push_back(settled(std::move(left), combine));
  }
  if (right.operation == kind_of_right) {
    std::ranges::move(right.sets, std::back_inserter(result.sets));
  } else {
    result.sets.push_back(settled(std::move(right), combine));
  }
  return result;
}

/// The value of an expression: `leaf(i)` is the set of operand i, and `combine(operation, sets)`
/// that of at least two sets. It gets as many at once as belong together, so that it may choose the
/// order.
template <class Set, class Leaf, class Combine>
Set evaluated(Postfix steps, const Leaf& leaf, const Combine& combine) {
  std::vector<Pending<Set>> stack;
  for (const Expression::Step& step : steps) {
    if (step.kind == Expression::Kind::operand) {
      stack.emplace_back().sets.push_back(leaf(step.operand));
      continue;
    }
    const auto operation = step.kind == Expression::Kind::unite       ? SetOperation::unite
                           : step.kind == Expression::Kind::intersect ? SetOperation::intersect
                                                                      : SetOperation::subtract;
    Pending<Set> right = std::move(stack.back());
    stack.pop_back();
    stack.back() = joined(operation, std::move(stack.back()), std::move(right), combine);
  }
  return stack.empty() ? Set() : settled(std::move(stack.back()), combine);
}

}  // namespace dupin::cross_check
