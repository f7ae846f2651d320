#include "rounding/edits/fault_tracker.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "checking/self_intersection.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

Fault fault_of(std::uint32_t f, std::uint32_t g) { return {std::min(f, g), std::max(f, g)}; }

/// Appends a fault that is none of the first `count`.
void append_new(const Fault& fault, std::size_t count, std::vector<Fault>& faults) {
  const auto first = std::span(faults).first(count);
  if (std::ranges::find(first, fault) == first.end()) {
    faults.push_back(fault);
  }
}

/// Appends faults of the tested faces with `hot` and among each other that are not there yet, until
/// there are `limit`.
void look_nearby(const Embedding& mesh, std::deque<FaultTest>& tests,
                 const std::vector<std::uint32_t>& hot, std::size_t limit,
                 std::vector<Fault>& found) {
  const std::size_t expected = found.size();
  const auto look_at = [&](FaultTest& test, std::uint32_t g) {
    if (found.size() < limit && !test.is_apart_from(g) && !is_degenerate(mesh, g) &&
        test.is_faulty_with(g)) {
      append_new(fault_of(test.face(), g), expected, found);
    }
  };
  for (FaultTest& test : tests) {
    if (test.is_degenerate()) {
      append_new({test.face(), test.face()}, expected, found);
    } else {
      std::ranges::for_each(hot, [&](std::uint32_t g) { look_at(test, g); });
    }
  }
  // Their pairs are many where many faces meet in a point.
  for (std::size_t i = 0; i < tests.size() && found.size() < limit; ++i) {
    if (!tests[i].is_degenerate()) {
      for (std::size_t k = i + 1; k < tests.size(); ++k) {
        look_at(tests[i], tests[k].face());
      }
    }
  }
}

}  // namespace

bool is_degenerate(const Embedding& mesh, std::uint32_t face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return predicates::collinear(mesh.points[a], mesh.points[b], mesh.points[c]);
}

FaultTest::FaultTest(const Embedding& mesh, std::uint32_t face)
    : mesh_(mesh),
      face_(face),
      corners_{mesh.points[mesh.triangles[face][0]], mesh.points[mesh.triangles[face][1]],
               mesh.points[mesh.triangles[face][2]]},
      test_(corners_, {0, 1, 2}) {}

bool FaultTest::is_faulty_with(std::uint32_t other) {
  const Triangle &mine = mesh_.triangles[face_], &others = mesh_.triangles[other];
  Triangle second = {3, 4, 5};
  bool foreign_contact = false;
  for (std::uint32_t j = 0; j < 3; ++j) {
    const Vec3& corner = corners_[3 + j] = mesh_.points[others[j]];
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (corners_[i] == corner) {
        second[j] = i;
        foreign_contact =
            foreign_contact || mesh_.representatives[mine[i]] != mesh_.representatives[others[j]];
      }
    }
  }
  return foreign_contact || test_.meeting(second) != predicates::TriangleOverlap::none;
}

support::BulkVector<std::uint8_t> marked_faces(std::span<const Triangle> triangles,
                                               std::span<const std::uint8_t> marked_points) {
  support::BulkVector<std::uint8_t> marked(triangles.size());
  support::for_each_block(marked.size(), [&](const support::Block& block) {
    for (std::size_t f = block.begin; f < block.end; ++f) {
      const auto& [a, b, c] = triangles[f];
      marked[f] = marked_points[a] | marked_points[b] | marked_points[c];
    }
  });
  return marked;
}

std::vector<std::uint32_t> faces_of(std::span<const Fault> faults) {
  std::vector<std::uint32_t> faces;
  for (const Fault& fault : faults) {
    faces.push_back(fault.first);
    faces.push_back(fault.second);
  }
  return faces;
}

std::vector<Fault> renumbered(std::vector<Fault> faults, std::span<const std::uint32_t> numbers) {
  for (auto& [first, second] : faults) {
    first = numbers[first];
    second = numbers[second];
  }
  return faults;
}

