#include "mesh/united_names.h"

#include <string_view>
#include <unordered_map>
#include <utility>

namespace dupin::mesh {

void unite_names(std::vector<std::string>& names, std::span<std::uint32_t> labels) {
  std::unordered_map<std::string_view, std::uint32_t> label_of;
  std::vector<std::uint32_t> united;
  for (const std::string& name : names) {
    const auto next = static_cast<std::uint32_t>(label_of.size());
    united.push_back(label_of.try_emplace(name, next).first->second);
  }
  if (label_of.size() == names.size()) {
    return;
  }
  for (std::uint32_t& label : labels) {
    label = united[label];
  }
  std::vector<std::string> once(label_of.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    once[united[i]] = names[i];
  }
  names = std::move(once);
}

}  // namespace dupin::mesh
