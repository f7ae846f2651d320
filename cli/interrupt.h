#pragma once

namespace dupin::cli {

/// From now on SIGINT and SIGTERM end the program at once with exit code 130, except while a
/// file is being written (see Uninterrupted). A signal that was ignored stays so.
void end_on_interrupt();

/// During its life, an interrupt waits: a file is put in place whole, or taken away again.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

}  // namespace dupin::cli
