#include "ratchet_sieve/sweep/case_pool.h"

#include <atomic>
#include <set>
#include <stdexcept>

#include <pthread.h>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

using std::chrono::milliseconds;

TEST(CasePool, GivesEveryCaseBackOnce)
{
  CasePool pool(4, [] { return [](std::uint64_t) { return CaseResult(); }; });
  std::vector<std::uint64_t> positions(1000);
  for (std::uint64_t k = 0; k < positions.size(); ++k)
    positions[k] = k;
  pool.give(positions);
  std::multiset<std::uint64_t> seen;
  while (pool.unfinished() > 0)
    for (const FinishedCase& finished : pool.take(milliseconds(1), milliseconds(100)))
      seen.insert(finished.position);
  EXPECT_EQ(seen, std::multiset<std::uint64_t>(positions.begin(), positions.end()));
  EXPECT_EQ(pool.waiting(), 0u);
}

TEST(CasePool, MakesEachThreadItsOwnWork)
{
  std::atomic<int> made{0};
  {
    const CasePool pool(3,
                        [&made]
                        {
                          ++made;
                          return [](std::uint64_t) { return std::nullopt; };
                        });
  }
  EXPECT_EQ(made, 3);
}

/// No system has room for stacks of this size.
class NoThreads
{
public:
  NoThreads()
  {
    pthread_getattr_default_np(&before_);
    pthread_attr_t large;
    pthread_attr_init(&large);
    pthread_attr_setstacksize(&large, std::size_t{1} << 46);
    pthread_setattr_default_np(&large);
    pthread_attr_destroy(&large);
  }
  ~NoThreads()
  {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

private:
  pthread_attr_t before_{};
};

TEST(CasePool, RunsCasesItselfWhereThereAreNoThreads)
{
  const NoThreads none;
  CasePool pool(8, [] { return [](std::uint64_t) { return CaseResult(); }; });
  EXPECT_EQ(pool.threads(), 1u);
  pool.give({3, 5});
  for (const std::uint64_t position : {3u, 5u})
  {
    const std::vector<FinishedCase> finished = pool.take(milliseconds(1), milliseconds(100));
    ASSERT_EQ(finished.size(), 1u);
    EXPECT_EQ(finished[0].position, position);
  }
  EXPECT_EQ(pool.unfinished(), 0u);
}

TEST(CasePool, PassesAnErrorOn)
{
  CasePool pool(2,
                []
                {
                  return
                      [](std::uint64_t) -> std::optional<CaseResult> { throw std::runtime_error("no room"); };
                });
  pool.give({1});
  const auto take_all = [&pool]
  {
    while (true)
      pool.take(milliseconds(1), milliseconds(100));
  };
  EXPECT_THROW(take_all(), std::runtime_error);
}

}  // namespace
}  // namespace ratchet_sieve
