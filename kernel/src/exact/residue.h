#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <CGAL/Mpzf.h>

namespace dupin::exact {

/// Numbers modulo the prime 2^61 - 1. Lemma: sums and products of numbers whose denominators it
/// does not divide have the sums and products of their residues, so that equal numbers have equal
/// residues, however they were computed. Numbers that differ seldom have.
using Residue = std::uint64_t;
inline constexpr Residue kResiduePrime = (Residue{1} << 61) - 1;

[[nodiscard]] Residue residue(const CGAL::Mpzf& number);

/// The residues of the coordinates of a point that has homogeneous ones; none if the prime divides
/// its weight.
[[nodiscard]] std::optional<std::array<Residue, 3>> residues(
    const std::array<CGAL::Mpzf, 4>& homogeneous);

}  // namespace dupin::exact
