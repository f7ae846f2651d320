#include "assembly/printable_names.h"

#include <cstdint>
#include <string>
#include <utility>

#include "dupin/kernel/error.h"
#include "dupin/kernel/printable.h"

namespace dupin::assembly {
namespace {

void require_part_name(const Assembly& assembly, std::uint32_t part) {
  const std::string& name = assembly.parts[part].name;
  const auto fault = [&](const std::string& message) {
    return Error(Errc::invalid_argument, message, name, document_place(assembly, part) + "/name");
  };
  if (name.empty() || name.find('.') != std::string::npos) {
    throw fault("a part's name must not be empty and not contain a dot");
  }
  if (name.front() == ' ' || name.back() == ' ' || has_controls(name)) {
    throw fault("a part's name must be one line, without control characters or blanks around it");
  }
}

// Bills of materials print it, as they do the part's name.
void require_component(const Assembly& assembly, std::uint32_t part) {
  const Component& component = assembly.parts[part].component;
  const std::pair<std::string, const std::string&> texts[] = {{"name", component.name},
                                                              {"kind", component.kind}};
  for (const auto& [key, text] : texts) {
    if (has_controls(text)) {
      throw Error(Errc::invalid_argument,
                  "a component's " + key + " must have no control characters",
                  assembly.parts[part].name, document_place(assembly, part) + "/component/" + key);
    }
  }
}

}  // namespace

void require_printable_names(const Assembly& assembly) {
  for (const auto& [name, other] : assembly.patches) {
    if (has_controls(other)) {
      throw Error(Errc::invalid_argument, "a patch's name must have no control characters", {},
                  document_place(assembly, "/patches/" + name));
    }
  }
  for (std::uint32_t part = 0; part < assembly.parts.size(); ++part) {
    require_part_name(assembly, part);
    require_component(assembly, part);
  }
}

}  // namespace dupin::assembly
