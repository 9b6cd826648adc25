#include "ratchet_sieve/sweep/case_pool.h"

#include <atomic>
#include <set>
#include <stdexcept>

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
