#pragma once

#include <cstddef>

#include "remeshing/edit_check.h"

namespace dupin::remeshing {

/// Each makes edits of one kind until there are none left that help, or for some rounds, and says
/// how many it has made.

/// Halves edges that are much longer than wanted, the longest ones. Not all at once: what is thin
/// is to be made better before it is cut into what is thin as well.
std::size_t split_long_edges(Workshop& shop);

/// Collapses edges that are much shorter than wanted.
std::size_t collapse_short_edges(Workshop& shop);

/// Flips edges where that makes the smaller of the smallest angles of two triangles larger.
std::size_t flip_edges(Workshop& shop);

/// Where a triangle has an angle smaller than asked for: collapses an edge of its, if what is left
/// is better.
std::size_t collapse_poor(Workshop& shop);

/// Where such a triangle has its longest edge on a curve: puts a point there, below its apex.
std::size_t split_below_poor(Workshop& shop);

}  // namespace dupin::remeshing
