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
  void run(const std::function<void(std::size_t worker)>& work) { run(work, threads_.size()); }

  /// As run(), for work that any number of workers can do: threads that have not begun when the caller has
  /// finished are not waited for. Other programs may use their processors.
  void share(const std::function<void(std::size_t worker)>& work) { run(work, 0); }

private:
  /// @param least number of threads that must take part
  void run(const std::function<void(std::size_t)>& work, std::size_t least);
  void serve(std::size_t worker);
  void call(const std::function<void(std::size_t)>& work, std::size_t worker);

  std::mutex mutex_;
  std::condition_variable begin_;
  std::condition_variable end_;
  const std::function<void(std::size_t)>* work_ = nullptr;  ///< null between rounds
  std::size_t round_ = 0;
  std::size_t begun_ = 0;     ///< threads that took part in this round
  std::size_t finished_ = 0;  ///< of those
  bool closing_ = false;
  std::exception_ptr error_;
  std::vector<std::thread> threads_;
};

}  // namespace ratchet_sieve
