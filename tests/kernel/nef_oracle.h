#pragma once

#include <functional>
#include <optional>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/error.h"

/// Set operations by CGAL's Nef polyhedra: slow, general, and sharing no code with ours.
namespace dupin::test {

/// Nothing if the result's boundary is not 2-manifold.
inline std::optional<Solid> unless_it_touches_itself(const std::function<Solid()>& operation) {
  try {
    return operation();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    EXPECT_THAT(error.what(), testing::EndsWith("has a result whose boundary is no 2-manifold"));
    return std::nullopt;
  }
}

inline std::optional<Solid> by_nef(SetOperation operation, std::span<const Solid> operands) {
  return unless_it_touches_itself(
      [&] { return combine_by(CrossCheckEngine::nef, operation, operands); });
}

inline std::optional<Solid> by_nef(const Expression& expression,
                                   const std::map<std::string, Solid>& operands) {
  return unless_it_touches_itself(
      [&] { return evaluate_by(CrossCheckEngine::nef, expression, operands); });
}

}  // namespace dupin::test
