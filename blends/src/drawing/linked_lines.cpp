#include "drawing/linked_lines.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace dupin::drawing {
namespace {

using Line = std::vector<Vec3>;

class Linker {
 public:
  explicit Linker(std::vector<Line> lines) : lines_(std::move(lines)), used_(lines_.size()) {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      at_[key(lines_[i].front())].push_back(i);
      at_[key(lines_[i].back())].push_back(i);
    }
  }

  std::vector<Line> run() {
    std::vector<Line> result;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!used_[i]) {
        used_[i] = true;
        Line line = std::move(lines_[i]);
        extend(line, i);
        std::ranges::reverse(line);
        extend(line, i);
        result.push_back(std::move(line));
      }
    }
    return result;
  }

 private:
  using Key = std::array<double, 3>;
  static Key key(const Vec3& point) { return {point[0], point[1], point[2]}; }

  void extend(Line& line, std::size_t last) {
    while (const auto next = other_at(line.back(), last)) {
      Line& more = lines_[*next];
      used_[*next] = true;
      if (key(more.front()) != key(line.back())) {
        std::ranges::reverse(more);
      }
      line.insert(line.end(), more.begin() + 1, more.end());
      last = *next;
    }
  }

  [[nodiscard]] std::optional<std::size_t> other_at(const Vec3& point, std::size_t own) const {
    const std::vector<std::size_t>& all = at_.at(key(point));
    if (all.size() != 2) {
      return std::nullopt;
    }
    const std::size_t other = all[0] == own ? all[1] : all[0];
    return used_[other] ? std::nullopt : std::optional(other);
  }

  std::vector<Line> lines_;
  std::vector<bool> used_;
  std::map<Key, std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<Line> linked(std::vector<Line> lines) { return Linker(std::move(lines)).run(); }

}  // namespace dupin::drawing
