#include "dupin/io/msh.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kHead = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string kNodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n7 0 1 0\n4 0 0 1\n$EndNodes\n";

TEST(Msh, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, false);
    EXPECT_TRUE(test::identical(read_msh(msh_text(mesh), "x.msh"), mesh));
  }
  const TriMesh labelled = test::labelled_tetrahedron();
  EXPECT_TRUE(test::identical(read_msh(msh_text(labelled), "x.msh"), labelled));
  EXPECT_TRUE(test::identical(read_msh(msh_text({}), "x.msh"), {}));
}

TEST(Msh, labels_are_physical_surfaces) {
  EXPECT_THAT(
      msh_text(test::labelled_tetrahedron(), {"m", ""}),
      testing::HasSubstr(
          "# unit: m\n$EndComments\n$PhysicalNames\n2\n2 1 \"inlet\"\n2 2 \"the blend\"\n"));
  EXPECT_THAT(
      msh_text(test::labelled_tetrahedron()),
      testing::HasSubstr("$Elements\n4\n1 2 2 1 1 1 3 2\n2 2 2 1 1 1 2 4\n3 2 2 2 2 1 4 3\n"));
}

// There is no way to write a quote: two patches became one.
TEST(Msh, patches_keep_apart_whose_names_differ_in_quotes) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.names = {"a\"b", "a'b"};
  EXPECT_THAT(msh_text(mesh), testing::HasSubstr("\n2 1 \"a'b (2)\"\n2 2 \"a'b\"\n"));
  const TriMesh read = read_msh(msh_text(mesh), "x.msh");
  EXPECT_EQ(read.labels, mesh.labels);
  EXPECT_EQ(read.names, (std::vector<std::string>{"a'b (2)", "a'b"}));
}

TEST(Msh, takes_what_gmsh_puts_beside_a_surface) {
  const TriMesh mesh = read_msh(kHead +
                                    "$PhysicalNames\n2\n1 5 \"an edge\"\n2 5 "
                                    "\"side\"\n$EndPhysicalNames\n$Entities\nany\n$EndEntities\n" +
                                    kNodes +
                                    "$Elements\n4\n1 15 2 0 1 1\n2 1 2 5 1 1 2\n3 3 2 5 1 1 2 7 "
                                    "4\n9 2 3 6 1 0 1 2 7\n$EndElements\n",
                                "x");
  EXPECT_EQ(mesh.triangles.size(), 3);
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"side", "surface 6"}));
}

TEST(Msh, is_refused_with_its_line) {
  const std::string none = kHead + kNodes + "$Elements\n1\n";
  test::expect_refused(
      read_msh, "x.msh",
      {{"$MeshFormat\n4.1 0 8\n",
        "x.msh:2: found '4.1', expected MSH of version 2 (in gmsh: -format msh22, or "
        "Mesh.MshFileVersion = 2.2)"},
       {"$MeshFormat\n2.2 1 8\n",
        "x.msh:2: found '1', expected 0, for text (in gmsh: without -bin, or Mesh.Binary = 0)"},
       {kHead + kNodes, "x.msh:11: found the end of the file, expected the section $Elements"},
       {kHead + kNodes + "$Elements\n1\n1 15 2 0 1 1\n$EndElements\n",
        "x.msh:15: found the end of the file, expected triangles or quadrangles of the 4 nodes"},
       {kHead + "Nodes\n", "x.msh:4: found 'Nodes', expected a section, such as $Nodes"},
       {kHead + "$Other\n1\n", "x.msh:6: found the end of the file, expected $EndOther"},
       {none + "1 5 2 1 1 1 2 7 4 1 2 7 4\n",
        "x.msh:13: found an element of type 5, expected triangles (2), quadrangles (3) and "
        "tetrahedra (4) of the first order"},
       {none + "1 4 2 1 1 1 2 7 4\n$EndElements\n",
        "x.msh:15: found the end of the file, expected triangles or quadrangles of the 4 nodes"},
       {none + "1 2 2 1 1 1 2 3\n",
        "x.msh:13: found a node that is not there, expected one of $Nodes"},
       {kHead + "$Nodes\n2\n1 0 0 0\n1 0 0 1\n", "x.msh:7: found node 1 twice, expected it once"},
       {kHead + "$PhysicalNames\n1\n2 1 side\n",
        "x.msh:6: found 'side', expected a name in quotes"}});
}

}  // namespace
}  // namespace dupin
