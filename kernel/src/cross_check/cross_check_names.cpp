#include "dupin/kernel/cross_check.h"

namespace dupin {

std::string_view name(CrossCheckEngine engine) {
  switch (engine) {
    case CrossCheckEngine::nef:
      return "nef";
    case CrossCheckEngine::corefinement:
      return "corefinement";
  }
  return "unknown";
}

std::string_view name(CrossCheck::Verdict verdict) {
  switch (verdict) {
    case CrossCheck::Verdict::agrees:
      return "agrees";
    case CrossCheck::Verdict::disagrees:
      return "disagrees";
    case CrossCheck::Verdict::engine_failed:
      return "engine_failed";
  }
  return "unknown";
}

}  // namespace dupin
