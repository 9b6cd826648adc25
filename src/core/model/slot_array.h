#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace ratchet_sieve
{

/// An allocator that asks the system for large pages for large arrays. Events read memory in random order;
/// with pages of 4 kB, most of them wait for the page's address as well (10 % of the time at 10^5 disks).
template <typename T>
struct LargePages
{
  using value_type = T;

  LargePages() = default;
  template <typename Other>
  LargePages(const LargePages<Other>& /*other*/)
  {
  }

  T* allocate(std::size_t count)
  {
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignment(bytes));
#if defined(MADV_HUGEPAGE)
    if (bytes >= PAGE)
      madvise(memory, bytes, MADV_HUGEPAGE);  // where it is refused, pages are small
#endif
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t count)
  {
    ::operator delete(memory, alignment(count * sizeof(T)));
  }

  friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/)
  {
    return true;
  }
  friend bool operator!=(const LargePages& /*a*/, const LargePages& /*b*/)
  {
    return false;
  }

private:
  static constexpr std::size_t PAGE = std::size_t{1} << 21;

  static std::align_val_t alignment(std::size_t bytes)
  {
    return std::align_val_t{bytes < PAGE ? alignof(T) : PAGE};
  }
};

/// What events read or change of each disk, by slot, or of each cell.
template <typename T>
using SlotArray = std::vector<T, LargePages<T>>;

}  // namespace ratchet_sieve
