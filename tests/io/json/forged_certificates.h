#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
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
/// it ("equal", "throat") and to a thinner one ("through", "throats").
[[nodiscard]] Truth truth(std::mt19937_64& random);

struct Forgery {
  std::string way;
  /// Makes the claim false; the document stays what it was.
  std::function<void(Certificate&, const Truth&, std::mt19937_64&)> tell;
  bool is_about_another = false;  ///< true in itself: only the document shows that it is not meant
};

[[nodiscard]] const std::vector<Forgery>& forgeries();

/// So many forged certificates, way after way; fails for each that is believed or takes 10 s.
void expect_none_believed(std::uint64_t seed, int count);

}  // namespace dupin::test
