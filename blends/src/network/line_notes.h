#pragma once

#include <string>
#include <vector>

#include "dupin/blends/piping_line.h"
#include "dupin/kernel/error.h"

namespace dupin::network {

/// What is said of a line's components while it is made into an assembly.
class LineNotes {
 public:
  LineNotes(std::string source, bool keep_going)
      : source_(std::move(source)), keep_going_(keep_going) {}

  void add(const PipingComponent& component, const std::string& text) {
    notes_.push_back({component.line, component.name + ": " + text, false});
  }

  /// Throws an Error unless told to keep going.
  void refuse(const PipingComponent& component, const std::string& text,
              Errc code = Errc::invalid_argument);

  /// By line.
  [[nodiscard]] std::vector<SourceNote> take() &&;

 private:
  std::string source_;
  bool keep_going_;
  std::vector<SourceNote> notes_;
};

}  // namespace dupin::network
