#include "remeshing/batch.h"

#include <algorithm>

#include "dupin/kernel/error.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::remeshing {
namespace {

/// Faults are looked for so often in a round; then all that is left of it is taken back.
constexpr int kMostLooks = 6;

std::uint64_t key(const Candidate& candidate) {
  return std::uint64_t{candidate.from} << 32 | candidate.to;
}

}  // namespace

void Pass::refuse(const Candidate& candidate) { refused_.insert(key(candidate)); }

bool Pass::is_refused(const Candidate& candidate) const {
  return refused_.contains(key(candidate));
}

/// Those that do not touch each other, the first ones first.
std::vector<Candidate> Pass::chosen(const EditKind& kind) {
  const std::size_t all_places = kind.is_at_points ? mesh_.point_count() : mesh_.face_count();
  const std::size_t count = places_ ? places_->size() : all_places;
  struct Found {
    Candidate candidate;
    std::uint32_t place;
  };
  std::vector<std::vector<Found>> parts(support::block_count(count, 512));
  support::for_each_block(
      count,
      [&](const support::Block& block) {
        std::vector<Candidate> here;
        for (std::size_t i = block.begin; i < block.end; ++i) {
          const std::uint32_t place = places_ ? (*places_)[i] : static_cast<std::uint32_t>(i);
          here.clear();
          kind.collect(place, here);
          for (const Candidate& candidate : here) {
            if (!is_refused(candidate)) {
              parts[block.number].push_back({candidate, place});
            }
          }
        }
      },
      512);
  std::vector<Found> all = support::joined(std::move(parts));
  std::ranges::stable_sort(all, {}, [](const Found& found) { return found.candidate.priority; });
  std::vector<std::uint8_t> point_marks(mesh_.point_count(), 0), face_marks(mesh_.face_count(), 0);
  std::vector<Candidate> taken;
  blocked_.clear();
  for (const auto& [candidate, place] : all) {
    const Claim claim = kind.claim(candidate);
    if (std::ranges::any_of(claim.needs, [&](std::uint32_t v) { return point_marks[v] != 0; }) ||
        std::ranges::any_of(claim.faces, [&](std::uint32_t f) { return face_marks[f] != 0; })) {
      blocked_.push_back(place);
      continue;
    }
    for (const std::uint32_t v : claim.marks) {
      point_marks[v] = 1;
    }
    for (const std::uint32_t f : claim.faces) {
      face_marks[f] = 1;
    }
    taken.push_back(candidate);
  }
  return taken;
}

void Pass::look_again_at(const EditKind& kind, const std::vector<Applied>& applied) {
  std::vector<std::uint32_t> places = std::move(blocked_);
  for (std::size_t i = 0; !kind.is_at_points && i < applied.size(); ++i) {
    for (const std::uint32_t f : applied[i].after) {
      for (const std::uint32_t v : mesh_.face(f).corners) {
        const auto around = mesh_.around(v);
        places.insert(places.end(), around.begin(), around.end());
      }
    }
  }
  support::sort_unique(places);
  places_ = std::move(places);
}

std::size_t Pass::round(const EditKind& kind) {
  const std::vector<Candidate> candidates = chosen(kind);
  std::vector<std::optional<Edit>> edits(candidates.size());
  support::for_each_block(
      candidates.size(),
      [&](const support::Block& block) {
        for (std::size_t i = block.begin; i < block.end; ++i) {
          edits[i] = kind.build(candidates[i]);
        }
      },
      128);
  std::vector<Applied> applied;
  std::vector<Candidate> made;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (edits[i]) {
      applied.push_back(mesh_.apply(*edits[i]));
      made.push_back(candidates[i]);
    } else {
      refuse(candidates[i]);
    }
  }
  const std::size_t left = undo_faulty(applied, made);
  look_again_at(kind, applied);
  return left;
}

std::size_t Pass::undo_faulty(const std::vector<Applied>& applied,
                              const std::vector<Candidate>& candidates) {
  std::vector<std::uint32_t> owner(mesh_.face_count(), support::kNone);
  std::vector<std::uint8_t> undone(applied.size(), 0);
  std::size_t left = applied.size();
  for (std::uint32_t i = 0; i < applied.size(); ++i) {
    for (const std::uint32_t f : applied[i].after) {
      owner[f] = i;
    }
  }
  const auto undo = [&](std::uint32_t i) {
    mesh_.undo(applied[i]);
    undone[i] = 1;
    refuse(candidates[i]);
    --left;
  };
  for (int looks = 0; left > 0; ++looks) {
    std::vector<std::uint32_t> marked;
    for (std::size_t i = 0; i < applied.size(); ++i) {
      if (undone[i] == 0) {
        marked.insert(marked.end(), applied[i].after.begin(), applied[i].after.end());
      }
    }
    const std::size_t before = left;
    const std::vector<std::uint32_t> faults = mesh_.faulty(marked);
    if (faults.empty()) {
      break;
    }
    for (const std::uint32_t f : faults) {
      if (const std::uint32_t i = owner[f]; i != support::kNone && undone[i] == 0) {
        undo(i);
      }
    }
    for (std::uint32_t i = 0; looks == kMostLooks && i < applied.size(); ++i) {
      if (undone[i] == 0) {
        undo(i);
      }
    }
    if (left == before) {
      throw Error(Errc::internal,
                  "internal error, please report it: remeshing met a fault that no edit has made");
    }
  }
  return left;
}

}  // namespace dupin::remeshing
