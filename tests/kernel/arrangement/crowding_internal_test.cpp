#include "arrangement/crowding.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/pipe_cases.h"

namespace dupin::arrangement {
namespace {

bool is_crowded(const char* name) {
  const test::Stages stages(test::pipe_case(name));
  return crowded(stages.input, stages.candidates());
}

TEST(Crowding, is_where_many_meet_each_other_in_one_place) {
  for (const char* name : {"star_12", "star_12_rot", "star_general_12", "coaxial_10"}) {
    EXPECT_TRUE(is_crowded(name)) << name;
  }
}

// However many cross each other in places apart; boxes of turned racks overlap all over.
TEST(Crowding, is_not_where_few_meet_the_same) {
  for (const char* name :
       {"star_5", "coaxial_5", "rack_eq_small", "rack_eq_small_rot", "header_10", "chain_10_fan"}) {
    EXPECT_FALSE(is_crowded(name)) << name;
  }
}

}  // namespace
}  // namespace dupin::arrangement
