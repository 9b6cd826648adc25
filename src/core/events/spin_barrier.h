#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

namespace ratchet_sieve
{

/// A barrier for threads that meet every few hundred microseconds: it spins before it gives the processor
/// away.
class SpinBarrier
{
public:
  explicit SpinBarrier(std::size_t threads) : threads_(threads) {}

  /// Waits for all threads. The last one calls `complete` before any goes on.
  template <typename Complete>
  void wait(Complete&& complete)
  {
    const std::size_t round = round_.load(std::memory_order_relaxed);
    if (waiting_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_)
    {
      complete();
      waiting_.store(0, std::memory_order_relaxed);
      round_.store(round + 1, std::memory_order_release);
      return;
    }
    for (int spins = 0; round_.load(std::memory_order_acquire) == round; ++spins)
      if (spins > SPINS)
        std::this_thread::yield();
  }

private:
  /// Some ten microseconds.
  static constexpr int SPINS = 10000;

  std::size_t threads_;
  alignas(64) std::atomic<std::size_t> waiting_{0};
  alignas(64) std::atomic<std::size_t> round_{0};
};

}  // namespace ratchet_sieve
