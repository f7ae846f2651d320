#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/pipe_cases.h"
#include "support/shapes.h"

namespace dupin {
namespace {

std::vector<Solid> solids(std::string_view pipe_case) {
  std::vector<Solid> all;
  for (const TriMesh& mesh : test::pipe_case(pipe_case)) {
    all.push_back(Solid::from(mesh));
  }
  return all;
}

template <class Function>
void expect_refusal(const Function& function, Errc code, const std::string& part_of_message) {
  try {
    (void)function();
    ADD_FAILURE() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_THAT(error.what(), testing::HasSubstr(part_of_message));
  }
}

TEST(BooleanLimits, memory_is_estimated_before_it_is_taken) {
  const std::vector<Solid> pair = solids("coax");
  expect_refusal([&] { return unite(pair, {.memory_limit = 100000}); }, Errc::limit_exceeded,
                 "the boolean operation on 1280 triangles would need about 0.256 MB of memory; "
                 "allowed are 0.1 MB");
  const std::vector<Solid> rack = solids("rack_small");
  expect_refusal([&] { return unite(rack, {.memory_limit = 2000000}); }, Errc::limit_exceeded,
                 "pairs meet, would need about");
  EXPECT_EQ(unite(pair, {.memory_limit = 1000000000}).components(), 1U);
}

TEST(BooleanLimits, progress_comes_from_the_calling_thread_and_grows) {
  const std::vector<Solid> rack = solids("rack_small");
  const std::thread::id caller = std::this_thread::get_id();
  double last = 0;
  std::size_t calls = 0;
  const Progress progress = [&](std::string_view stage, double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_FALSE(stage.empty());
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    ++calls;
    return true;
  };
  (void)unite(rack, {.progress = progress});
  // With others at work, how often the caller hears depends on what it gets to do itself.
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  last = 0;
  calls = 0;
  (void)unite(rack, {.progress = progress});
  EXPECT_GT(calls, 20U);
}

// How many calls there are depends on what the calling thread gets to do.
TEST(BooleanLimits, can_be_cancelled_at_any_call) {
  const std::vector<Solid> rack = solids("rack_small");
  for (int after = 0; after < 100; after += 7) {
    int calls = 0;
    bool refused = false;
    const Progress progress = [&](std::string_view, double) {
      EXPECT_FALSE(refused) << "a call after a refusal";
      refused = calls++ == after;
      return !refused;
    };
    try {
      (void)unite(rack, {.progress = progress});
      EXPECT_LE(calls, after);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::cancelled);
      EXPECT_TRUE(refused);
    }
  }
}

// Products of nine coordinates underflow doubles, or nearly overflow them; the decisions do not.
TEST(BooleanLimits, any_size_in_range_will_do) {
  for (const double size : {0x1p-140, 0x1p-100, 0x1p100, 0x1p125}) {
    SCOPED_TRACE(size);
    TriMesh a = test::tube(1, -3, 3, 7), b = a;
    for (Vec3& point : a.points) {
      point *= size;
    }
    for (Vec3& point : b.points) {
      point = size * Vec3(point.z(), point.x() + 0.1, point.y());
    }
    const std::vector<Solid> both = {Solid::from(a), Solid::from(b)};
    const Solid united = unite(both), common = intersect(both);
    EXPECT_EQ(united.components(), 1U);
    EXPECT_EQ(united.genus(), 0);
    EXPECT_EQ(united.exact_volume() + common.exact_volume(),
              both[0].exact_volume() + both[1].exact_volume());
  }
}

}  // namespace
}  // namespace dupin
