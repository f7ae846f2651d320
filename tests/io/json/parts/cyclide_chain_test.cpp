#include <string>

#include <gtest/gtest.h>

#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;
using test::read_last;

TEST(CyclideChainKey, reads_its_spheres_and_tangents) {
  const auto chain = read_last<CyclideChainThrough>(document(
      R"({"name": "c", "cyclide_chain": {"direction": [1, 0, 0], "slope": 0.5, "wall": 0.1, "spheres": [[0, 0, 0, 1], [1, 0, 0, 2], [2, 0, 0, 3]], "tangents": [{"sphere": 2, "tangent": [1, 0, 0, 0]}], "joints": "kneecaps"}})"));
  EXPECT_EQ(std::get<ChainDirection>(chain.from).slope, 0.5);
  ASSERT_EQ(chain.spheres.size(), 3U);
  EXPECT_EQ(chain.spheres[2], (PeVector{{2, 0, 0}, 3}));
  ASSERT_EQ(chain.tangents.size(), 1U);
  EXPECT_EQ(chain.tangents[0].sphere, 2U);
  EXPECT_EQ(chain.wall, 0.1);
  EXPECT_EQ(chain.joints, ChainJoints::kneecaps);
}

TEST(CyclideChainKey, says_what_is_wrong_with_it) {
  const Malformed rows[] = {
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [[0, 0, 0]]}})"),
       "d.json#/parts/0/cyclide_chain/spheres/0", "must be four numbers [x, y, z, radius], not 3"},
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [], "slope": 1}})"),
       "d.json#/parts/0/cyclide_chain/slope", "a slope needs a direction"},
      {document(
           R"({"name": "c", "cyclide_chain": {"spheres": [], "from": "a.end", "direction": [1, 0, 0]}})"),
       "d.json#/parts/0/cyclide_chain/direction", "a chain from a port has its direction already"},
      {document(
           R"({"name": "c", "cyclide_chain": {"spheres": [], "tangents": [{"sphere": -1, "tangent": [1, 0, 0, 0]}]}})"),
       "d.json#/parts/0/cyclide_chain/tangents/0/sphere", "must be an index, counted from 0"},
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [], "joints": "caps"}})"),
       "d.json#/parts/0/cyclide_chain/joints", "must be \"smooth\" or \"kneecaps\", not \"caps\""},
      {document(R"({"name": "c", "cyclide_chain": {"spheres": [], "wall": 0}})"),
       "d.json#/parts/0/cyclide_chain/wall", "the wall's thickness must be positive"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
