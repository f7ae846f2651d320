#pragma once

#include <string>
#include <vector>

#include "dupin/blends/nurbs.h"
#include "dupin/blends/unit.h"

namespace dupin {

/// A part's lateral surface.
struct NamedNurbs {
  std::string part;
  std::string kind;
  NurbsForm form;
};

/// `{"unit", "parts": [{"part", "kind", "error_bound", "surfaces": [{"degree": [along, around],
/// "knots": [[...], [...]], "net": rows of [x w, y w, z w, w]}]}]}`, numbers as the shortest
/// decimals that read back to the same doubles. A part that ends on its surfaces has "trims":
/// [{"degree", "knots", "net"}].
[[nodiscard]] std::string nurbs_json(const std::vector<NamedNurbs>& parts, Unit unit);

/// What was written to `file`: `{"file", "parts": [{"part", "kind", "error_bound", "surfaces"}]}`,
/// surfaces being their number.
[[nodiscard]] std::string nurbs_report_json(const std::vector<NamedNurbs>& parts,
                                            const std::string& file);

}  // namespace dupin
