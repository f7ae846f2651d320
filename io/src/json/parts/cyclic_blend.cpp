#include "json/parts/avoidance.h"
#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"cyclic_blend"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to", "radius_law", "k", "l", "continuity", "avoid", "clearance"});
    CyclicBlendBetween blend{port(node.at("from")), port(node.at("to")), {}};
    if (node.has("radius_law")) {
      const JsonNode law = node.at("radius_law");
      if (law.text() != "R1" && law.text() != "R2") {
        law.fail("must be \"R1\" or \"R2\", not \"" + law.text() + "\"");
      }
      blend.options.radius_law = law.text() == "R1" ? BlendLaw::r1 : BlendLaw::r2;
    }
    if (node.has("continuity")) {
      blend.options.continuity = continuity(node.at("continuity"));
    }
    blend.options.k = number_or_auto(node.at("k"));
    blend.options.l = number_or_auto(node.at("l"));
    blend.avoid = avoidance(node);
    return blend;
  }
};
template PartShape read_part<"cyclic_blend">(const JsonNode& node);

}  // namespace dupin::json
