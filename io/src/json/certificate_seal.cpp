#include "json/certificate_seal.h"

#include "dupin/io/sha256.h"

namespace dupin::json {
namespace {

constexpr std::string_view kKey = "  \"sha256\": \"", kEnd = "\"\n}\n";
constexpr std::size_t kDigest = 64;

}  // namespace

std::string sealed(const std::string& text) {
  return text + std::string(kKey) + sha256(text) + std::string(kEnd);
}

bool has_seal(std::string_view text) {
  const std::size_t tail = kKey.size() + kDigest + kEnd.size();
  return text.size() >= tail && sealed(std::string(text.substr(0, text.size() - tail))) == text;
}

}  // namespace dupin::json