namespace {

checking::SelfIntersections crossings_of(const Embedding& mesh,
                                         std::span<const std::uint8_t> marked,
                                         const PairFilter& examined, std::size_t enough) {
  if (std::ranges::find(marked, 1) == marked.end()) {
    return {};
  }
  return checking::find_self_intersections(mesh.points, mesh.triangles,
                                           {.active = marked,
                                            .representatives = mesh.representatives,
                                            .contacts = false,
                                            .closed = true,
                                            .groups = mesh.groups,
                                            .examined = examined,
                                            .enough = enough});
}

std::vector<Fault> faults_of(const checking::SelfIntersections& found) {
  std::vector<Fault> faults;
  for (const std::uint32_t face : found.degenerate) {
    faults.push_back({face, face});
  }
  for (const checking::FacePair& pair : found.pairs) {
    faults.push_back({pair.first, pair.second});
  }
  return faults;
}

}  // namespace

std::vector<Fault> find_faults(const Embedding& mesh, std::span<const std::uint8_t> marked,
                               const PairFilter& examined) {
  return faults_of(crossings_of(mesh, marked, examined, std::numeric_limits<std::size_t>::max()));
}

std::optional<std::vector<Fault>> find_faults_below(std::size_t count, const Embedding& mesh,
                                                    std::span<const std::uint8_t> marked) {
  const checking::SelfIntersections found = crossings_of(mesh, marked, {}, count);
  return found.is_cut_short ? std::nullopt : std::optional(faults_of(found));
}

FaultTracker::FaultTracker(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           bool is_part)
    : is_part_(is_part), frame_(points, triangles), stamp_(triangles.size(), 0) {}

boxes::Box FaultTracker::box(const Mesh& mesh, std::uint32_t face) const {
  return frame_.around(framed(mesh, face));
}

boxes::FramedTriangle FaultTracker::framed(const Mesh& mesh, std::uint32_t face) const {
  const auto& [a, b, c] = mesh.embedding.triangles[face];
  const std::span<const Vec3> points = mesh.embedding.points;
  return frame_.map(points[a], points[b], points[c]);
}

boxes::BoxTree& FaultTracker::tree(const Mesh& mesh) {
  if (!tree_) {
    support::BulkVector<boxes::Box> boxes(mesh.alive.size());
    support::for_each_block(boxes.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        boxes[i] =
            mesh.alive[i] != 0 ? box(mesh, static_cast<std::uint32_t>(i)) : boxes::Box::nothing();
      }
    });
    if (is_part_) {  // small enough for oriented boxes to pay off
      tree_.emplace(boxes, [&](std::uint32_t f) { return framed(mesh, f); });
    } else {
      tree_.emplace(boxes);
    }
  }
  return *tree_;
}

bool FaultTracker::is_fault(const Mesh& mesh, const Fault& fault) {
  const auto& [first, second] = fault;
  const Embedding& all = mesh.embedding;
  if (mesh.alive[first] == 0 || mesh.alive[second] == 0) {
    return false;
  }
  if (first == second) {
    return is_degenerate(all, first);
  }
  return !is_degenerate(all, first) && !is_degenerate(all, second) &&
         is_faulty_pair(all, first, second);
}

/// Of a marked face: those with other marked ones once, from the lower.
void FaultTracker::find_of(const Mesh& mesh, std::uint32_t face,
                           std::span<const std::uint8_t> marked) {
  const Embedding& all = mesh.embedding;
  FaultTest test(all, face);
  if (test.is_degenerate()) {
    remember({face, face});
    return;
  }
  const boxes::FramedTriangle triangle = framed(mesh, face);
  const auto look_at = [&](std::uint32_t other, const boxes::Box&) {
    const bool is_first = face < other || (face != other && marked[other] == 0);
    if (is_first && mesh.alive[other] != 0 && !test.is_apart_from(other) &&
        !is_degenerate(all, other) && test.is_faulty_with(other)) {
      remember(fault_of(face, other));
    }
    return false;
  };
  tree(mesh).visit_until(frame_.around(triangle), {&triangle, 1}, look_at);
}

