#include "io/json/forged_certificates.h"

#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

// The objects of a value, by what leads to them, whichever elements of arrays these are.
void collect_objects(const Json& value, const Pointer& at, const std::string& kind,
                     std::map<std::string, Pointer>& found) {
  if (value.is_object()) {
    found.emplace(kind, at);
    for (const auto& [key, below] : value.items()) {
      collect_objects(below, at / key, kind + "/" + key, found);
    }
  }
  for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
    collect_objects(value[i], at / i, kind + "/*", found);
  }
}

std::string resealed(Json json) {
  json.erase("sha256");
  std::string text = json.dump(1);
  text.resize(text.rfind('\n'));
  text += ",\n";
  return text + "  \"sha256\": \"" + sha256(text) + "\"\n}\n";
}

// In objects of kinds that have not been looked at.
void expect_no_key_goes_unread(const Certificate& honest, std::set<std::string>& seen) {
  const Json json = Json::parse(certificate_json(honest));
  ASSERT_NO_THROW(verify(parse_certificate(resealed(json)))) << "in another layout";
  std::map<std::string, Pointer> objects;
  collect_objects(json, Pointer(), "", objects);
  for (const auto& [kind, at] : objects) {
    if (!seen.insert(kind).second) {
      continue;
    }
    for (const char* const key : {"remark", "distance"}) {
      if (json[at].contains(key)) {
        continue;
      }
      Json forged = json;
      forged[at][key] = 1000;
      try {
        static_cast<void>(parse_certificate(resealed(forged), "forged.json"));
        ADD_FAILURE() << "believed: " << kind << "/" << key;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::parse_failed);
        EXPECT_THAT(error.what(),
                    testing::StartsWith("forged.json#" + (at / key).to_string() + ": unknown key"));
      }
    }
  }
}

// The one of a seed has all claims that there are, and a part without any.
TEST(ForgedCertificates, have_no_key_that_goes_unread) {
  std::mt19937_64 random(15);
  std::set<std::string> seen;
  expect_no_key_goes_unread(test::truth(random).honest, seen);
  for (const char* const name : {"jet-engine.json", "cone-to-pipe.json", "crane-hook.json",
                                 "oval-duct.json", "ucct-arm.json", "ringed-canal.json"}) {
    const std::filesystem::path path = test::source_folder() / "examples" / name;
    expect_no_key_goes_unread(certify(read_assembly(path)), seen);
  }
}

TEST(ForgedCertificates, of_a_unit_that_is_none_have_its_place_told) {
  std::mt19937_64 random(15);
  Json forged = Json::parse(certificate_json(test::truth(random).honest));
  forged["units"] = "furlong";
  try {
    static_cast<void>(parse_certificate(resealed(forged), "forged.json"));
    ADD_FAILURE() << "believed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::parse_failed);
    EXPECT_THAT(error.what(), testing::StartsWith("forged.json#/units: the unit must be mm"));
  }
}

// Of two shapes, or two ways of a ball, one would be looked at and the other be believed.
TEST(ForgedCertificates, have_no_second_shape) {
  std::mt19937_64 random(15);
  const Json honest = Json::parse(certificate_json(test::truth(random).honest));
  Json ball = honest, loop = honest;
  ASSERT_TRUE(ball["parts"][2].contains("sphere"));
  ball["parts"][2]["pieces"] = honest["parts"][0]["pieces"];
  ASSERT_TRUE(loop["fillets"][0]["loops"][0].contains("rolling_through"));
  loop["fillets"][0]["loops"][0]["rolling_partly"] = Json::object();
  for (const auto& [forged, place] :
       {std::pair(ball, "/parts/2/pieces"), std::pair(loop, "/fillets/0/loops/0/rolling_partly")}) {
    try {
      static_cast<void>(parse_certificate(resealed(forged), "forged.json"));
      ADD_FAILURE() << "believed: " << place;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(),
                  testing::StartsWith("forged.json#" + std::string(place) + ": unknown key"));
    }
  }
}

// That nothing is proved of a contact is said by null: what says it in another way, or says
// nothing, would be taken for a proof by whoever does not look for it.
TEST(ForgedCertificates, have_no_contact_that_is_neither_bounded_nor_null) {
  std::mt19937_64 random(15);
  const Certificate honest = test::truth(random).honest;
  const Pointer at = Pointer("/fillet_claims/0/0/contact");
  Json open = Json::parse(certificate_json(honest));
  ASSERT_TRUE(open.at(at).contains("offset"));
  open[at] = nullptr;
  const Certificate read = parse_certificate(resealed(open));
  EXPECT_NO_THROW(verify(read));
  EXPECT_FALSE(read.fillet_claims[0][0].contact);
  EXPECT_EQ(read.findings(), honest.findings() + 1);
  const Json summary = Json::parse(certificate_summary_json(read)).at("fillets").at(0);
  EXPECT_TRUE(summary.at("offset").is_null() && summary.at("deviation").is_null());
  const auto expect_refused = [](const Json& forged) {
    try {
      static_cast<void>(parse_certificate(resealed(forged), "forged.json"));
      ADD_FAILURE() << "believed: " << forged["fillet_claims"][0][0].dump();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed);
      EXPECT_THAT(error.what(), testing::StartsWith("forged.json#/fillet_claims/0/0"));
    }
  };
  for (const char* const other :
       {"{}", "[]", "false", "0", "\"undecided\"", "\"proved\"", "{\"offset\": 0}",
        "{\"deviation\": 0}", "{\"offset\": null, \"deviation\": null}",
        "{\"verdict\": \"proved\"}",
        "{\"offset\": 1, \"deviation\": 1, \"verdict\": \"undecided\"}"}) {
    Json forged = open;
    forged[at] = Json::parse(other);
    expect_refused(forged);
  }
  Json left_out = open;
  left_out["fillet_claims"][0][0].erase("contact");
  expect_refused(left_out);
}

TEST(ForgedCertificates, are_forged_in_many_ways) { EXPECT_GE(test::forgeries().size(), 20U); }

TEST(ForgedCertificates, are_not_believed) { test::expect_none_believed(15, 300); }

}  // namespace
}  // namespace dupin
