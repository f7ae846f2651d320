#include <algorithm>
#include <utility>

#include "assembly/bore.h"
#include "dupin/blends/piping_line.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

constexpr int kMostRounds = 50;

// Whether leaving out a part may help.
bool is_of_part(Errc code) {
  return code == Errc::irregular_surface || code == Errc::infeasible_blend ||
         code == Errc::self_intersecting || code == Errc::invalid_argument;
}

// The component of the part that an error names.
std::optional<std::string> named_component(const PipingNetwork& network, const Error& error) {
  std::string name = error.part();
  if (name.ends_with(assembly::kBoreSuffix)) {
    name.resize(name.size() - assembly::kBoreSuffix.size());
  }
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
  const bool is_left_out = !keep_going && is_of_part(error.code());
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
      if ((!options.keep_going && !is_chosen) || !component || !is_of_part(error.code()) ||
          round == kMostRounds || !fewer.refused.emplace(*component, error.message()).second) {
        throw at_line(error, line, component, options.keep_going);
      }
    }
    network = assembly_of(line, fewer);
  }
}

}  // namespace dupin
