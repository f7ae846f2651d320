#include <algorithm>
#include <string>

#include "assembly/bore.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

constexpr int kMostRounds = 50;

// The node or edge of the part that was refused; an arm is its node's. Empty if nothing is to be
// replaced.
std::string refused_part(const PipeNetwork& network, const Error& error) {
  const bool is_of_part =
      error.code() == Errc::irregular_surface || error.code() == Errc::infeasible_blend ||
      error.code() == Errc::self_intersecting || error.code() == Errc::invalid_argument;
  std::string name = error.part();
  if (name.ends_with(assembly::kBoreSuffix)) {
    name.resize(name.size() - assembly::kBoreSuffix.size());
  }
  name = name.substr(0, name.find('.'));
  const bool is_known = std::ranges::count(network.assembly.parts, name, &Part::name) > 0;
  return is_of_part && is_known ? name : std::string();
}

}  // namespace

Built build(const PipeGraph& graph, const PipeGraphOptions& options, PipeNetwork& network,
            const BuildOptions& build_options) {
  PipeGraphOptions fewer = options;
  for (int round = 0;; ++round) {
    try {
      return build(network.assembly, build_options);
    } catch (const Error& error) {
      const std::string part = refused_part(network, error);
      if (!options.keep_going || part.empty() || round == kMostRounds ||
          !fewer.refused.emplace(part, error.message()).second) {
        throw;
      }
    }
    const auto wall = network.assembly.wall;
    network = assembly_of(graph, fewer);
    network.assembly.wall = wall;
  }
}

}  // namespace dupin
