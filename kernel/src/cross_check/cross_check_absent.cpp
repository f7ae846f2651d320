#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/error.h"

// A build without the engines.
namespace dupin {
namespace {

[[noreturn]] void refuse() {
  throw Error(Errc::invalid_argument,
              "this build has no other engines to check with; build with DUPIN_CROSS_CHECK=ON");
}

}  // namespace

bool has_cross_check() { return false; }

Solid combine_by(CrossCheckEngine, SetOperation, std::span<const Solid>, const Progress&) {
  refuse();
}

Solid evaluate_by(CrossCheckEngine, const Expression&, const std::map<std::string, Solid>&,
                  const Progress&) {
  refuse();
}

CrossCheck second_opinion(const Solid&, CrossCheckEngine, SetOperation, std::span<const Solid>,
                          const Progress&) {
  refuse();
}

CrossCheck second_opinion(const Solid&, CrossCheckEngine, const Expression&,
                          const std::map<std::string, Solid>&, const Progress&) {
  refuse();
}

}  // namespace dupin
