#include "tiles/tile_memory.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "ranks.h"

namespace dupin::cli {

TileMemory::TileMemory(std::uint64_t all, std::vector<double> bytes, std::string source,
                       const std::string& remedy)
    : all_(static_cast<double>(all)),
      bytes_(std::move(bytes)),
      is_short_(bytes_.size(), 0),
      source_(std::move(source)),
      remedy_("; give --memory more" + remedy) {}

void TileMemory::divide(std::span<const std::size_t> ends) {
  limits_.clear();
  for (const std::size_t end : bytes_.empty() ? std::span<const std::size_t>() : ends) {
    const auto own = bytes().subspan(limits_.size(), end - limits_.size());
    const double expected = std::accumulate(own.begin(), own.end(), 0.0);
    for (const double one : own) {
      limits_.push_back(std::max(1.0, all_ - (expected - one)));
    }
  }
}

std::optional<DistrictResult> TileMemory::within(
    std::size_t district, const Boxes& boxes,
    const std::function<DistrictResult(std::uint64_t)>& make) {
  if (limits_.empty()) {
    return make(0);
  }
  try {
    return make(static_cast<std::uint64_t>(limits_[district]));
  } catch (const Error& error) {
    // Other limits are those of a part, which the error names.
    if (error.code() != Errc::limit_exceeded || !error.part().empty()) {
      throw;
    }
    if (limits_[district] < all_) {
      is_short_[district] = 1;
      return std::nullopt;
    }
    const Vec3 place = bounds_of({&boxes, 1}).center();
    throw Error(Errc::limit_exceeded,
                "what hangs together at " + decimal(place) + ": " + error.message() + remedy_, {},
                source_);
  }
}

bool TileMemory::is_short(const Processes& processes, std::span<const std::size_t> owners) {
  if (limits_.empty()) {
    return false;
  }
  take_from_owners(processes, is_short_, [&](std::size_t i) { return owners[i]; });
  was_short_ = false;
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    if (is_short_[i] != 0) {
      bytes_[i] = all_;
      was_short_ = true;
    }
  }
  std::ranges::fill(is_short_, 0);
  return was_short_;
}

}  // namespace dupin::cli
