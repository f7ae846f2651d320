#include "ranks.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace dupin::cli {
namespace {

TEST(Ranks, without_mpirun_is_one) {
  ASSERT_FALSE(is_under_mpirun());
  const Ranks ranks;
  EXPECT_EQ(ranks.count(), 1);
  EXPECT_TRUE(ranks.is_first());
}

TEST(Ranks, one_process_of_mpirun_needs_no_mpi) {
  ::setenv("OMPI_COMM_WORLD_SIZE", "1", 1);
  EXPECT_FALSE(is_under_mpirun());
  ::setenv("OMPI_COMM_WORLD_SIZE", "3", 1);
  EXPECT_TRUE(is_under_mpirun());
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
}

}  // namespace
}  // namespace dupin::cli
