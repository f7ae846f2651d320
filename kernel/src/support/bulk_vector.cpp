#include "support/bulk_vector.h"

#include <cstdint>

#include <sys/mman.h>

namespace dupin::support {

void prefer_huge_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t kPage = 4096, kWorthwhile = std::size_t{1} << 20;
  if (bytes < kWorthwhile) {
    return;
  }
  const std::size_t ahead = (kPage - reinterpret_cast<std::uintptr_t>(memory) % kPage) % kPage;
  // It is only advice: a system without huge pages may refuse.
  (void)::madvise(static_cast<std::byte*>(memory) + ahead, (bytes - ahead) / kPage * kPage,
                  MADV_HUGEPAGE);
}

}  // namespace dupin::support
