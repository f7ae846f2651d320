#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dupin/io/processes.h"
#include "dupin/kernel/districts.h"
#include "tiles/district_result.h"

namespace dupin::cli {

/// What --memory leaves to each district of a tile. How much its crossings need is known when they
/// are found: one that needs more than the others of its tile leave has to be alone in one.
class TileMemory {
 public:
  TileMemory() = default;  ///< as much as there is
  /// Of so many bytes in all, the districts are expected to need these. Messages name the source,
  /// and a remedy besides more memory.
  TileMemory(std::uint64_t all, std::vector<double> bytes, std::string source,
             const std::string& remedy = {});

  /// For each district: all of it for one that has to be alone.
  [[nodiscard]] std::span<const double> bytes() const { return bytes_; }
  /// Given behind which districts tiles end.
  void divide(std::span<const std::size_t> ends);
  /// What is made of a district in these boxes within so many bytes, or as many as there are for 0.
  /// Nothing where it has to be alone. Threads may make several at a time.
  [[nodiscard]] std::optional<DistrictResult> within(
      std::size_t district, const Boxes& boxes,
      const std::function<DistrictResult(std::uint64_t)>& make);
  /// Whether some have to be alone that were not: tiles have to be divided again. All processes
  /// call it, given which make what, at the end of an attempt.
  [[nodiscard]] bool is_short(const Processes& processes, std::span<const std::size_t> owners);
  /// What comes of the first attempt that was not short; `divide` before each other one.
  template <class Attempt, class Divide>
  [[nodiscard]] auto until_enough(const Attempt& attempt, const Divide& divide) {
    while (true) {
      auto made = attempt();
      if (!was_short_) {
        return made;
      }
      divide();
    }
  }

 private:
  double all_ = 0;
  std::vector<double> bytes_;
  std::vector<double> limits_;
  std::vector<std::uint8_t> is_short_;  // per district
  bool was_short_ = false;              // the last attempt
  std::string source_, remedy_;
};

}  // namespace dupin::cli
