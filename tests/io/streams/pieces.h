#pragma once

#include <string>
#include <vector>

#include "dupin/io/streamed_format.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin::test {

/// Solids in boxes of their own, rounded, and with labels where a name is not empty.
struct Pieces {
  explicit Pieces(const std::vector<std::string>& names, Coordinates coordinates) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Vec3 place(10.0 * static_cast<double>(i), .1, .2);
      const TriMesh mesh = i % 2 == 0 ? tetrahedron(place, 1) : box(place, place + Vec3::Ones());
      rounded.push_back(
          to_mesh(Solid::from(names[i].empty() ? mesh : labelled(mesh, names[i])), coordinates));
      boxes.push_back({{place - Vec3::Ones(), place + Vec3::Constant(2)}});
    }
  }
  [[nodiscard]] TriMesh all() const { return joined(rounded, boxes).mesh(); }

  std::vector<Rounded> rounded;
  std::vector<Boxes> boxes;
};

/// Names of labels, for all kinds of company.
inline const std::vector<std::vector<std::string>> kCompanies = {
    {"a", "b", "c"}, {"a"}, {"a", "a"}, {}, {"", ""}, {"a", "", "b.start", "a"}, {""}};

}  // namespace dupin::test
