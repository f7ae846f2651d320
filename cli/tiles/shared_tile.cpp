#include "tiles/shared_tile.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin::cli {
namespace {

using Size = std::uint64_t;

std::string without_facets(DistrictResult& result, const std::vector<std::uint32_t>& parts) {
  std::string facets = std::exchange(result.output.piece.bytes, {});
  std::string bytes = bytes_of(result, parts);
  result.output.piece.bytes = std::move(facets);
  return bytes;
}

/// The results of one process, of the districts that it owns.
void receive(std::string_view bytes, std::size_t process, std::span<const std::size_t> owners,
             const TileWork& work, std::vector<std::optional<DistrictResult>>& tile) {
  for (std::size_t i = 0; i < tile.size(); ++i) {
    if (owners[i] != process) {
      continue;
    }
    Size size = 0;
    std::optional<DistrictResult> result;
    if (bytes.size() >= sizeof(size)) {
      std::memcpy(&size, bytes.data(), sizeof(size));
      bytes.remove_prefix(sizeof(size));
      result = result_of(std::string(bytes.substr(0, size)), work.parts(i));
    }
    if (!result) {
      throw Error(Errc::internal,
                  "internal error, please report it: another rank sent what cannot be read");
    }
    bytes.remove_prefix(size);
    result->output.piece.is_elsewhere = true;
    tile[i] = std::move(result);
  }
}

/// The districts that this process owns, and what went wrong with the first of those that could not
/// be made.
struct OwnDistricts {
  std::vector<std::optional<DistrictResult>> results;
  Size first_fault;  // their number where there is none
  std::exception_ptr fault;
};

OwnDistricts made_own(std::span<const std::size_t> owners, const Processes& processes,
                      const TileWork& work) {
  OwnDistricts own{std::vector<std::optional<DistrictResult>>(owners.size()), owners.size(), {}};
  std::vector<std::uint8_t> is_faulty(owners.size(), 0);
  try {
    for_each_in_parallel(owners.size(), [&](std::size_t i) {
      if (owners[i] == processes.own()) {
        is_faulty[i] = 1;
        own.results[i] = work.made(i);
        is_faulty[i] = 0;
      }
    });
  } catch (...) {  // what the first of them throws
    own.fault = std::current_exception();
    own.first_fault = static_cast<Size>(std::ranges::find(is_faulty, 1) - is_faulty.begin());
  }
  return own;
}

/// Of faults in several processes the one that has that of the first district speaks, as one
/// process does that makes all of them.
void agree_on_fault(const OwnDistricts& own, std::span<const std::size_t> owners,
                    const Processes& processes) {
  Size first = owners.size();
  const auto* const bytes = reinterpret_cast<const char*>(&own.first_fault);
  for (const std::string& other : processes.exchanged({bytes, sizeof(own.first_fault)})) {
    Size its = 0;
    std::memcpy(&its, other.data(), sizeof(its));
    first = std::min(first, its);
  }
  if (first == owners.size()) {
    return;
  }
  if (first == own.first_fault) {
    std::rethrow_exception(own.fault);
  }
  processes.let_another_speak();
  throw Error(Errc::cancelled, "another process has found a fault");
}

}  // namespace

std::vector<std::size_t> shared_out(std::span<const double> triangles, std::size_t processes) {
  std::vector<std::size_t> order(triangles.size()), owners(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return triangles[i]; });
  std::vector<double> load(processes, 0);
  for (const std::size_t i : order) {
    const auto least = std::ranges::min_element(load);
    owners[i] = static_cast<std::size_t>(least - load.begin());
    *least += triangles[i];
  }
  return owners;
}

std::vector<std::size_t> shared_out(std::span<const double> triangles,
                                    std::span<const std::size_t> ends, std::size_t processes) {
  std::vector<std::size_t> owners;
  for (const std::size_t end : ends) {
    const std::size_t begin = owners.size();
    const auto tile = shared_out(triangles.subspan(begin, end - begin), processes);
    owners.insert(owners.end(), tile.begin(), tile.end());
  }
  return owners;
}

void share_tile(std::span<const std::size_t> owners, const Processes& processes,
                const TileWork& work) {
  std::vector<std::optional<DistrictResult>> tile(owners.size());
  const auto take_one = [&](std::size_t i) {
    work.taken(i, *std::exchange(tile[i], std::nullopt));
  };
  if (processes.count() == 1) {
    for_each_in_order(
        tile.size(), [&](std::size_t i) { tile[i] = work.made(i); }, take_one);
    return;
  }
  OwnDistricts made = made_own(owners, processes, work);
  agree_on_fault(made, owners, processes);
  tile = std::move(made.results);
  std::string own;
  for (std::size_t i = 0; i < tile.size(); ++i) {
    if (tile[i]) {
      const std::string bytes = without_facets(*tile[i], work.parts(i));
      const Size size = bytes.size();
      own.append(reinterpret_cast<const char*>(&size), sizeof(size));
      own += bytes;
    }
  }
  const std::vector<std::string> all = processes.exchanged(own);
  for (std::size_t process = 0; process < all.size(); ++process) {
    if (process != processes.own()) {
      receive(all[process], process, owners, work, tile);
    }
  }
  for (std::size_t i = 0; i < tile.size(); ++i) {
    take_one(i);
  }
}

}  // namespace dupin::cli
