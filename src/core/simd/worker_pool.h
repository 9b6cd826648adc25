#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ratchet_sieve
{

/// A pool of threads for repeated parallel work.
class WorkerPool
{
public:
  /// @param workers number of threads, including the caller's; fewer if the system provides no more
  explicit WorkerPool(std::size_t workers);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  std::size_t workers() const { return threads_.size() + 1; }

  /// Calls work(worker) for every worker in parallel, and returns when all have finished. Rethrows an
  /// exception of one of them.
  void run(const std::function<void(std::size_t worker)>& work);

private:
  void serve(std::size_t worker);
  void call(const std::function<void(std::size_t)>& work, std::size_t worker);

  std::mutex mutex_;
  std::condition_variable begin_;
  std::condition_variable end_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t round_ = 0;  ///< number of calls of run()
  std::size_t at_work_ = 0;
  bool closing_ = false;
  std::exception_ptr error_;
  std::vector<std::thread> threads_;
};

}  // namespace ratchet_sieve
