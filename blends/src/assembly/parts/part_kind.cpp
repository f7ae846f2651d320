#include "assembly/parts/part_kind.h"

namespace dupin::assembly {

const PartKind& part_kind(const PartShape& shape) {
  return std::visit(
      []<class Shape>(const Shape&) -> const PartKind& {
        return part_kind<PartKeys::kNameOf<Shape>>();
      },
      shape);
}

References from_port(const PartStart& from) {
  const auto* port = std::get_if<PortReference>(&from);
  return port == nullptr ? References() : References{{*port, "from"}};
}

References between_ports(const PortReference& from, const PortReference& to) {
  return {{from, "from", PartEnd::start}, {to, "to", PartEnd::end}};
}

}  // namespace dupin::assembly
