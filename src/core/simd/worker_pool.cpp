#include "simd/worker_pool.h"

#include <exception>
#include <system_error>
#include <utility>

namespace ratchet_sieve
{

WorkerPool::WorkerPool(std::size_t workers)
{
  try
  {
    for (std::size_t worker = 1; worker < workers; ++worker)
      threads_.emplace_back([this, worker] { serve(worker); });
  }
  catch (const std::system_error&)
  {
    // The system provides no more threads; the existing ones do all of the work.
  }
}

WorkerPool::~WorkerPool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
  }
  begin_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

void WorkerPool::run(const std::function<void(std::size_t)>& work, std::size_t least)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    begun_ = finished_ = 0;
    ++round_;
  }
  begin_.notify_all();
  call(work, 0);
  std::unique_lock<std::mutex> lock(mutex_);
  end_.wait(lock, [&] { return finished_ == begun_ && begun_ >= least; });
  work_ = nullptr;
  if (error_)
    std::rethrow_exception(std::exchange(error_, nullptr));
}

void WorkerPool::serve(std::size_t worker)
{
  std::size_t done = 0;
  while (true)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    begin_.wait(lock, [&] { return closing_ || (work_ != nullptr && round_ != done); });
    if (closing_)
      return;
    done = round_;
    ++begun_;
    const auto& work = *work_;
    lock.unlock();
    call(work, worker);
    lock.lock();
    if (++finished_ == begun_)
      end_.notify_one();
  }
}

void WorkerPool::call(const std::function<void(std::size_t)>& work, std::size_t worker)
{
  try
  {
    work(worker);
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = std::current_exception();
  }
}

}  // namespace ratchet_sieve
