#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "dupin/io/processes.h"

namespace dupin::cli {

struct MpiModule;

/// Whether mpirun has started this process together with others.
[[nodiscard]] bool is_under_mpirun();

/// What all processes under mpirun know to be wrong, one says: another one than this, which waits
/// until that ends it, and returns where nothing does.
void let_another_speak();
/// The same where all find it alike: for all but the first.
void let_first_speak();

/// The processes of one job that mpirun has started together; one alone without mpirun. Where one
/// ends with an error, mpirun ends the others.
class Ranks : public Processes {
 public:
  /// Joins the others. Throws UsageError where mpirun has started this process, but the build has
  /// no MPI.
  Ranks();
  /// Leaves them, unless an error does.
  ~Ranks() override;

  [[nodiscard]] std::size_t count() const override { return count_; }
  [[nodiscard]] std::size_t own() const override { return own_; }

  [[nodiscard]] std::vector<std::string> exchanged(std::string_view bytes) const override;
  [[nodiscard]] std::unique_ptr<JointFile> open(const std::filesystem::path& path,
                                                const std::string& shown) const override;
  void let_another_speak() const override { cli::let_another_speak(); }

 private:
  const MpiModule* module_ = nullptr;
  std::size_t count_ = 1, own_ = 0;
};

/// Each value becomes what it is in the process that owner(place of the value) names; all call it.
template <class Value, class Owner>
void take_from_owners(const Processes& processes, std::vector<Value>& values, const Owner& owner) {
  static_assert(std::is_trivially_copyable_v<Value>);
  const std::vector<std::string> all = processes.exchanged(
      {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::memcpy(&values[i], all[owner(i)].data() + i * sizeof(Value), sizeof(Value));
  }
}

/// What all ranks do with the same input: of its errors the first one speaks.
template <class Function>
auto alike(const Ranks& ranks, const Function& function) {
  try {
    return function();
  } catch (...) {
    if (ranks.count() > 1) {
      let_first_speak();
    }
    throw;
  }
}

}  // namespace dupin::cli
