#pragma once

#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/nurbs.h"

namespace dupin {

/// A part's lateral surface.
struct NamedNurbs {
  std::string part;
  std::string kind;
  NurbsForm form;
};

/// Those of all parts, then junctions' hubs with the circles that trim them, then fillets, the
/// pipes that these trim being whole. Copes have none of their own. Exact where surfaces are
/// rational, else within `tolerance`. Throws, with the part's name, as `resolve` and `nurbs`.
[[nodiscard]] std::vector<NamedNurbs> named_nurbs(const Assembly& assembly, double tolerance);

}  // namespace dupin
