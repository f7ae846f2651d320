#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dupin/io/report_page.h"

namespace dupin::pages {

/// A part for each of the names, with the labels of the mesh that are its own or begin with it and
/// a dot ("tee.start", "tee.bore"), each label going to the longest such name; then a part for each
/// label that is left. Parts without a label are kept.
[[nodiscard]] std::vector<PagePart> page_parts(const TriMesh& mesh,
                                               const std::vector<PagePart>& named);

}  // namespace dupin::pages
