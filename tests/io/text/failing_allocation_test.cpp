#include <atomic>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"
#include "support/source_folder.h"

namespace {

/// How many more allocations succeed; negative: all.
std::atomic<long> left = -1;
/// Whether those behind the first one that fails do, too.
bool is_exhausted = false;

bool fails() {
  long now = left;
  while (now > 0 && !left.compare_exchange_weak(now, now - 1)) {
  }
  if (now == 0 && !is_exhausted) {
    left = -1;
  }
  return now == 0;
}

}  // namespace

// Not inline: GCC would take free for that of another allocator.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const result = fails() ? nullptr : std::malloc(size == 0 ? 1 : size);
  return result != nullptr ? result : throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}

namespace dupin {
namespace {

/// Calls it with a failure of the first, of the second, of every allocation that it makes.
template <class Call>
void expect_bad_alloc_or_none(const Call& call) {
  for (const bool exhausted : {false, true}) {
    is_exhausted = exhausted;
    long allowed = 0;
    for (bool is_done = false; !is_done; ++allowed) {
      left = allowed;
      try {
        call();
        is_done = left > 0;
      } catch (const std::bad_alloc&) {
      }
      left = -1;
    }
    EXPECT_GT(allowed, 20);
  }
}

// The destructors of JSON values must not allocate: the program would end.
TEST(FailingAllocation, is_bad_alloc_of_documents) {
  const std::string text = read_file(test::source_folder() / "examples/reducer.json");
  const Assembly assembly = parse_assembly(text, "a");
  (void)document_text(assembly);
  expect_bad_alloc_or_none([&] { (void)parse_assembly(text, "a"); });
  expect_bad_alloc_or_none([&] { (void)document_text(assembly); });
}

TEST(FailingAllocation, is_bad_alloc_of_glb) {
  const TriMesh mesh = test::labelled_tetrahedron();
  const std::string bytes = glb_bytes(mesh);
  expect_bad_alloc_or_none([&] { (void)glb_bytes(mesh); });
  expect_bad_alloc_or_none([&] { (void)read_glb(bytes, "a"); });
}

}  // namespace
}  // namespace dupin
