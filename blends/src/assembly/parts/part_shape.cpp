#include "dupin/blends/part_shape.h"

namespace dupin {

std::string_view kind(const PartShape& shape) {
  return std::visit([]<class Shape>(const Shape&) { return PartKeys::kNameOf<Shape>.view(); },
                    shape);
}

}  // namespace dupin
