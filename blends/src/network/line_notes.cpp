#include "network/line_notes.h"

#include <algorithm>
#include <utility>

namespace dupin::network {

void LineNotes::refuse(const PipingComponent& component, const std::string& text, Errc code) {
  if (!keep_going_) {
    throw Error(code, text + "; --keep-going leaves it out", component.name,
                source_ + ":" + std::to_string(component.line));
  }
  notes_.push_back({component.line, component.name + ": left out, as " + text, true});
}

std::vector<SourceNote> LineNotes::take() && {
  std::ranges::stable_sort(notes_, {}, &SourceNote::line);
  return std::move(notes_);
}

}  // namespace dupin::network
