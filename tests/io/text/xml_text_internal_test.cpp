#include <gtest/gtest.h>

#include "text/xml_text.h"

namespace dupin::text {
namespace {

TEST(XmlText, has_nothing_that_xml_has_another_meaning_for) {
  EXPECT_EQ(xml_escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_EQ(xml_escaped("a]]>b"), "a]]&gt;b");
  EXPECT_EQ(xml_escaped("\u65e5\uFFFD\U0001F600"), "\u65e5\uFFFD\U0001F600");
}

TEST(XmlText, has_no_characters_that_xml_has_not) {
  EXPECT_EQ(xml_escaped("a\uFFFE\uFFFFb\uFFFC"), "a\uFFFD\uFFFDb\uFFFC");
  EXPECT_EQ(xml_escaped("\xEF\xBF"), "\uFFFD\uFFFD") << "cut off";
}

}  // namespace
}  // namespace dupin::text
