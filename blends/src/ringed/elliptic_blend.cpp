#include "ringed/elliptic_blend.h"

namespace dupin {
namespace ringed {

EllipticTube elliptic_blend_without(const Ring& from, const Ring& to,
                                    const CyclicBlendOptions& options, const BlendFault& also) {
  const RingedSurface about = surrounding_blend(from, to, options, also);
  const auto law = [&](double r0, double slope0, double r1, double slope1) {
    return blend_radius({r0, slope0, r1, slope1}, about.spine, options);
  };
  return elliptic_tube(
      flipped(from), flipped(to), about.spine, law(from.radius, from.slope, to.radius, to.slope),
      law(across(from), across_slope(from), across(to), across_slope(to)), options.continuity);
}

}  // namespace ringed

EllipticTube elliptic_blend(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  return ringed::elliptic_blend_without(from, to, options, {});
}

}  // namespace dupin
