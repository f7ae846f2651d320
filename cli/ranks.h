#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dupin::cli {

struct MpiModule;

/// Whether mpirun has started this process together with others.
[[nodiscard]] bool is_under_mpirun();

/// The processes of one job that mpirun has started together; one alone without mpirun. Where one
/// ends with an error, mpirun ends the others.
class Ranks {
 public:
  /// Joins the others. Throws UsageError where mpirun has started this process, but the build has
  /// no MPI.
  Ranks();
  /// Leaves them, unless an error does.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] std::size_t count() const { return count_; }
  /// This one's number, below count().
  [[nodiscard]] std::size_t own() const { return own_; }
  /// It writes the file and the report.
  [[nodiscard]] bool is_first() const { return own_ == 0; }

  /// To the first one, which receives in the order of sending. Both throw Error{io_failed}.
  void send(std::string_view bytes) const;
  [[nodiscard]] std::string receive(std::size_t from) const;

 private:
  const MpiModule* module_ = nullptr;
  std::size_t count_ = 1, own_ = 0;
};

}  // namespace dupin::cli
