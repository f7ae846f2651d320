#include <cstdint>
#include <cstring>
#include <numeric>

#include <gtest/gtest.h>

#include "support/bulk_vector.h"

namespace dupin::support {
namespace {

TEST(BulkVector, leaves_what_it_grows_by_unset) {
  UnsetAllocator<std::uint32_t> allocator;
  std::uint32_t memory = 77;
  allocator.construct(&memory);
  EXPECT_EQ(memory, 77U);
  allocator.construct(&memory, 5U);
  EXPECT_EQ(memory, 5U);
}

TEST(BulkVector, keeps_its_items_when_it_grows_beyond_huge_pages) {
  BulkVector<std::uint32_t> items(1000);
  std::iota(items.begin(), items.end(), 0U);
  items.resize(std::size_t{3} << 20);
  std::iota(items.begin() + 1000, items.end(), 1000U);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    ASSERT_EQ(items[i], i);
  }
}

TEST(BulkVector, resizes_plain_vectors_to_zeros) {
  std::vector<std::uint64_t> items;
  resize_bulk(items, std::size_t{1} << 20);
  ASSERT_EQ(items.size(), std::size_t{1} << 20);
  EXPECT_EQ(std::accumulate(items.begin(), items.end(), std::uint64_t{0}), 0U);
}

TEST(BulkVector, gives_memory_back) {
  BulkVector<int> bulk(1000);
  std::vector<int> plain(1000);
  release(bulk);
  release(plain);
  EXPECT_EQ(bulk.capacity() + plain.capacity(), 0U);
}

TEST(BulkVector, reserves_without_items) {
  std::vector<double> items;
  reserve_bulk(items, 12345);
  EXPECT_TRUE(items.empty());
  EXPECT_GE(items.capacity(), 12345U);
}

}  // namespace
}  // namespace dupin::support
