#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/kernel/error.h"
#include "support/known_extensions.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

TriMesh read_any(std::string_view bytes, std::string_view file) { return read_mesh(bytes, file); }

TEST(MalformedMesh, off_is_refused_with_its_line) {
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string keyword = "expected the keyword OFF (or COFF, NOFF, CNOFF, STOFF)";
  test::expect_refused(
      read_any, "a.off",
      {
          {"", "a.off:1: found the end of the file, " + keyword},
          {"\n# no mesh\n3 1 0\n", "a.off:3: found '3', " + keyword},
          {"4OFF\n3 1 0\n", "a.off:1: found '4OFF', " + keyword},
          {"OFFICE\n", "a.off:1: found 'OFFICE', " + keyword},
          {"OFF BINARY\n", "a.off:1: found 'BINARY', expected the text form of OFF"},
          {"OFF\n",
           "a.off:2: found the end of the file, expected the number of vertices, an integer"},
          {"OFF\n3\n",
           "a.off:2: found the end of the line, expected the number of faces, an integer"},
          {"OFF\nthree 1 0\n",
           "a.off:2: found 'three', expected the number of vertices, an integer"},
          {"OFF\n-3 1 0\n",
           "a.off:2: found '-3', expected the number of vertices, an integer from 0 to 4294967295"},
          {"OFF\n3.5 1 0\n", "a.off:2: found '3.5', expected the number of vertices, an integer"},
          {"OFF\n99999999999999999999 1 0\n",
           "a.off:2: found '99999999999999999999', expected the number of vertices, an integer "
           "from 0 "
           "to 4294967295"},
          {"OFF\n3 1 0 0\n", "a.off:2: found '0', expected the end of the line behind the counts"},
          {"OFF\n4000000000 4000000000 0\n0 0 0\n",
           "a.off:2: found counts of 4000000000 vertices and 4000000000 faces, expected at least "
           "56000000000 bytes after them, not 6"},
          {"OFF\n2 0 0\n0 0 0\n",
           "a.off:2: found counts of 2 vertices and 0 faces, expected at least 12 bytes after "
           "them, "
           "not 6"},
          {"OFF\n1 0 0\n0 0\n  \n", "a.off:3: found the end of the line, expected a coordinate"},
          {"OFF\n1 0 0\n0 0 0 0\n",
           "a.off:3: found '0', expected the end of the line behind a vertex"},
          {"OFF\n1 0 0\n0 nan 0\n", "a.off:3: found 'nan', expected a coordinate that is finite"},
          {"OFF\n1 0 0\n0 0 -inf\n", "a.off:3: found '-inf', expected a coordinate that is finite"},
          {"OFF\n1 0 0\n1e999 0 0\n",
           "a.off:3: found '1e999', expected a coordinate in the range of doubles"},
          {"OFF\n1 0 0\n1,5 0 0\n", "a.off:3: found '1,5', expected a coordinate"},
          {"OFF\n1 0 0\n0x1p3 0 0\n", "a.off:3: found '0x1p3', expected a coordinate"},
          {"OFF\n1 0 0\n+-1 0 0 0\n", "a.off:3: found '+-1', expected a coordinate"},
          {"OFF\n1 0 0\n0 0 \xff\xfe\n", "a.off:3: found '\\xff\\xfe', expected a coordinate"},
          {std::string("OFF\n1 0 0\n0 0 \0\n", 16),
           "a.off:3: found '\\x00', expected a coordinate"},
          {"COFF\n1 0 0\n0 0 0 red\n",
           "a.off:3: found 'red', expected a component of a normal, colour or texture coordinate"},
          {head + "         ",
           "a.off:6: found the end of the file, expected a face: its number of vertices, an "
           "integer"},
          {head + "2 0 1 \n",
           "a.off:6: found '2', expected a face: its number of vertices, an integer from 3 to "
           "4294967295"},
          {head + "3 0 1 3\n",
           "a.off:6: found '3', expected the index of a vertex, an integer from 0 to 2"},
          {head + "3 0 1 -1\n",
           "a.off:6: found '-1', expected the index of a vertex, an integer from 0 to 2"},
          {head + "3 0 1 0.5\n",
           "a.off:6: found '0.5', expected the index of a vertex, an integer"},
          {head + "3 0 1   \n#2\n",
           "a.off:8: found the end of the file, expected the index of a vertex, an integer"},
          {head + "3 0 1 2 2nan\n", "a.off:6: found '2nan', expected a colour's component"},
          {head + "3 0 1 2 --1\n", "a.off:6: found '--1', expected a colour's component"},
          {head + "3 0 1 2 1 2 3 4 5\n",
           "a.off:6: found more than 4 numbers behind a face of 3 vertices, expected at most a "
           "colour"},
          {head + "3 0 1 2 blue\n", "a.off:6: found 'blue', expected a colour's component"},
          {head + "3 0 1 2\n3 0 1 2\n",
           "a.off:7: found '3', expected the end of the file behind the last face"},
          {"OFF\n0 1 0\n3 0 0 0\n", "a.off:2: found 1 faces of no vertices, expected vertices"},
      });
}

TEST(MalformedMesh, content_of_no_known_format_is_refused) {
  const std::string known = ", expected a mesh (" + test::known_extensions() + ", .msh)";
  test::expect_refused(read_any, "stdin", {{"", "stdin:byte 0: found '' at the start" + known}});
  test::expect_refused(read_any, "a.txt",
                       {{"hello\n", "a.txt:byte 0: found 'hello\\x0a' at the start" + known}});
  test::expect_refused(
      read_any, "a.vtu",
      {{"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n",
        "a.vtu:byte 0: found a VTK UnstructuredGrid, which is written but not read (.msh holds the "
        "same, and is)" +
            known}});
}

}  // namespace
}  // namespace dupin
