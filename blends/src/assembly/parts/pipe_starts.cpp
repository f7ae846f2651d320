#include "assembly/parts/pipe_starts.h"

#include <variant>

#include "assembly/parts/part_kind.h"

namespace dupin::assembly {
namespace {

// A tee's parts have the keys under which it says them.
std::string tee_of(const Part& run, const Part& branch) {
  const bool is_tee =
      run.key == "tee" && branch.key == "tee/branch" && branch.component.name == run.name;
  return is_tee ? run.name : std::string();
}

}  // namespace

PipeStarts pipe_starts(const Assembly& assembly, const std::array<std::uint32_t, 2>& parts) {
  PipeStarts result;
  for (const std::size_t i : {0U, 1U}) {
    const Part &part = assembly.parts[parts.at(i)], &other = assembly.parts[parts.at(1 - i)];
    for (const Reference& reference : part_kind(part.shape).references(part.shape)) {
      result.joined.at(i).at(at(reference.own_end)) = to_string(reference.port);
    }
    const auto* on = std::get_if<PipeOn>(&part.shape);
    if (on != nullptr && on->run == other.name) {
      const auto* along = std::get_if<PipeAlong>(&other.shape);
      result.on = {i, on->at, tee_of(other, part), along != nullptr ? along->length : 0};
    }
  }
  return result;
}

}  // namespace dupin::assembly
