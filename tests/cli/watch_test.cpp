#include <string>

#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using Watch = Tool;

// Waits for up to ten seconds until a command succeeds.
const std::string kPrelude =
    "until_() { for i in $(seq 200); do eval \"$1\" && return 0; sleep 0.05; done; return 1; }; "
    "sphere() { echo '{\"units\": \"mm\", \"tolerance\": 0.1, \"parts\": [{\"name\": \"a\", "
    "\"sphere\": {\"center\": [0, 0, 0], \"radius\": '$1'}}]}' > new; mv new a.json; }; ";

TEST_F(Watch, builds_again_when_the_document_changes_and_goes_on_after_errors) {
  const ProcessResult result = shell(
      kPrelude + "sphere 1; " + tool_path() +
      " watch a.json -o a.off > out 2> err & pid=$!; "
      "until_ '[ -e a.off ]' || exit 10; cp a.off first; "
      "sphere -1; until_ 'grep -q radius err' || exit 11; cmp -s a.off first || exit 12; "
      "sphere 2; until_ '! cmp -s a.off first' || exit 13; "
      "rm a.json; until_ 'grep -q \"is gone\" err' || exit 14; cp a.off second; "
      "sphere 1; until_ 'cmp -s a.off first' || exit 15; "
      "kill -0 $pid || exit 16; kill -TERM $pid; wait $pid; [ $? = 143 -o $? = 130 ] || exit 17; "
      "grep -c written out; ls -A | tr '\\n' ' '");
  EXPECT_EQ(result.exit_code, 0) << result.err << folder_.read("err") << folder_.read("out");
  EXPECT_EQ(result.out, "3\na.json a.off err examples first out second ");
}

TEST_F(Watch, needs_a_file_that_is_there) {
  EXPECT_EQ(dupin({"watch", "none.json", "-o", "a.stl"}).exit_code, 3);
  EXPECT_EQ(dupin({"watch", "-", "-o", "a.stl"}).exit_code, 2);
  EXPECT_EQ(dupin({"watch", example("reducer.json"), "-o", "a.txt"}).exit_code, 2);
}

}  // namespace
}  // namespace dupin::test
