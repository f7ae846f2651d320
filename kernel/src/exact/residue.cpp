#include "exact/residue.h"

#include <cstddef>

#include <gmpxx.h>

#include "exact/exact_numbers.h"

namespace dupin::exact {
namespace {

__extension__ using Uint128 = unsigned __int128;

constexpr int kBits = 61;

// Of numbers up to a few times the prime's square.
Residue reduced(Uint128 number) {
  const auto folded = static_cast<Residue>((number & kResiduePrime) + (number >> kBits));
  const Residue again = (folded & kResiduePrime) + (folded >> kBits);
  return again >= kResiduePrime ? again - kResiduePrime : again;
}

Residue product(Residue a, Residue b) { return reduced(static_cast<Uint128>(a) * b); }

// By Fermat; of 0 it is 0.
Residue inverse(Residue number) {
  Residue result = 1;
  for (Residue left = kResiduePrime - 2; left != 0; left >>= 1) {
    result = (left & 1) != 0 ? product(result, number) : result;
    number = product(number, number);
  }
  return result;
}

}  // namespace

// Its denominator is a power of two, 2^k; and as 2^61 is 1, 2^-k is 2^(61 - k).
Residue residue(const CGAL::Mpzf& number) {
  static_assert(sizeof(unsigned long) == sizeof(Residue));
  const mpq_class value = rational(number);
  const Residue numerator = mpz_fdiv_ui(value.get_num_mpz_t(), kResiduePrime);
  const std::size_t k = mpz_sizeinbase(value.get_den_mpz_t(), 2) - 1;
  return reduced(static_cast<Uint128>(numerator) << (kBits - k % kBits) % kBits);
}

std::optional<std::array<Residue, 3>> residues(const std::array<CGAL::Mpzf, 4>& homogeneous) {
  const Residue weight = residue(homogeneous[3]);
  if (weight == 0) {
    return std::nullopt;
  }
  const Residue scale = inverse(weight);
  std::array<Residue, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = product(residue(homogeneous[k]), scale);
  }
  return result;
}

}  // namespace dupin::exact
