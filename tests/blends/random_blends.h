#pragma once

#include <cstdint>
#include <iostream>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/single_piece.h"

namespace dupin::test {

/// The blends of a seed between two pipes, with end speeds as they come: many fold or come back.
class RandomBlends {
 public:
  explicit RandomBlends(std::uint64_t seed) : random_(seed) {}

  Assembly next() {
    const Place start{Vec3::Zero(), Vec3::UnitX(), radius_(random_)};
    const double flat = random_() % 2 == 0 ? 1 : 0.05;  // half of them are nearly plane
    const Place end{Vec3(at_(random_), at_(random_), flat * at_(random_)),
                    Vec3(at_(random_), at_(random_), flat * at_(random_)), radius_(random_)};
    CyclicBlendOptions options;
    options.k = speed_(random_);
    options.l = speed_(random_);
    options.margin = 0;
    options.radius_law = random_() % 2 == 0 ? BlendLaw::r1 : BlendLaw::r2;
    return {"",
            Unit::millimetre,
            0.05,
            {},
            {{"a", PipeAlong{start, 4}},
             {"b", PipeAlong{end, 4}},
             {"blend", CyclicBlendBetween{{"a", End::end}, {"b", End::start}, options}}}};
  }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> at_{-8, 8}, radius_{0.2, 1.5}, speed_{2, 70};
};

/// Whether the blend's tube, finely meshed, meets itself: exactly decided on the mesh.
inline bool meets_itself(const Certificate& certificate) {
  const auto& blend = test::single_piece<RingedSurface>(certificate.parts[2].shape);
  const Tessellation mesh = tessellate(blend, {48, 0, 0}, {0.02});
  return check(mesh.mesh, {.limit = 1}).count(Defect::self_intersection) > 0;
}

/// Certifies and meshes so many blends that do not fold; what the prover says must agree.
inline void compare_prover_and_mesh(std::uint64_t seed, int blends) {
  RandomBlends random(seed);
  int proved = 0, refuted = 0, undecided = 0, crossing = 0;
  for (int i = 0; i < blends;) {
    std::optional<Certificate> certificate;
    try {
      certificate = certify(random.next(), {.margin = {}, .boxes = 1 << 10});
    } catch (const Error& error) {
      ASSERT_TRUE(error.code() == Errc::irregular_surface || error.code() == Errc::invalid_argument)
          << error.what();
      continue;
    }
    ++i;
    const bool meets = meets_itself(*certificate);
    crossing += meets ? 1 : 0;
    const Verdict verdict = certificate->claims[2].embedded->verdict;
    (verdict == Verdict::proved ? proved : verdict == Verdict::refuted ? refuted : undecided) += 1;
    EXPECT_FALSE(meets && verdict == Verdict::proved) << "blend " << i;
    if (i % 20 == 0) {
      EXPECT_NO_THROW(verify(*certificate)) << "blend " << i;
    }
  }
  std::cout << proved << " proved, " << refuted << " refuted, " << undecided << " undecided, "
            << crossing << " meet themselves\n";
  EXPECT_GT(proved, blends / 2);
  EXPECT_GT(crossing, 0);
  EXPECT_GE(refuted, crossing / 2);
}

}  // namespace dupin::test
