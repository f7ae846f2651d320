#pragma once

#include <span>

namespace dupin::pcf {

/// A size of ASME B36.10M: what is called so, and how thick it is, in millimetres.
struct NominalPipe {
  double inches;   ///< NPS
  double nominal;  ///< DN
  double outside;  ///< diameter
};

/// All sizes from 1/8 to 48 inches, in order.
[[nodiscard]] std::span<const NominalPipe> nominal_pipes();

/// Lengths of a file, and how many millimetres they are.
enum class BoreUnit { millimetre, inch };

/// The size that a file calls by this number: DN, or inches in millimetres (203.2) or inches; null
/// if there is none.
[[nodiscard]] const NominalPipe* called(double bore, BoreUnit unit);

/// The size with this outside diameter in millimetres, as tables round it; null if there is none.
[[nodiscard]] const NominalPipe* of_outside(double diameter);

}  // namespace dupin::pcf
