#pragma once

#include "dupin/blends/elliptic_tube.h"
#include "ringed/blend_shape.h"

namespace dupin::ringed {

/// elliptic_blend, whose circles' speeds are proposed as by surrounding_blend.
[[nodiscard]] EllipticTube elliptic_blend_without(const Ring& from, const Ring& to,
                                                  const CyclicBlendOptions& options,
                                                  const BlendFault& also);

}  // namespace dupin::ringed
