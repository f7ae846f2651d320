#include "dupin/blends/build.h"

#include <array>

#include "dupin/kernel/parallel.h"

namespace dupin {

std::string_view name(Region region) {
  constexpr std::array<std::string_view, 4> kNames{"outer", "metal", "fluid", "insulation"};
  return kNames.at(std::size_t(region));
}

Built build(const Assembly& assembly, const BuildOptions& options) {
  const UsualArithmetic usual;
  BuildOptions whole = options;
  whole.most_of_piece = 0;
  return DistrictBuild(assembly, whole).build_all(options.progress);
}

}  // namespace dupin
