#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace dupin::support {

/// Asks for huge pages behind large memory, so that it comes and goes in fewer steps. Changes
/// nothing else.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// Leaves items that a vector grows by unset: the threads that fill them touch their memory first.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  // NOLINTBEGIN(readability-identifier-naming): the names that std::allocator_traits asks for
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  // NOLINTEND(readability-identifier-naming)
  [[nodiscard]] T* allocate(std::size_t count) {
    T* const memory = std::allocator<T>::allocate(count);
    prefer_huge_pages(memory, count * sizeof(T));
    return memory;
  }
  template <class U>
  void construct(U* item) {
    ::new (static_cast<void*>(item)) U;
  }
  template <class U, class... Arguments>
  void construct(U* item, Arguments&&... arguments) {
    std::construct_at(item, std::forward<Arguments>(arguments)...);
  }
};
template <class T>
using BulkVector = std::vector<T, UnsetAllocator<T>>;

/// Gives memory back; an assignment of {} would keep it.
template <class Items>
void release(Items& items) {
  Items().swap(items);
}

/// A large reserve(), assignment or resize() of an empty vector.
template <class T>
void reserve_bulk(std::vector<T>& items, std::size_t count) {
  items.reserve(count);
  prefer_huge_pages(items.data(), count * sizeof(T));
}
template <class T>
void assign_bulk(const std::vector<T>& from, std::vector<T>& to) {
  reserve_bulk(to, from.size());
  to.assign(from.begin(), from.end());
}
template <class T>
void resize_bulk(std::vector<T>& items, std::size_t count) {
  reserve_bulk(items, count);
  items.resize(count);
}

}  // namespace dupin::support
