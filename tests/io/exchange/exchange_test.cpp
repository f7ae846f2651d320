#include "dupin/io/exchange.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dupin/blends/part_measures.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

Assembly example(const std::string& name) {
  return read_assembly(DUPIN_SOURCE_DIR "/examples/" + name + ".json");
}

TEST(Exchange, solids_of_parts_have_the_volumes_of_their_formulas) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  for (const char* name : {"reducer", "reducing-elbow", "oblique-nozzle"}) {
    const Assembly assembly = example(name);
    const ExchangeFile file = step_file(assembly, build(assembly), {1e-4, ExchangeSolids::parts});
    const ResolvedAssembly resolved = resolve(assembly);
    ASSERT_EQ(file.report.solids.size(), resolved.parts.size());
    for (std::size_t i = 0; i < resolved.parts.size(); ++i) {
      EXPECT_EQ(file.report.solids[i].name, resolved.parts[i].name);
      const PartMeasures exact = measures(resolved.parts[i].shape);
      const double bound = file.report.error_bound * exact.area + 1e-6 * exact.solid->volume;
      EXPECT_NEAR(file.report.solids[i].volume, exact.solid->volume, bound);
    }
  }
}

TEST(Exchange, has_names) {
  EXPECT_EQ(name(ExchangeSolids::united), "united");
  EXPECT_EQ(name(ExchangeSolids::runs), "runs");
  EXPECT_EQ(name(ExchangeSolids::parts), "parts");
}

}  // namespace
}  // namespace dupin
