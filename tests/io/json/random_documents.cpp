#include "io/json/random_documents.h"

#include <chrono>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

class Documents {
 public:
  explicit Documents(std::uint64_t seed) : random_(seed) {}

  std::string next() {
    text_.str("");
    text_ << R"({"units": "mm", "tolerance": 0.2, "parts": [)";
    switch (random_() % 7) {
      case 0:
        near_ball();
        break;
      case 1:
        near_pipes();
        break;
      case 2:
        blend("R1", "G1");
        break;
      case 3:
        blend("R1", "G2");
        break;
      case 4:
        elbow_run();
        break;
      case 5:
        spline();
        break;
      default:
        cones();
    }
    text_ << "]}";
    return text_.str();
  }

 private:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::string vector(double size) {
    std::ostringstream out;
    out.precision(17);
    out << "[" << number(-size, size) << ", " << number(-size, size) << ", " << number(-size, size)
        << "]";
    return out.str();
  }
  // Gaps from nothing to much.
  double gap() { return random_() % 3 == 0 ? 0 : std::pow(10, number(-16, 0)); }

  void near_ball() {
    const double pipe = number(.2, 1), ball = number(.5, 2);
    text_.precision(17);
    text_ << R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [10, 0, 0], "radius": )" << pipe
          << R"(}}, {"name": "q", "sphere": {"center": [)" << number(1, 9) << ", 0, "
          << pipe + ball + gap() << R"(], "radius": )" << ball << "}}";
  }

  void near_pipes() {
    const double r = number(.2, 1), s = number(.2, 1);
    text_.precision(17);
    const double height = r + s + gap();
    text_ << R"({"name": "p", "pipe": {"from": [-5, 0, 0], "to": [5, 0, 0], "radius": )" << r
          << R"(}}, {"name": "q", "pipe": {"from": [)" << number(-3, 3) << ", -4, " << height
          << "], \"to\": [" << number(-3, 3) << ", 4, " << height << R"(], "radius": )" << s
          << "}}";
  }

  void blend(const std::string& law, const std::string& continuity) {
    text_.precision(17);
    text_ << R"({"name": "in", "pipe": {"from": [-4, 0, 0], "to": [0, 0, 0], "radius": )"
          << number(.2, 1) << R"(}}, {"name": "out", "cone": {"from": [)" << number(6, 9) << ", "
          << number(-2, 2) << ", " << number(-2, 2) << R"(], "direction": [1, )" << number(-.4, .4)
          << ", " << number(-.4, .4) << R"(], "length": )" << number(.5, 3) << R"(, "radii": [)"
          << number(.3, 1) << ", " << number(.3, 1)
          << R"(]}}, {"name": "blend", "cyclic_blend": {"from": "in.end", "to": "out.start", )"
          << R"("k": "auto", "l": "auto", "radius_law": ")" << law << R"(", "continuity": ")"
          << continuity << "\"}}";
  }

  void elbow_run() {
    text_.precision(17);
    text_ << R"({"name": "a", "pipe": {"from": )" << vector(50) << R"(, "direction": )" << vector(1)
          << R"(, "length": 4, "radius": 1}}, {"name": "e", "elbow": {"from": "a.end", )"
          << R"("bend_radius": )" << number(1.05, 4) << R"(, "angle": )" << number(5, 350)
          << R"(, "toward": )" << vector(1)
          << R"(}}, {"name": "b", "pipe": {"from": "e.end", "length": )" << number(.5, 6) << "}}";
  }

  void spline() {
    text_.precision(17);
    text_ << R"({"name": "s", "spline": {"closed": true, "through": [)";
    const int points = 3 + int(random_() % 3);
    for (int i = 0; i < points; ++i) {
      const double angle = 2 * 3.14159265358979 * i / points, reach = number(5, 8);
      text_ << (i == 0 ? "" : ", ") << R"({"point": [)" << reach * std::cos(angle) << ", "
            << reach * std::sin(angle) << ", " << number(-1, 1) << R"(], "radius": )"
            << number(.3, 1) << "}";
    }
    text_ << R"(]}}, {"name": "ball", "sphere": {"center": [0, 0, )" << number(0, 3)
          << R"(], "radius": )" << number(.5, 4) << "}}";
  }

  void cones() {
    text_.precision(17);
    for (int i = 0; i < 3; ++i) {
      text_ << (i == 0 ? "" : ", ") << R"({"name": "c)" << i << R"(", "cone": {"from": )"
            << vector(6) << R"(, "direction": )" << vector(1) << R"(, "length": )" << number(1, 8)
            << R"(, "radii": [)" << number(.1, 2) << ", " << number(.1, 2) << "]}}";
    }
  }

  std::mt19937_64 random_;
  std::ostringstream text_;
};

}  // namespace

void expect_all_verified(std::uint64_t seed, int count) {
  using Clock = std::chrono::steady_clock;
  Documents documents(seed);
  int certified = 0;
  for (int i = 0; i < count; ++i) {
    const std::string document = documents.next();
    const auto before = Clock::now();
    Certificate certificate;
    try {
      certificate = certify(parse_assembly(document, "random.json"));
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == Errc::irregular_surface ||
                  error.code() == Errc::infeasible_blend || error.code() == Errc::invalid_argument)
          << document << error.what();
      continue;
    }
    ++certified;
    const auto then = Clock::now();
    EXPECT_LT(std::chrono::duration<double>(then - before).count(), 10) << document;
    certificate.document_sha256 = sha256(document);
    try {
      const Certificate read = parse_certificate(certificate_json(certificate));
      verify(read);
      require_about(read, document, "random.json");
    } catch (const Error& error) {
      ADD_FAILURE() << i << ": " << error.what() << '\n' << document;
    }
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - then).count(), 10) << document;
  }
  EXPECT_GT(certified, count / 2);
}

}  // namespace dupin::test
