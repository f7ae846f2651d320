#pragma once

#include "dupin/blends/certificate.h"

namespace dupin::verification {

/// A part whose numbers are what its shape needs: finite and no larger than CertificateLimits say,
/// radii, weights and chords positive, normals of unit length, no more coefficients than the
/// limits. There are no others: the checker reads shapes from here.
class AdmittedPart {
 public:
  /// Throws Error{invalid_argument} with the part's name for a part that is none.
  explicit AdmittedPart(const CertifiedPart& part);
  [[nodiscard]] const CertifiedPart& operator*() const { return *part_; }
  [[nodiscard]] const CertifiedPart* operator->() const { return part_; }

 private:
  const CertifiedPart* part_;
};

/// A parameter of a part: a multiple of 2^-64 in [0, length], so that exact numbers stay short.
[[nodiscard]] bool is_parameter(double t, double length);

/// Two of them, in order.
[[nodiscard]] bool is_stretch(const ParameterInterval& t, double length);

/// Three numbers no larger than CertificateLimits say.
[[nodiscard]] bool is_point(const Vec3& point);

/// A finite number that is not negative and no larger than CertificateLimits say.
[[nodiscard]] bool is_bound(double number);

/// Text that takes one line and has no control characters: what is printed says who is meant only.
[[nodiscard]] bool is_name(const std::string& text);

}  // namespace dupin::verification
