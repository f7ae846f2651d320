#include "rounding/edits/vain_edits.h"

#include <algorithm>
#include <bit>

namespace dupin::rounding {
namespace {

/// Edits are forgotten where there would be more: in hopeless cases millions are tried.
constexpr std::size_t kMostFaults = 1 << 20;

}  // namespace

std::size_t VainEdits::Hash::operator()(const TriedEdit& edit) const {
  auto hash = static_cast<std::uint64_t>(edit.kind);
  const auto mix = [&](std::uint64_t more) {
    hash = (hash ^ more) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29;
  };
  mix((std::uint64_t{edit.what} << 32) | edit.how);
  for (const double coordinate : edit.place) {
    mix(std::bit_cast<std::uint64_t>(coordinate));
  }
  return hash;
}

void VainEdits::refuse(const TriedEdit& edit, std::uint64_t edits, std::span<const Fault> faults) {
  if (faults_.size() > kMostFaults) {
    clear();
  }
  const std::size_t begin = faults_.size();
  faults_.insert(faults_.end(), faults.begin(), faults.end());
  refusals_[edit] = {edits, begin, faults_.size()};
}

std::size_t VainEdits::faults_of(const TriedEdit& edit, std::span<const std::uint32_t> faces,
                                 std::span<const std::uint64_t> last_edit) const {
  const auto refusal = refusals_.find(edit);
  if (refusal == refusals_.end()) {
    return 0;
  }
  const Refusal& last = refusal->second;
  const auto is_unedited = [&](std::uint32_t face) { return last_edit[face] <= last.edits; };
  const auto faults = std::span(faults_).subspan(last.begin, last.end - last.begin);
  const bool still = std::ranges::all_of(faces, is_unedited) &&
                     std::ranges::all_of(faults, [&](const Fault& fault) {
                       return is_unedited(fault.first) && is_unedited(fault.second);
                     });
  return still ? faults.size() : 0;
}

void VainEdits::clear() {
  refusals_.clear();
  faults_.clear();
}

}  // namespace dupin::rounding
