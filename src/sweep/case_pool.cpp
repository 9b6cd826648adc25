#include "ratchet_sieve/sweep/case_pool.h"

#include <system_error>
#include <utility>

namespace ratchet_sieve
{

CasePool::CasePool(std::size_t threads, const std::function<Work()>& make_work)
{
  try
  {
    for (std::size_t k = 0; k < threads; ++k)
      threads_.emplace_back([this, make_work] { serveOrFail(make_work); });
  }
  catch (const std::system_error&)
  {
    if (threads_.empty())
      own_work_ = make_work();
  }
}

CasePool::~CasePool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
  }
  work_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

void CasePool::give(const std::vector<std::uint64_t>& positions)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  given_.insert(given_.end(), positions.begin(), positions.end());
  unfinished_ += positions.size();
  work_.notify_all();
}

std::vector<FinishedCase> CasePool::take(std::chrono::milliseconds pause, std::chrono::milliseconds patience)
{
  if (own_work_)
    workHere();
  std::unique_lock<std::mutex> lock(mutex_);
  const auto idles_now = [this] { return error_ || (idles() && !finished_.empty()); };
  if (!news_.wait_for(lock, pause, idles_now))
    news_.wait_for(lock, patience - pause, [this] { return error_ || !finished_.empty(); });
  if (error_)
    std::rethrow_exception(error_);
  unfinished_ -= finished_.size();
  return std::exchange(finished_, {});
}

std::size_t CasePool::waiting() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return given_.size();
}

std::size_t CasePool::unfinished() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return unfinished_;
}

void CasePool::serveOrFail(const std::function<Work()>& make_work)
{
  try
  {
    serve(make_work);
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = std::current_exception();
    news_.notify_one();
  }
}

void CasePool::workHere()
{
  if (given_.empty())
    return;
  const std::uint64_t position = given_.front();
  given_.pop_front();
  finished_.push_back({position, own_work_(position)});
}

void CasePool::serve(const std::function<Work()>& make_work)
{
  const Work work = make_work();
  std::unique_lock<std::mutex> lock(mutex_);
  while (true)
  {
    ++idle_;
    news_.notify_one();
    work_.wait(lock, [this] { return closing_ || !given_.empty(); });
    --idle_;
    if (closing_)
      return;
    const std::uint64_t position = given_.front();
    given_.pop_front();
    lock.unlock();
    FinishedCase finished{position, work(position)};
    lock.lock();
    finished_.push_back(std::move(finished));
    news_.notify_one();
  }
}

}  // namespace ratchet_sieve