void FaultTracker::find(const Mesh& mesh, std::span<const std::uint8_t> marked,
                        std::span<const Fault> known) {
  const std::span<const std::uint8_t> alive = mesh.alive;
  partners_.clear();
  for (const Fault& fault : known) {
    if (alive[fault.first] != 0 && alive[fault.second] != 0 && marked[fault.first] == 0 &&
        marked[fault.second] == 0) {
      remember(fault);
    }
  }
  if (is_part_) {  // not closed, which the search in whole meshes relies on
    for (std::uint32_t f = 0; f < alive.size(); ++f) {
      if (alive[f] != 0 && marked[f] != 0) {
        find_of(mesh, f, marked);
      }
    }
    return;
  }
  if (std::ranges::find(alive, 0) == alive.end()) {
    add(find_faults(mesh.embedding, marked));
    return;
  }
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < alive.size(); ++f) {
    if (alive[f] != 0) {
      faces.push_back(f);
    }
  }
  const auto marks = support::selected(marked, faces);
  const auto triangles = support::selected(mesh.embedding.triangles, faces);
  const Embedding rest{mesh.embedding.points, triangles, mesh.embedding.representatives};
  add(renumbered(find_faults(rest, marks), faces));
}

std::vector<Fault> FaultTracker::faults() const {
  std::vector<Fault> all;
  for (const auto& [face, partners] : partners_) {
    for (const std::uint32_t partner : partners) {
      if (face <= partner) {
        all.push_back({face, partner});
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

void FaultTracker::remember(const Fault& fault) {
  partners_[fault.first].push_back(fault.second);
  if (fault.first != fault.second) {
    partners_[fault.second].push_back(fault.first);
  }
}

void FaultTracker::forget(const Fault& fault) {
  for (const auto& [face, partner] :
       {std::pair(fault.first, fault.second), std::pair(fault.second, fault.first)}) {
    const auto entry = partners_.find(face);
    if (entry != partners_.end() && std::erase(entry->second, partner) > 0 &&
        entry->second.empty()) {
      partners_.erase(entry);
    }
  }
}

/// The known faults that involve one of the faces, ascending.
std::vector<Fault> FaultTracker::known_of(std::span<const std::uint32_t> faces) const {
  std::vector<Fault> known;
  if (partners_.empty()) {
    return known;
  }
  for (const std::uint32_t f : faces) {
    const auto entry = partners_.find(f);
    if (entry != partners_.end()) {
      std::ranges::transform(entry->second, std::back_inserter(known),
                             [&](std::uint32_t g) { return fault_of(f, g); });
    }
  }
  support::sort_unique(known);
  return known;
}

void FaultTracker::remove(std::span<const std::uint32_t> faces) {
  std::ranges::for_each(known_of(faces), [&](const Fault& fault) { forget(fault); });
}

void FaultTracker::add(std::span<const Fault> faults) {
  std::ranges::for_each(faults, [&](const Fault& fault) { remember(fault); });
}

/// The tree is made here, not when it is first needed: in the midst of a trial it would miss faces
/// that the edit takes away, and those are there again where it is in vain.
bool FaultTracker::may_try(const Mesh& mesh, std::span<const std::uint32_t> faces, FaultRule rule) {
  const bool may = rule == FaultRule::none || std::ranges::any_of(faces, [&](std::uint32_t f) {
                     return partners_.contains(f);
                   });
  if (may) {
    static_cast<void>(tree(mesh));
  }
  return may;
}

/// Appends faults between the tested faces and all others but `hot` that are not there yet, until
/// there are `limit`.
void FaultTracker::look_everywhere(const Mesh& mesh, std::deque<FaultTest>& tests,
                                   const std::vector<std::uint32_t>& hot, std::size_t limit,
                                   std::vector<Fault>& found) {
  const Embedding& all = mesh.embedding;
  const std::size_t expected = found.size();
  ++searches_;
  for (const FaultTest& test : tests) {
    stamp_[test.face()] = searches_;
  }
  for (const std::uint32_t f : hot) {
    stamp_[f] = searches_;
  }
  // They have a point in common: one descent finds what is near any of them.
  std::vector<boxes::FramedTriangle> triangles;
  std::vector<boxes::BoxQuad> boxes;
  boxes::Box around = boxes::Box::nothing();
  constexpr std::size_t kSize = boxes::BoxQuad::kSize;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (i % kSize == 0) {
      boxes.emplace_back();
    }
    if (!tests[i].is_degenerate()) {
      triangles.push_back(framed(mesh, tests[i].face()));
      const boxes::Box box = frame_.around(triangles.back());
      boxes.back().set(i % kSize, box);
      around.join(box);
    }
  }
  if (triangles.empty()) {
    return;
  }
  tree_->visit_until(around, triangles, [&](std::uint32_t g, const boxes::Box& box_of_g) {
    if (mesh.alive[g] == 0 || stamp_[g] == searches_) {
      return false;
    }
    for (std::size_t quad = 0; quad < boxes.size(); ++quad) {
      for (unsigned bits = boxes[quad].overlapping(box_of_g); bits != 0; bits &= bits - 1) {
        FaultTest& test = tests[kSize * quad + static_cast<std::size_t>(std::countr_zero(bits))];
        // Few are left that it is worth asking whether they are degenerate.
        if (!test.is_apart_from(g) && !is_degenerate(all, g) && test.is_faulty_with(g)) {
          append_new(fault_of(test.face(), g), expected, found);
        }
      }
    }
    return found.size() >= limit;
  });
}

/// Faces that are likely to be in faults with the edited ones: those that were, and those that
/// edits before of the same faces were refused for. They make no difference but of time.
std::vector<std::uint32_t> FaultTracker::hot_faces(const Mesh& mesh,
                                                   std::span<const std::uint32_t> before,
                                                   std::span<const Fault> known) {
  const auto append_others = [&](std::span<const Fault> faults, std::vector<std::uint32_t>& faces) {
    for (const Fault& fault : faults) {
      for (const std::uint32_t f : {fault.first, fault.second}) {
        if (std::ranges::find(before, f) == before.end()) {
          faces.push_back(f);
        }
      }
    }
  };
  if (std::ranges::equal(before, tried_)) {
    append_others(found_, suspects_);
    support::sort_unique(suspects_);
  } else {
    tried_.assign(before.begin(), before.end());
    suspects_.clear();
  }
  std::vector<std::uint32_t> hot = suspects_;
  append_others(known, hot);
  std::erase_if(hot, [&](std::uint32_t f) { return mesh.alive[f] == 0; });
  support::sort_unique(hot);
  return hot;
}

/// Finds faults of the tested faces, until there are `limit`, among those that the edit before was
/// refused for, which mostly is one of the same faces, and among the known ones.
void FaultTracker::find_expected(const Mesh& mesh, std::deque<FaultTest>& tests,
                                 std::span<const Fault> known, std::size_t limit) {
  std::vector<Fault> expected = std::move(found_);
  found_.clear();
  for (const Fault& fault : known) {
    append_new(fault, expected.size(), expected);
  }
  const auto test_of = [&](std::uint32_t f) {
    return std::ranges::find(tests, f, &FaultTest::face);
  };
  for (std::size_t i = 0; i < expected.size() && found_.size() < limit; ++i) {
    auto test = test_of(expected[i].first);
    std::uint32_t other = expected[i].second;
    if (test == tests.end()) {
      test = test_of(other);
      other = expected[i].first;
    }
    if (test == tests.end() || mesh.alive[other] == 0) {
      continue;
    }
    const bool is_fault = test->face() == other
                              ? test->is_degenerate()
                              : !test->is_degenerate() && !test->is_apart_from(other) &&
                                    !is_degenerate(mesh.embedding, other) &&
                                    test->is_faulty_with(other);
    if (is_fault) {
      found_.push_back(expected[i]);
    }
  }
}

bool FaultTracker::accept(const Mesh& mesh, std::span<const std::uint32_t> before,
                          std::span<const std::uint32_t> after, FaultRule rule) {
  ++trials_;
  const std::vector<Fault> known = known_of(before);
  const std::size_t limit = rule == FaultRule::none ? 1 : known.size();
  const std::vector<std::uint32_t> hot = hot_faces(mesh, before, known);
  std::deque<FaultTest> tests;
  for (const std::uint32_t f : after) {
    tests.emplace_back(mesh.embedding, f);
  }
  // Only their number counts: so those come first that are likely to be found.
  find_expected(mesh, tests, known, limit);
  if (found_.size() < limit) {
    look_nearby(mesh.embedding, tests, hot, limit, found_);
  }
  if (found_.size() < limit) {
    look_everywhere(mesh, tests, hot, limit, found_);
  }
  if (found_.size() >= limit) {
    return false;
  }
  std::ranges::for_each(known, [&](const Fault& fault) { forget(fault); });
  std::ranges::for_each(found_, [&](const Fault& fault) { remember(fault); });
  for (const std::uint32_t f : after) {
    tree_->grow(f, box(mesh, f), framed(mesh, f));
  }
  return true;
}

}  // namespace dupin::rounding
