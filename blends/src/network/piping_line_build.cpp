#include <algorithm>
#include <utility>

#include "dupin/blends/piping_line.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "network/part_fault.h"

namespace dupin {
namespace {

// The component of the part that an error names.
std::optional<std::string> named_component(const PipingNetwork& network, const Error& error) {
  const std::string name = network::named_part(error);
  const auto part = std::ranges::find(network.assembly.parts, name, &Part::name);
  if (part == network.assembly.parts.end()) {
    return std::nullopt;
  }
  return network.origins[std::size_t(part - network.assembly.parts.begin())];
}

/// The error with the component's line as its place, instead of one in a document that nobody
/// wrote.
Error at_line(const Error& error, const PipingLine& line, const std::optional<std::string>& name,
              bool keep_going) {
  const auto component =
      std::ranges::find(line.components, name.value_or(std::string()), &PipingComponent::name);
  if (!name || component == line.components.end()) {
    return error;
  }
  const bool is_left_out = !keep_going && network::is_of_part(error.code());
  return Error(error.code(), error.message() + (is_left_out ? "; --keep-going leaves it out" : ""),
               error.part(), line.source + ":" + std::to_string(component->line));
}

}  // namespace

Built build(const PipingLine& line, const PipingOptions& options, PipingNetwork& network,
            const BuildOptions& build_options) {
  const UsualArithmetic usual;
  PipingOptions fewer = options;
  for (int round = 0;; ++round) {
    try {
      return build(network.assembly, build_options);
    } catch (const Error& error) {
      const auto component = named_component(network, error);
      const bool is_chosen = options.fillet == 0 && component && component->ends_with("-fillet");
      if ((!options.keep_going && !is_chosen) || !component || !network::is_of_part(error.code()) ||
          round == network::kMostRounds ||
          !fewer.refused.emplace(*component, error.message()).second) {
        throw at_line(error, line, component, options.keep_going);
      }
    }
    network = assembly_of(line, fewer);
  }
}

}  // namespace dupin
