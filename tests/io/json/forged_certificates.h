#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "dupin/blends/certificate.h"

// Certificates with a claim that is known to be false, sealed again: the parts are so simple that
// everybody knows how far apart they are, how tightly they bend and whether they cross themselves.
namespace dupin::test {

/// What an honest certificate is forged from, and what is true of it.
struct Truth {
  std::string document;
  Certificate honest;
  double bend_margin = 0;  ///< of the elbow: 1 - r/R
};

/// Documents of a seed: crossing pipes ("a", "b") and a ball over the first ("ball"), an elbow with
/// a pipe joined to it ("elbow", "on"), an elliptic pipe ("oval"), a loop that crosses itself
/// ("loop"), each far from the others; and a pipe ("run") with fillets to an equal one that ends in
/// it ("equal", "throat") and to a thinner one ("through", "throats"); a hollow bend ("shell"), and
/// a right angle of pipes of radius 1 with a kneecap at [0, 600, 0] ("arm"), beside which is a ball
/// ("dot"), and a pipe joined to its end ("wrist").
[[nodiscard]] Truth truth(std::mt19937_64& random);

struct Forgery {
  std::string way;
  /// Makes the claim false; the document stays what it was.
  std::function<void(Certificate&, const Truth&, std::mt19937_64&)> tell;
  bool is_about_another = false;  ///< true in itself: only the document shows that it is not meant
};

[[nodiscard]] const std::vector<Forgery>& forgeries();
/// Those of them that are about chains: "shell", "arm" and what is at it.
[[nodiscard]] std::vector<Forgery> forgeries_of_chains();

/// So many forged certificates, way after way; fails for each that is believed or takes 10 s.
void expect_none_believed(std::uint64_t seed, int count);

// Where forgers put their numbers, and what numbers and leaves they think of.

using Random = std::mt19937_64;

inline double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline std::uint32_t part(const Certificate& c, const std::string& name) {
  const auto found =
      std::find_if(c.parts.begin(), c.parts.end(), [&](const auto& p) { return p.name == name; });
  return std::uint32_t(found - c.parts.begin());
}

inline PartClaims& claims(Certificate& c, const std::string& name) {
  return c.claims.at(part(c, name));
}

inline Chain& chain(Certificate& c, const std::string& name) {
  return std::get<Chain>(c.parts.at(part(c, name)).shape);
}

inline ClearanceClaim& pair(Certificate& c, const std::string& a, const std::string& b) {
  return *std::find_if(c.clearances.begin(), c.clearances.end(), [&](const auto& claim) {
    return c.parts[claim.first].name == a && c.parts[claim.second].name == b;
  });
}

// Any number that a forger may think of.
inline double hostile(Random& random) {
  constexpr double kNumbers[] = {0,      -0.0,   1,     -1,      5e-324, -5e-324, 1e-308, 2.3e-308,
                                 1e-160, -1e160, 1e160, 1.7e308, -1e308, 0x1p300, 1e-15,  3};
  return kNumbers[random() % std::size(kNumbers)];
}

inline Vec3 any_direction(Random& random) {
  if (random() % 4 == 0) {
    return {hostile(random), hostile(random), hostile(random)};
  }
  return std::ldexp(1, int(random() % 600) - 300) *
         Vec3(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
}

// Leaves that cover all pairs, with directions of any kind, or none.
inline std::vector<DiscPairs> any_leaves(Random& random, double first, double second,
                                         bool ordered) {
  const int cuts = 1 << random() % 5;
  std::vector<DiscPairs> leaves;
  for (int i = 0; i < int(first) * cuts; ++i) {
    for (int j = ordered ? i : 0; j < int(second) * cuts; ++j) {
      DiscPairs leaf{
          {double(i) / cuts, double(i + 1) / cuts}, {double(j) / cuts, double(j + 1) / cuts}, {}};
      if (random() % 3 != 0) {
        leaf.direction = any_direction(random);
      }
      leaves.push_back(leaf);
    }
  }
  return leaves;
}

inline double length(const CertifiedPart& p) {
  const auto* its = std::get_if<Chain>(&p.shape);
  return its != nullptr ? double(its->pieces.size()) : 1;
}

inline void separate(Certificate& c, ClearanceClaim& claim, double distance, Random& random) {
  claim.verdict = Verdict::proved;
  claim.overlap.reset();
  claim.distance = distance;
  claim.leaves =
      any_leaves(random, length(c.parts[claim.first]), length(c.parts[claim.second]), false);
}

}  // namespace dupin::test
