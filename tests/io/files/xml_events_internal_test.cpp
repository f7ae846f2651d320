#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "files/xml_events.h"

namespace dupin::files {
namespace {

/// The events of a text, "<" and ">" for begin and end.
std::string events_of(const std::string& xml, const std::string& last = "none") {
  std::string told;
  read_xml(xml, "x",
           {[&](std::string_view element, const XmlAttributes& attributes) {
              told += "<" + std::string(element) + std::string(attributes.find("a").value_or(""));
              return element != last;
            },
            [&](std::string_view element) { told += ">" + std::string(element); }});
  return told;
}

Error error_of(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  return Error(Errc::cancelled, "no error");
}

TEST(XmlEvents, come_in_order_with_local_names) {
  EXPECT_EQ(events_of("<m:r xmlns:m=\"u\" a=\"1\"><m:e a=\"&lt;\"/><f b=\"2\"/></m:r>"),
            "<r1<e<>e<f>f>r");
}

TEST(XmlEvents, of_other_namespaces_than_the_roots_come_apart_where_that_is_asked_for) {
  const std::string xml =
      "<m:r xmlns:m=\"u\" xmlns:s=\"v\" xmlns=\"u\"><e/><s:e><m:f/><g/></s:e><x "
      "xmlns=\"w\"/></m:r>";
  EXPECT_EQ(events_of(xml), "<r<e>e<e<f>f<g>g>e<x>x>r");
  std::string told;
  std::string space;
  read_xml(xml, "x",
           {[&](std::string_view element, const XmlAttributes& attributes) {
              told += "<" + std::string(element);
              space = attributes.spaces().find("s")->second;
              return true;
            },
            [&](std::string_view element) { told += ">" + std::string(element); },
            {},
            [&](std::string_view element) { told += "!" + std::string(element); }});
  EXPECT_EQ(told, "<r<e>e!e<f>f<g>g!x>r");
  EXPECT_EQ(space, "v");
}

TEST(XmlEvents, end_when_enough_was_read) {
  EXPECT_EQ(events_of("<r><e/><f/></r>", "e"), "<r<e");
  EXPECT_EQ(events_of("<r><e/><f", "e"), "<r<e") << "what follows is not looked at";
}

TEST(XmlEvents, of_a_long_text_are_complete) {
  std::string xml = "<r>";
  for (int i = 0; i < 300000; ++i) {
    xml += "<e/>\n";
  }
  EXPECT_EQ(events_of(xml + "</r>").size(), 4U + 4 * 300000);
}

TEST(XmlEvents, faults_are_told_with_their_line) {
  EXPECT_STREQ(error_of([] { (void)events_of("<r>\n</e>"); }).what(),
               "x:2: found faulty XML (mismatched tag), expected valid XML");
  EXPECT_EQ(error_of([] { (void)events_of(""); }).code(), Errc::parse_failed);
  EXPECT_STREQ(
      error_of([] { (void)events_of("<!DOCTYPE r [<!ENTITY e \"e\">]><r>&e;</r>"); }).what(),
      "x:1: found a document type declaration, expected none");
}

TEST(XmlEvents, errors_of_an_event_get_the_line_unless_they_know_a_place) {
  const auto failing = [](const Error& error) {
    return error_of([&] {
      read_xml("<r>\n\n<e/></r>", "x",
               {[&](std::string_view element, const XmlAttributes&) -> bool {
                  return element == "r" ? true : throw error;
                },
                [](std::string_view) {}});
    });
  };
  EXPECT_STREQ(failing(Error(Errc::limit_exceeded, "too much")).what(), "x:3: too much");
  EXPECT_EQ(failing(Error(Errc::limit_exceeded, "too much")).code(), Errc::limit_exceeded);
  EXPECT_STREQ(failing(Error(Errc::parse_failed, "bad", {}, "there")).what(), "there: bad");
}

TEST(XmlEvents, other_exceptions_pass) {
  EXPECT_THROW(read_xml("<r/>", "x",
                        {[](std::string_view, const XmlAttributes&) -> bool {
                           throw std::runtime_error("out of ideas");
                         },
                         [](std::string_view) {}}),
               std::runtime_error);
}

}  // namespace
}  // namespace dupin::files
