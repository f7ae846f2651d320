#pragma once

#include <span>

#include "arrangement/arrange.h"
#include "dupin/kernel/boolean.h"

// This folder: the public operations on solids. Union, intersection, difference and expressions of
// any number of operands are one arrangement (arrangement/arrange.h) with one rule: a place is
// inside if the rule says so of the winding numbers that the operands have there. What is added
// here is policy: operands checked, contacts refused or kept, progress told, the result made a
// Solid. An expression is never evaluated step by step; its tree is the rule.
// Only the union of solids that crowd each other is made in steps (union_in_steps.h).

namespace dupin::booleans {

/// arrange() for solids, with the policies of the options. Throws Error{contact} besides, where
/// these refuse contacts.
[[nodiscard]] mesh::ExactMesh combine(std::span<const Solid> operands,
                                      const arrangement::BooleanRule& rule,
                                      const BooleanOptions& options);

/// The same for their union, which may be made in steps.
[[nodiscard]] mesh::ExactMesh combine_in_union(std::span<const Solid> operands,
                                               const BooleanOptions& options);

}  // namespace dupin::booleans
