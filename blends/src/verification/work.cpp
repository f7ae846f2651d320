#include "verification/work.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin::verification {
namespace {

thread_local WorkLimit* current = nullptr;

}  // namespace

WorkLimit::WorkLimit(std::uint64_t units) : left_(units), least_(units), outer_(current) {
  current = this;
}

WorkLimit::~WorkLimit() { current = outer_; }

std::uint64_t WorkLimit::left() const { return left_; }

void WorkLimit::set_left(std::uint64_t units) { left_ = units; }

std::uint64_t WorkLimit::least() const { return least_; }

void WorkLimit::set_least(std::uint64_t units) { least_ = units; }

std::uint64_t work_for(const std::vector<DiscPairs>& leaves) {
  constexpr std::uint64_t kNumbers = 6;  // of two stretches; arms at hubs take more looks
  return CertificateLimits::kWorkPerNumber * kNumbers * leaves.size();
}

std::uint64_t work_for(const RegularClaim& claim) {
  return CertificateLimits::kWorkPerNumber * 2 * claim.leaves.size();
}

std::uint64_t work_for(const MeshClaim& claim) {
  const std::size_t knees = claim.kneecaps ? claim.kneecaps->segments.size() : 0;
  return CertificateLimits::kWorkPerNumber *
         (claim.knots.size() + claim.inner_knots.size() + knees);
}

std::uint64_t work_for_loop() {
  constexpr std::uint64_t kNumbersOfLoop = 160;
  return CertificateLimits::kWorkPerNumber * kNumbersOfLoop;
}

// One look at the arcs of a leaf is all that the other claims take, too.
std::uint64_t work_for_arcs(const RegularClaim& claim) {
  constexpr std::uint64_t kNumbersOfLeaf = 6;
  return CertificateLimits::kWorkPerNumber * kNumbersOfLeaf * claim.leaves.size();
}

std::uint64_t work_for_boxes(std::size_t parts) {
  constexpr std::uint64_t kNumbersOfBox = 6;
  return CertificateLimits::kWorkPerNumber * kNumbersOfBox * parts;
}

std::uint64_t work_for(const CertifiedPart& part, const PartClaims& claims) {
  constexpr std::uint64_t kNumbersOfPiece =
      64;  // two rings, a spine and a radius; four bounds, of which the ends are looked at exactly
  constexpr std::uint64_t kNumbersOfTurn = 64;  // looks at a spine, from end to end
  const auto* chain = std::get_if<Chain>(&part.shape);
  std::uint64_t numbers = 0;
  for (const dupin::Piece& piece : chain != nullptr ? chain->pieces : std::vector<dupin::Piece>()) {
    numbers += kNumbersOfPiece + (std::holds_alternative<EllipticTube>(piece) ? kNumbersOfTurn : 0);
  }
  return CertificateLimits::kWorkPerNumber * numbers +
         (claims.regular ? work_for(*claims.regular) : 0) +
         (claims.embedded ? work_for(claims.embedded->leaves) : 0) +
         (claims.mesh ? work_for(*claims.mesh) : 0);
}

std::uint64_t work_for(const Certificate& certificate) {
  std::uint64_t units = CertificateLimits::kWork;
  for (std::size_t i = 0; i < std::min(certificate.parts.size(), certificate.claims.size()); ++i) {
    units += work_for(certificate.parts[i], certificate.claims[i]);
  }
  for (std::size_t i = 0;
       i < std::min(certificate.fillets.size(), certificate.fillet_claims.size()); ++i) {
    const auto& loops = certificate.fillets[i].loops;
    const auto& claims = certificate.fillet_claims[i];
    for (std::size_t k = 0; k < std::min(loops.size(), claims.size()); ++k) {
      units += work_for_loop() + work_for_arcs(claims[k].regular) +
               work_for(claims[k].embedded.leaves) +
               (claims[k].mesh ? work_for(*claims[k].mesh) : 0);
    }
  }
  if (certificate.apart > 0) {
    std::size_t loops = 0;
    for (const CertifiedFillet& fillet : certificate.fillets) {
      loops += fillet.loops.size();
    }
    units += work_for_boxes(certificate.parts.size());
    units += loops > 0 ? work_for_boxes(certificate.parts.size() + loops) : 0;
  }
  for (const auto* clearances : {&certificate.clearances, &certificate.fillet_clearances}) {
    for (const ClearanceClaim& claim : *clearances) {
      units += work_for(claim.leaves);
    }
  }
  return units;
}

void spend(std::uint64_t units) {
  if (current == nullptr) {
    return;
  }
  if (units > current->left_) {
    throw Error(Errc::limit_exceeded, "the claims take more work than their length allows", {},
                "certificate");
  }
  current->left_ -= units;
  current->least_ = std::min(current->least_, current->left_);
}

namespace {

// What a block of indices came to, with no more work than there was for all.
struct Block {
  bool holds;
  std::uint64_t spent;
};

std::uint64_t left_for_all() {
  return current != nullptr ? current->left() : std::numeric_limits<std::uint64_t>::max();
}

}  // namespace

// Blocks are taken in order, so that those which are left out stand behind one that failed or
// threw, or behind more work than there is. One that threw is asked again in its turn, if that
// comes.
bool holds_of_all(std::size_t count, const std::function<bool(std::size_t)>& check) {
  constexpr std::size_t kMostOfBlock = 16, kBlocks = 64;
  const std::size_t of_block = std::clamp<std::size_t>(count / kBlocks, 1, kMostOfBlock);
  const auto holds_in_turn = [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * of_block, count);
    std::size_t i = block * of_block;
    while (i < end && check(i)) {
      ++i;
    }
    return i == end;
  };
  const std::uint64_t left = left_for_all();
  std::vector<std::optional<Block>> blocks((count + of_block - 1) / of_block);
  std::atomic<std::size_t> next = 0, first_failed = blocks.size();
  std::atomic<std::uint64_t> spent = 0;
  for_each_in_parallel(blocks.size(), [&](std::size_t) {
    const std::size_t block = next++;
    if (block > first_failed || spent > left) {
      return;
    }
    const WorkLimit limit(left);
    bool holds = false;
    try {
      holds = holds_in_turn(block);
      blocks[block] = {holds, left - limit.left()};
      spent += left - limit.left();
    } catch (const Error&) {
      holds = false;
    }
    for (std::size_t failed = first_failed; !holds && block < failed;) {
      first_failed.compare_exchange_weak(failed, block);
    }
  });
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const bool counts = blocks[block] && blocks[block]->spent <= left_for_all();
    if (counts) {
      spend(blocks[block]->spent);
    }
    if (!(counts ? blocks[block]->holds : holds_in_turn(block))) {
      return false;
    }
  }
  return true;
}

}  // namespace dupin::verification
