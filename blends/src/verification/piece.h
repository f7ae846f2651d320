#pragma once

#include <optional>
#include <vector>

#include "numbers/mpfi_interval.h"
#include "verification/motions/motion.h"

// What the checker knows of each kind of piece is in piece.cpp: what its numbers must be, what
// moves along it, and how far that is from its stored rings.

namespace dupin::verification {

class Requirements;

/// A piece of a chain, read exactly.
struct Piece {
  Piece(const dupin::Piece& certified, double wall);

  dupin::Piece shape;
  Ring start, end;
  /// A ringed surface's, or those of an elliptic tube's two semi-axes; none for other pieces.
  std::vector<Tube> tubes;
  Motion motion;  ///< of elliptic tubes that of the discs about its sections
  /// Of the discs that contain the piece's; first derivatives may have lost a positive factor.
  Motion steered;
  Motion inner;  ///< of the inner skin; none for solid pieces
  /// The bands of all neighbours of its kind share a frame, and so its twist.
  bool shares_frame = false;
};

/// Discs that hold those of a stretch, by the piece's own parameter; none where the numbers do not
/// tell.
[[nodiscard]] std::optional<Discs> discs_of(const Piece& piece, const ParameterInterval& t);

/// Throws as Requirements do.
void admit(const dupin::Piece& certified, const Requirements& requirements);

using Wide = numbers::MpfiInterval<1024>;

/// Bounds of how the disc at an end differs from the ring stored there, and the walls from the
/// ring's cone.
struct EndDifference {
  Wide axis_angle, offset;
  std::optional<double> deviation;  ///< none where nothing is known
};

[[nodiscard]] EndDifference end_difference(const Piece& piece, End end);

/// How far the wall of a cylinder or cone is from a quadric all along it, both ways, and the angle
/// in radians between both where they are nearest: upper bounds, infinite where the numbers do not
/// tell.
struct ConeDifference {
  double offset = 0, deviation = 0;
};

/// Of a tube that is a cone, and the cone or cylinder that a ring belongs to, whose normal looks
/// along the tube.
[[nodiscard]] ConeDifference difference_from(const Ring& quadric, const Tube& cone);

}  // namespace dupin::verification
