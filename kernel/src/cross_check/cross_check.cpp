#include "dupin/kernel/cross_check.h"

#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "booleans/operands.h"
#include "cross_check/boundary.h"
#include "cross_check/nef.h"
#include "cross_check/pairwise.h"
#include "cross_check/postfix.h"
#include "dupin/kernel/parallel.h"
#include "exact/exact_numbers.h"

namespace dupin {
namespace {

using Kind = Expression::Kind;

/// A question with what it is about.
struct Task {
  std::vector<Expression::Step> steps;
  std::vector<Solid> operands;
  [[nodiscard]] cross_check::Request request() const { return {steps, operands}; }
};

Task task(SetOperation operation, std::span<const Solid> operands) {
  const Kind kind = operation == SetOperation::unite       ? Kind::unite
                    : operation == SetOperation::intersect ? Kind::intersect
                                                           : Kind::subtract;
  Task task{{}, {operands.begin(), operands.end()}};
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    task.steps.push_back({Kind::operand, i});
    if (i > 0) {
      task.steps.push_back({kind, 0});
    }
  }
  return task;
}

Task task(const Expression& expression, const std::map<std::string, Solid>& operands) {
  return {expression.steps(), booleans::operands_of(expression, operands)};
}

// The caller's callback. What it throws is not a failure of the engine's, whose exceptions may be
// of the same types.
class Callback {
 public:
  explicit Callback(const Progress& progress) {
    if (progress) {
      watched_ = [this, &progress](std::string_view stage, double fraction) {
        try {
          return progress(stage, fraction);
        } catch (...) {
          own_ = std::current_exception();
          throw;
        }
      };
    }
  }
  Callback(const Callback&) = delete;
  Callback& operator=(const Callback&) = delete;
  ~Callback() = default;

  [[nodiscard]] const Progress& watched() const { return watched_; }
  void rethrow() const {
    if (own_) {
      std::rethrow_exception(own_);
    }
  }

 private:
  Progress watched_;
  std::exception_ptr own_;
};

Solid by_engine(CrossCheckEngine engine, const Task& task, const Progress& progress) {
  const Callback callback(progress);
  try {
    return Solid(std::make_shared<const mesh::ExactMesh>(
        engine == CrossCheckEngine::nef
            ? cross_check::mesh_by_nef(task.request(), callback.watched())
            : cross_check::mesh_by_corefinement(task.request(), callback.watched())));
  } catch (...) {
    callback.rethrow();
    throw;
  }
}

cross_check::Boundary boundary(CrossCheckEngine engine, const Task& task,
                               const Progress& progress) {
  return engine == CrossCheckEngine::nef
             ? cross_check::boundary_by_nef(task.request(), progress)
             : cross_check::boundary_of(
                   cross_check::mesh_by_corefinement(task.request(), progress));
}

// What the other engine has, or why it has nothing.
std::optional<cross_check::Boundary> attempt(CrossCheckEngine engine, const Task& task,
                                             const Progress& progress, std::string& failure) {
  const Callback callback(progress);
  try {
    return boundary(engine, task, callback.watched());
  } catch (const Error& error) {
    callback.rethrow();
    if (error.code() == Errc::cancelled) {
      throw;
    }
    failure = error.what();
  } catch (const std::bad_alloc&) {
    callback.rethrow();
    failure = "there is not enough memory for " + std::string(name(engine));
  } catch (...) {
    callback.rethrow();
    throw;
  }
  return std::nullopt;
}

CrossCheck checked(const Solid& result, CrossCheckEngine engine, const Task& task,
                   const Progress& progress) {
  CrossCheck check{.engine = engine, .volume = result.exact_volume()};
  const auto other = attempt(engine, task, progress, check.failure);
  if (!other) {
    return check;
  }
  check.other_volume = cross_check::volume(*other);
  const auto corner =
      cross_check::corner_of_difference(cross_check::boundary_of(result.exact()), *other);
  if (corner) {
    Vec3& place = check.place.emplace();
    for (int k = 0; k < 3; ++k) {
      place[k] = exact::nearest_double((*corner)[static_cast<std::size_t>(k)]);
    }
  }
  const bool is_same = !corner && check.volume == check.other_volume;
  check.verdict = is_same ? CrossCheck::Verdict::agrees : CrossCheck::Verdict::disagrees;
  return check;
}

}  // namespace

bool has_cross_check() { return true; }

Solid combine_by(CrossCheckEngine engine, SetOperation operation, std::span<const Solid> operands,
                 const Progress& progress) {
  const UsualArithmetic usual;
  return by_engine(engine, task(operation, operands), progress);
}

Solid evaluate_by(CrossCheckEngine engine, const Expression& expression,
                  const std::map<std::string, Solid>& operands, const Progress& progress) {
  const UsualArithmetic usual;
  return by_engine(engine, task(expression, operands), progress);
}

CrossCheck second_opinion(const Solid& result, CrossCheckEngine engine, SetOperation operation,
                          std::span<const Solid> operands, const Progress& progress) {
  const UsualArithmetic usual;
  return checked(result, engine, task(operation, operands), progress);
}

CrossCheck second_opinion(const Solid& result, CrossCheckEngine engine,
                          const Expression& expression,
                          const std::map<std::string, Solid>& operands, const Progress& progress) {
  const UsualArithmetic usual;
  return checked(result, engine, task(expression, operands), progress);
}

}  // namespace dupin
