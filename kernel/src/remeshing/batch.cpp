#include "remeshing/batch.h"

#include <algorithm>

#include "dupin/kernel/error.h"
#include "support/blocks.h"

namespace dupin::remeshing {
namespace {

std::uint64_t key(const Candidate& candidate) {
  return std::uint64_t{candidate.from} << 32 | candidate.to;
}

}  // namespace

void Pass::refuse(const Candidate& candidate) { refused_.insert(key(candidate)); }

bool Pass::is_refused(const Candidate& candidate) const {
  return refused_.contains(key(candidate));
}

/// Those that do not touch each other, the first ones first.
std::vector<Candidate> Pass::chosen(const EditKind& kind) const {
  std::vector<std::vector<Candidate>> parts(support::block_count(kind.places, 512));
  support::for_each_block(
      kind.places,
      [&](const support::Block& block) {
        for (std::size_t i = block.begin; i < block.end; ++i) {
          kind.collect(static_cast<std::uint32_t>(i), parts[block.number]);
        }
        std::erase_if(parts[block.number], [&](const Candidate& c) { return is_refused(c); });
      },
      512);
  std::vector<Candidate> all = support::joined(std::move(parts));
  std::vector<std::uint32_t> order(all.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return all[i].priority; });
  std::vector<std::uint8_t> point_marks(mesh_.point_count(), 0), face_marks(mesh_.face_count(), 0);
  std::vector<Candidate> taken;
  for (const std::uint32_t i : order) {
    Candidate& candidate = all[i];
    const auto is_marked = [&](std::uint32_t v) { return point_marks[v] != 0; };
    const auto is_edited = [&](std::uint32_t f) { return face_marks[f] != 0; };
    if (std::ranges::any_of(candidate.needs, is_marked) ||
        std::ranges::any_of(candidate.faces, is_edited)) {
      continue;
    }
    for (const std::uint32_t v : candidate.marks) {
      point_marks[v] = 1;
    }
    for (const std::uint32_t f : candidate.faces) {
      face_marks[f] = 1;
    }
    taken.push_back(std::move(candidate));
  }
  return taken;
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
  return undo_faulty(std::move(applied), made);
}

std::size_t Pass::undo_faulty(std::vector<Applied> applied,
                              const std::vector<Candidate>& candidates) {
  std::vector<std::uint32_t> owner(mesh_.face_count(), support::kNone);
  std::vector<std::uint8_t> undone(applied.size(), 0);
  std::size_t left = applied.size();
  for (std::uint32_t i = 0; i < applied.size(); ++i) {
    for (const std::uint32_t f : applied[i].after) {
      owner[f] = i;
    }
  }
  while (left > 0) {
    std::vector<std::uint32_t> marked;
    for (std::size_t i = 0; i < applied.size(); ++i) {
      if (undone[i] == 0) {
        marked.insert(marked.end(), applied[i].after.begin(), applied[i].after.end());
      }
    }
    std::size_t now = 0;
    const std::vector<std::uint32_t> faults = mesh_.faulty(marked);
    for (const std::uint32_t f : faults) {
      const std::uint32_t i = owner[f];
      if (i != support::kNone && undone[i] == 0) {
        mesh_.undo(applied[i]);
        undone[i] = 1;
        refuse(candidates[i]);
        --left;
        ++now;
      }
    }
    if (faults.empty()) {
      break;
    }
    if (now == 0) {
      throw Error(Errc::internal,
                  "internal error, please report it: remeshing met a fault that no edit has made");
    }
  }
  return left;
}

}  // namespace dupin::remeshing
