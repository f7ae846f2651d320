#pragma once

#include <string>

#include "dupin/blends/nurbs.h"

namespace dupin {

/// A part's lateral surface.
struct NamedNurbs {
  std::string part;
  std::string kind;
  NurbsForm form;
};

}  // namespace dupin
