#pragma once

#include "dupin/blends/certificate.h"

namespace dupin::verification {

/// What numbers of shapes have to be. Each throws Error{invalid_argument} with the part's name.
class Requirements {
 public:
  explicit Requirements(const std::string& part) : part_(part) {}

  void require(bool holds, const std::string& what) const;
  void number(double x) const;
  void positive(double x, const std::string& what) const;
  void point(const Vec3& p) const;
  void direction(const Vec3& v) const;  ///< of unit length
  void ring(const Ring& r) const;
  void spine(const Spine& s) const;
  void radius(const RadiusLaw& r) const;
  /// Of polynomials: at least one, no more than CertificateLimits say.
  void coefficients(std::size_t count) const;

 private:
  const std::string& part_;
};

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

/// Throws Error{invalid_argument} for a fillet whose loops have numbers that are not finite or
/// larger than CertificateLimits say. What is read from them is checked by its claims.
void admit(const CertifiedFillet& fillet);

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
