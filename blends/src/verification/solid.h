#pragma once

#include <optional>
#include <vector>

#include "verification/piece.h"

namespace dupin::verification {

/// A part, read exactly: discs for parameters from 0 to the number of its pieces, or a ball. A
/// chain with spherical joints, that nothing is claimed about, has no pieces here.
class Solid {
 public:
  /// Throws as AdmittedPart.
  explicit Solid(const CertifiedPart& certified);

  [[nodiscard]] const Sphere* ball() const { return ball_ ? &*ball_ : nullptr; }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] double length() const { return ball_ ? 1 : double(pieces_.size()); }
  /// The part is the union of its discs: it is neither hollow nor elliptic.
  [[nodiscard]] bool is_full() const { return is_full_; }
  /// The piece that has the stretch; none if no single one does.
  [[nodiscard]] const Piece* piece(const ParameterInterval& t) const;
  /// Of a stretch within one piece; none where the numbers do not tell.
  [[nodiscard]] std::optional<Discs> discs(const ParameterInterval& t) const;

 private:
  std::vector<Piece> pieces_;
  std::optional<Sphere> ball_;
  bool closed_ = false, is_full_ = true;
};

/// The stretch by the parameter of its piece.
[[nodiscard]] ParameterInterval within_piece(const ParameterInterval& t);

/// The stretch cut at whole numbers.
[[nodiscard]] std::vector<ParameterInterval> cut(const ParameterInterval& t);

}  // namespace dupin::verification
