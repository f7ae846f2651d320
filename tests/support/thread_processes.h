#pragma once

#include <barrier>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "dupin/io/processes.h"

namespace dupin::test {

/// Threads in the place of processes. What they do must not throw: the others would wait.
class ThreadProcesses : public Processes {
 public:
  /// Runs work(processes) in so many.
  static void run(std::size_t count, const std::function<void(const Processes&)>& work) {
    Shared shared(count);
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < count; ++i) {
      threads.emplace_back([&, i] { work(ThreadProcesses(shared, i)); });
    }
  }

  [[nodiscard]] std::size_t count() const override { return shared_.bytes.size(); }
  [[nodiscard]] std::size_t own() const override { return own_; }
  [[nodiscard]] std::vector<std::string> exchanged(std::string_view bytes) const override {
    shared_.bytes[own_] = bytes;
    shared_.all_here.arrive_and_wait();
    std::vector<std::string> all = shared_.bytes;
    shared_.all_here.arrive_and_wait();
    return all;
  }
  [[nodiscard]] std::unique_ptr<JointFile> open(const std::filesystem::path& path,
                                                const std::string&) const override {
    return std::make_unique<File>(::open(path.c_str(), O_RDWR));
  }

 private:
  struct Shared {
    explicit Shared(std::size_t count)
        : bytes(count), all_here(static_cast<std::ptrdiff_t>(count)) {}
    std::vector<std::string> bytes;
    std::barrier<> all_here;
  };
  class File : public JointFile {
   public:
    explicit File(int number) : number_(number) { EXPECT_GE(number, 0); }
    void write(std::uint64_t at, std::string_view bytes) override {
      EXPECT_EQ(::pwrite(number_, bytes.data(), bytes.size(), static_cast<off_t>(at)),
                static_cast<ssize_t>(bytes.size()));
    }
    [[nodiscard]] std::uint64_t read(std::uint64_t at, std::span<char> bytes) override {
      return static_cast<std::uint64_t>(
          ::pread(number_, bytes.data(), bytes.size(), static_cast<off_t>(at)));
    }
    void close() override { EXPECT_EQ(::close(number_), 0); }

   private:
    int number_;
  };

  ThreadProcesses(Shared& shared, std::size_t own) : shared_(shared), own_(own) {}

  Shared& shared_;
  std::size_t own_;
};

}  // namespace dupin::test
