#include "verification/work.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

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

namespace {

[[noreturn]] void refuse_work() {
  throw Error(Errc::limit_exceeded, "the claims take more work than their length allows", {},
              "certificate");
}

void take(std::uint64_t units) {
  if (current == nullptr) {
    return;
  }
  if (units > current->left()) {
    refuse_work();
  }
  current->set_left(current->left() - units);
  current->set_least(std::min(current->least(), current->left()));
}

// What all threads have spent on blocks that were not in their turn yet, within one call of
// holds_of_all and those that it leads to.
struct Ahead {
  std::uint64_t most;
  std::atomic<std::uint64_t> spent = 0;
};

// What a block came to. It is taken over in its turn.
struct Block {
  bool holds = false;
  std::exception_ptr thrown;
  std::uint64_t spent = 0;
};

class Blocks {
 public:
  Blocks(std::size_t count, Ahead* ahead)
      : ahead_(ahead), found_(count), first_failed_(count), done_(count) {}

  [[nodiscard]] std::size_t count() const { return found_.size(); }
  [[nodiscard]] Ahead* ahead() const { return ahead_; }
  [[nodiscard]] const std::optional<Block>& found(std::size_t block) const { return found_[block]; }

  // In order.
  [[nodiscard]] std::size_t begun() { return next_++; }

  void end(std::size_t block, Block found) {
    for (std::size_t failed = first_failed_; !found.holds && block < failed;) {
      first_failed_.compare_exchange_weak(failed, block);
    }
    found_[block] = std::move(found);
    done_[block] = true;
  }

  // By all before one that has not ended; none while it does not have its turn.
  [[nodiscard]] std::optional<std::uint64_t> spent_before(std::size_t block) {
    const std::lock_guard lock(looking_);
    for (; open_ < block && done_[open_]; ++open_) {
      spent_before_open_ += found_[open_]->spent;
    }
    return open_ == block ? std::optional(spent_before_open_) : std::nullopt;
  }
  // Whether it is of no use, as one before it does not hold.
  [[nodiscard]] bool is_behind_failed(std::size_t block) const { return block > first_failed_; }

 private:
  Ahead* ahead_;
  std::vector<std::optional<Block>> found_;
  std::atomic<std::size_t> next_ = 0, first_failed_;
  std::vector<std::atomic<bool>> done_;
  std::mutex looking_;
  std::size_t open_ = 0;
  std::uint64_t spent_before_open_ = 0;
};

// The block that this thread is at, and those of the calls around it.
struct Turn {
  Blocks* blocks;
  std::size_t block;
  std::uint64_t left;  // to begin with
  const WorkLimit& limit;
  const Turn* around;
  std::uint64_t unsaid = 0;  // of what it has spent
};

thread_local Turn* turn = nullptr;
thread_local bool is_alone = false;  // what this thread is at is not shared

template <class Value>
class During {
 public:
  During(Value& variable, Value value) : variable_(variable), before_(variable) {
    variable = value;
  }
  ~During() { variable_ = before_; }
  During(const During&) = delete;
  During& operator=(const During&) = delete;

 private:
  Value& variable_;
  Value before_;
};

bool is_of_no_use(const Turn* at) {
  while (at != nullptr && !at->blocks->is_behind_failed(at->block)) {
    at = at->around;
  }
  return at != nullptr;
}

// What blocks are left by that are asked again in their turn, if that comes.
struct Stopped {};

// What is spent ahead comes to no more than there is: from there on only what has its turn goes on,
// until one thread would have run out.
void stop_where_too_much(const Turn& first) {
  const Ahead& ahead = *first.blocks->ahead();
  if (is_of_no_use(&first)) {
    throw Stopped{};
  }
  if (ahead.spent <= ahead.most) {
    return;
  }
  std::uint64_t spent = 0;
  for (const Turn* at = &first; at != nullptr; at = at->around) {
    const auto before = at->blocks->spent_before(at->block);
    if (!before) {
      throw Stopped{};
    }
    spent += at->left - at->limit.left() + *before;
    if (spent > at->left) {
      refuse_work();
    }
  }
}

void say_spent(Turn& at) { at.blocks->ahead()->spent += std::exchange(at.unsaid, 0); }

}  // namespace

void spend(std::uint64_t units) {
  constexpr std::uint64_t kUnsaid = 1 << 10;
  take(units);
  if (turn == nullptr || current != &turn->limit) {
    return;
  }
  turn->unsaid += units;
  if (turn->unsaid > kUnsaid) {
    say_spent(*turn);
    stop_where_too_much(*turn);
  }
}

namespace {

std::uint64_t left_for_all() {
  return current != nullptr ? current->left() : std::numeric_limits<std::uint64_t>::max();
}

template <class Holds>
void look_ahead(Blocks& blocks, const Turn* around, std::uint64_t left, const Holds& holds) {
  const std::size_t block = blocks.begun();
  const WorkLimit limit(left);
  Turn own{&blocks, block, left, limit, around};
  const During at(turn, &own);
  Block found;
  try {
    stop_where_too_much(own);
    found.holds = holds(block);
  } catch (const Stopped&) {
    return;
  } catch (...) {
    found.thrown = std::current_exception();
  }
  say_spent(own);
  found.spent = left - limit.left();
  blocks.end(block, std::move(found));
}

template <class Holds>
bool holds_in_turn(const Blocks& blocks, std::size_t block, const Holds& holds) {
  const std::optional<Block>& found = blocks.found(block);
  if (!found) {
    const During alone(is_alone, true);
    return holds(block);
  }
  take(found->spent);
  if (found->thrown) {
    std::rethrow_exception(found->thrown);
  }
  return found->holds;
}

}  // namespace

// A block that spent more than is left in its turn would have run out of it then.
bool holds_of_all(std::size_t count, const std::function<bool(std::size_t)>& check) {
  constexpr std::size_t kMostOfBlock = 16, kBlocks = 64;
  const std::size_t of_block = is_alone ? std::max<std::size_t>(count, 1)
                                        : std::clamp<std::size_t>(count / kBlocks, 1, kMostOfBlock);
  const auto holds = [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * of_block, count);
    std::size_t i = block * of_block;
    while (i < end && check(i)) {
      ++i;
    }
    return i == end;
  };
  const std::size_t block_count = (count + of_block - 1) / of_block;
  if (block_count <= 1) {
    return block_count == 0 || holds(0);
  }
  const std::uint64_t left = left_for_all();
  Ahead own{left};
  Blocks blocks(block_count, turn != nullptr ? turn->blocks->ahead() : &own);
  const Turn* const around = turn;
  for_each_in_parallel(blocks.count(),
                       [&](std::size_t) { look_ahead(blocks, around, left, holds); });
  for (std::size_t block = 0; block < blocks.count(); ++block) {
    if (!holds_in_turn(blocks, block, holds)) {
      return false;
    }
  }
  return true;
}

}  // namespace dupin::verification
