#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "healing/open_edges.h"
#include "kernel/healing/soups_internal.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

TEST(OpenEdges, are_refused_with_copies_that_were_dropped) {
  const TriMesh whole = test::tetrahedron();
  EXPECT_NO_THROW(refuse_open_edges(soup_of(whole), whole));
  TriMesh open = whole;
  open.triangles.pop_back();
  const PolygonSoup soup = soup_of(open);
  TriMesh given = open;
  given.triangles.insert(given.triangles.end(), open.triangles.begin(), open.triangles.end());
  try {
    refuse_open_edges(soup, given);
    FAIL() << "three edges are open";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::not_closed);
    EXPECT_NE(error.message().find("3 edges are open"), std::string::npos) << error.what();
    EXPECT_NE(error.message().find(" have, copies of each other"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace dupin::healing
