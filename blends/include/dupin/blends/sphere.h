#pragma once

#include "dupin/kernel/vec.h"

namespace dupin {

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 1;
};

}  // namespace dupin
