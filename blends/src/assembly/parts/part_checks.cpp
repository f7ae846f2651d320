#include "assembly/parts/part_checks.h"

#include "dupin/kernel/decimal.h"

namespace dupin::assembly {

void fail(const PartContext& context, std::string_view key, const std::string& message) {
  throw Error(Errc::invalid_argument, message, context.assembly.parts.at(context.index).name,
              document_place(context.assembly, context.index, key));
}

void check_positive(const PartContext& context, double value, std::string_view key) {
  if (!is_within_bounds(value)) {
    fail(context, key, "must be a positive number " + bounds_and(value));
  }
}

void check_finite(const PartContext& context, const Vec3& v, std::string_view key) {
  if (!(v.cwiseAbs().maxCoeff() <= kLargest) || v.hasNaN()) {
    fail(context, key, "coordinates must be finite numbers of at most 1e12");
  }
}

void check_within_tolerance(const PartContext& context, double deviation, std::string_view key,
                            const std::string& what) {
  const double tolerance = context.assembly.tolerance;
  if (!(deviation <= tolerance)) {
    fail(context, key,
         what + ", more than the tolerance of " + decimal(tolerance, kMessageDigits) + " allows");
  }
}

void check_speeds(const PartContext& context, const std::optional<double>& k,
                  const std::optional<double>& l) {
  if (k) {
    check_positive(context, *k, "k");
  }
  if (l) {
    check_positive(context, *l, "l");
  }
}

// On a canal surface of slope q, d' across n is -q rho n' [BL15]. Rounding leaves some ulp of the
// unit speed.
bool is_right(const PartContext& context, const PortReference& port) {
  const Ring& ring = context.ring(port);
  const MovingRing motion = context.motion(port);
  const double advance = motion.center_rate.dot(motion.normal);
  const Vec3 aside =
      motion.center_rate - advance * motion.normal + ring.slope * ring.radius * motion.normal_rate;
  return aside.norm() <= kNoDirection;
}

const Ring& right_end(const PartContext& context, const PortReference& port, std::string_view key) {
  if (!is_right(context, port)) {
    fail(context, key,
         "'" + to_string(port) +
             "' ends an oblique cylinder or cone; only a ringed_blend or a junction goes on from "
             "there");
  }
  return context.ring(port);
}

}  // namespace dupin::assembly
