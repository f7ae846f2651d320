#include "rounding/edits/small_shells.h"

#include <set>

namespace dupin::rounding {

std::size_t remove_small_shells(EditedMesh& mesh, const std::vector<std::uint32_t>& faces,
                                double reach) {
  std::size_t removed = 0;
  std::set<std::uint32_t> seen;  // faces of shells that have been looked at
  for (const std::uint32_t first : faces) {
    if (!mesh.alive(first) || seen.contains(first)) {
      continue;
    }
    const Vec3 centre = mesh.point(mesh.triangle(first)[0]);
    std::vector<std::uint32_t> shell = {first};
    std::set<std::uint32_t> in_shell = {first};
    bool small = true;
    for (std::size_t i = 0; small && i < shell.size(); ++i) {
      for (const std::uint32_t v : mesh.triangle(shell[i])) {
        small = small && (mesh.point(v) - centre).norm() <= reach;
        for (const std::uint32_t f : mesh.faces(v)) {
          if (in_shell.insert(f).second) {
            shell.push_back(f);
          }
        }
      }
    }
    seen.insert(in_shell.begin(), in_shell.end());
    if (small) {
      mesh.remove(shell);
      ++removed;
    }
  }
  return removed;
}

}  // namespace dupin::rounding
