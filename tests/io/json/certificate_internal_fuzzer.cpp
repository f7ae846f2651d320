// Certificates, sealed again after every change: believed or refused for one of the reasons that
// are promised; what is believed is still so when written and read again. The seal is not in the
// input. See tests/support/fuzz_target.h.

#include <string>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/kernel/error.h"
#include "json/certificate_seal.h"
#include "support/fuzz_target.h"

std::vector<std::string> dupin::test::fuzz_seeds() {
  std::vector<std::string> seeds;
  for (const char* parts : {
           R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [3, 0, 0], "radius": 1}},
              {"name": "s", "sphere": {"center": [0, 4, 0], "radius": 1}})",
           R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [3, 0, 0], "radius": 1}},
              {"name": "e", "elbow": {"from": "p.end", "bend_radius": 4, "angle": 90,
                                      "toward": [0, 1, 0]}})",
           R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [3, 0, 0], "radius": 1}},
              {"name": "q", "cone": {"from": [0, 1, -5], "to": [0, 1, 5], "radii": [1, 2]}})"}) {
    const std::string text =
        R"({"units": "mm", "tolerance": 0.5, "parts": [)" + std::string(parts) + "]}";
    const std::string sealed = certificate_json(certify(parse_assembly(text)));
    seeds.push_back(sealed.substr(0, sealed.rfind("  \"sha256\"")));
  }
  return seeds;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using dupin::Errc;
  dupin::Certificate believed;
  try {
    believed = dupin::parse_certificate(dupin::json::sealed(std::string(data, data + size)));
    verify(believed);
  } catch (const dupin::Error& error) {
    if (error.code() != Errc::parse_failed && error.code() != Errc::invalid_argument &&
        error.code() != Errc::limit_exceeded) {
      throw;
    }
    return 0;
  }
  (void)certificate_summary_json(believed);
  verify(dupin::parse_certificate(certificate_json(believed)));
  return 0;
}
