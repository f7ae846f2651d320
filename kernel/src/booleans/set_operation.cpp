#include "dupin/kernel/set_operation.h"

namespace dupin {

std::string_view name(SetOperation operation) {
  switch (operation) {
    case SetOperation::unite:
      return "unite";
    case SetOperation::intersect:
      return "intersect";
    case SetOperation::subtract:
      return "subtract";
  }
  return "unknown";
}

}  // namespace dupin
