#include <algorithm>

#include "rounding/edited_mesh.h"

namespace dupin::rounding {

bool EditedMesh::degenerate(std::uint32_t face) const { return is_degenerate(embedding(), face); }

bool EditedMesh::bad_pair(std::uint32_t f, std::uint32_t g) const {
  return is_faulty_pair(embedding(), f, g);
}

bool EditedMesh::is_bad(const Fault& item) const {
  if (!alive(item.first) || !alive(item.second)) {
    return false;
  }
  if (item.first == item.second) {
    return degenerate(item.first);
  }
  return !degenerate(item.first) && !degenerate(item.second) && bad_pair(item.first, item.second);
}

/// Of a marked face: those with other marked ones once, from the lower.
void EditedMesh::find_bad_items_of(std::uint32_t face, std::span<const std::uint8_t> marked) {
  if (degenerate(face)) {
    remember({face, face});
    return;
  }
  tree().visit(box(face), framed(face), [&](std::uint32_t other) {
    const bool is_first = face < other || (face != other && marked[other] == 0);
    if (is_first && alive(other) && !degenerate(other) && bad_pair(face, other)) {
      remember({std::min(face, other), std::max(face, other)});
    }
  });
}

void EditedMesh::find_faults(std::span<const std::uint8_t> marked, std::span<const Fault> known) {
  bad_.clear();
  for (const Fault& item : known) {
    if (alive(item.first) && alive(item.second) && marked[item.first] == 0 &&
        marked[item.second] == 0) {
      remember(item);
    }
  }
  if (!complete_.empty()) {  // a part is not closed, which the search in whole meshes relies on
    for (std::uint32_t f = 0; f < face_count(); ++f) {
      if (alive(f) && marked[f] != 0) {
        find_bad_items_of(f, marked);
      }
    }
    return;
  }
  if (std::ranges::find(alive_, 0) == alive_.end()) {
    for (const Fault& item : rounding::find_faults(embedding(), marked)) {
      remember(item);
    }
    return;
  }
  const support::BulkVector<std::uint32_t> faces = alive_faces();
  support::BulkVector<std::uint8_t> marks;
  marks.reserve(faces.size());
  for (const std::uint32_t f : faces) {
    marks.push_back(marked[f]);
  }
  const support::BulkVector<Triangle> triangles = triangles_of(faces);
  for (const Fault& item : rounding::find_faults({points_, triangles, twins_}, marks)) {
    remember({faces[item.first], faces[item.second]});
  }
}

std::vector<Fault> EditedMesh::bad_items() const {
  std::vector<Fault> items;
  for (const auto& [face, partners] : bad_) {
    for (const std::uint32_t partner : partners) {
      if (face <= partner) {
        items.push_back({face, partner});
      }
    }
  }
  std::sort(items.begin(), items.end());
  return items;
}

void EditedMesh::remember(const Fault& item) {
  bad_[item.first].push_back(item.second);
  if (item.first != item.second) {
    bad_[item.second].push_back(item.first);
  }
}

void EditedMesh::forget(const Fault& item) {
  for (const auto& [face, partner] :
       {std::pair(item.first, item.second), std::pair(item.second, item.first)}) {
    const auto entry = bad_.find(face);
    if (entry != bad_.end() && std::erase(entry->second, partner) > 0 && entry->second.empty()) {
      bad_.erase(entry);
    }
  }
}

/// The known bad items that involve one of the faces, ascending.
std::vector<Fault> EditedMesh::known_bad(std::span<const std::uint32_t> faces) const {
  std::vector<Fault> items;
  for (const std::uint32_t f : faces) {
    const auto entry = bad_.find(f);
    if (entry != bad_.end()) {
      for (const std::uint32_t g : entry->second) {
        items.push_back({std::min(f, g), std::max(f, g)});
      }
    }
  }
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  return items;
}

/// Whether an edit of the faces could be accepted at all.
bool EditedMesh::promising(std::span<const std::uint32_t> faces, const EditRule& terms) const {
  return terms.rule == EditRule::Rule::none_bad ||
         std::ranges::any_of(faces, [&](std::uint32_t f) { return bad_.contains(f); });
}

/// Appends bad items among `faces` and between them and `hot`, until there are `limit`.
void EditedMesh::look_nearby(std::span<const std::uint32_t> faces,
                             const std::vector<std::uint32_t>& hot, std::size_t limit,
                             std::vector<Fault>& found) {
  for (std::size_t i = 0; i < faces.size() && found.size() < limit; ++i) {
    const std::uint32_t f = faces[i];
    if (degenerate(f)) {
      found.push_back({f, f});
      continue;
    }
    const auto test = [&](std::uint32_t g) {
      if (found.size() < limit && !degenerate(g) && bad_pair(f, g)) {
        found.push_back({std::min(f, g), std::max(f, g)});
      }
    };
    std::ranges::for_each(hot, test);
    std::ranges::for_each(faces.subspan(i + 1), test);
  }
}

/// Appends bad items between `faces` and all others but `hot`, until there are `limit`.
void EditedMesh::look_everywhere(std::span<const std::uint32_t> faces,
                                 const std::vector<std::uint32_t>& hot, std::size_t limit,
                                 std::vector<Fault>& found) {
  ++searches_;
  for (const std::uint32_t f : faces) {
    stamp_[f] = searches_;
  }
  for (const std::uint32_t f : hot) {
    stamp_[f] = searches_;
  }
  for (const std::uint32_t f : faces) {
    if (degenerate(f)) {
      continue;
    }
    tree().visit(box(f), framed(f), [&](std::uint32_t g) {
      if (found.size() < limit && alive(g) && stamp_[g] != searches_ && !degenerate(g) &&
          bad_pair(f, g)) {
        found.push_back({std::min(f, g), std::max(f, g)});
      }
    });
  }
}

/// Decides on an edit that has been made for trial: the faces `before` have become the faces
/// `after`, a part of them. If accepted, the books are brought up to date.
bool EditedMesh::settle(std::span<const std::uint32_t> before, std::span<const std::uint32_t> after,
                        const EditRule& terms) {
  ++trials_;
  const std::vector<Fault> known = known_bad(before);
  const std::size_t limit = terms.rule == EditRule::Rule::none_bad ? 1 : known.size();
  std::vector<std::uint32_t> hot;  // where a bad edit shows first
  for (const Fault& item : known) {
    for (const std::uint32_t f : {item.first, item.second}) {
      if (alive(f) && std::ranges::find(before, f) == before.end()) {
        hot.push_back(f);
      }
    }
  }
  std::sort(hot.begin(), hot.end());
  hot.erase(std::unique(hot.begin(), hot.end()), hot.end());
  std::vector<Fault> found;
  look_nearby(after, hot, limit, found);
  if (found.size() < limit) {
    look_everywhere(after, hot, limit, found);
  }
  if (found.size() >= limit) {
    return false;
  }
  std::ranges::for_each(known, [&](const Fault& item) { forget(item); });
  std::ranges::for_each(found, [&](const Fault& item) { remember(item); });
  for (const std::uint32_t f : after) {
    tree().grow(f, box(f), framed(f));
  }
  edited_.insert(edited_.end(), after.begin(), after.end());
  return true;
}

}  // namespace dupin::rounding
