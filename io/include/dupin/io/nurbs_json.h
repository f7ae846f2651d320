#pragma once

#include <string>
#include <vector>

#include "dupin/blends/unit.h"
#include "dupin/io/named_nurbs.h"

namespace dupin {

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
