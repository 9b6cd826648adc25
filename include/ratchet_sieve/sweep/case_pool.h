#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ratchet_sieve/sweep/case.h"

namespace ratchet_sieve
{

/// A case that a worker thread has finished.
struct FinishedCase
{
  std::uint64_t position = 0;
  std::optional<CaseResult> result;  ///< nothing if it was stopped
};

/// Threads that run cases: positions go in, results come out. If the system provides no thread, take() runs a
/// case itself.
class CasePool
{
public:
  using Work = std::function<std::optional<CaseResult>(std::uint64_t position)>;

  /// @param threads at most: as many as the system provides
  /// @param make_work called once by each thread; returns the thread's work function. Exceptions of both are
  /// rethrown by take()
  CasePool(std::size_t threads, const std::function<Work()>& make_work);

  /// Waits for the cases under way; discards those not yet begun.
  ~CasePool();
  CasePool(const CasePool&) = delete;
  CasePool& operator=(const CasePool&) = delete;

  void give(const std::vector<std::uint64_t>& positions);

  /// Takes all finished cases. Waits for at least `pause`, so that several can be taken together, unless a
  /// thread is idle; waits for at most `patience` if none is finished.
  std::vector<FinishedCase> take(std::chrono::milliseconds pause, std::chrono::milliseconds patience);

  /// The number of cases that run at the same time.
  std::size_t threads() const { return std::max<std::size_t>(threads_.size(), 1); }

  std::size_t waiting() const;     ///< added and not begun
  std::size_t unfinished() const;  ///< added and not taken

private:
  void serve(const std::function<Work()>& make_work);
  void serveOrFail(const std::function<Work()>& make_work);
  void workHere();
  bool idles() const { return own_work_ || given_.size() < idle_; }

  mutable std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable news_;
  std::deque<std::uint64_t> given_;
  std::vector<FinishedCase> finished_;
  std::size_t unfinished_ = 0;
  std::size_t idle_ = 0;
  bool closing_ = false;
  std::exception_ptr error_;
  std::vector<std::thread> threads_;
  Work own_work_;  ///< of the caller, if there are no threads
};

}  // namespace ratchet_sieve
