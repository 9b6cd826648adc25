#include "ratchet_sieve/analysis/thinned_series.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace ratchet_sieve
{
namespace
{

std::vector<int> thinned(std::size_t capacity, int count)
{
  ThinnedSeries<int> series(capacity);
  for (int i = 0; i < count; ++i)
    series.take(i);
  return series.samples();
}

TEST(ThinnedSeries, KeepsAllThatFits)
{
  EXPECT_EQ(thinned(4, 0), std::vector<int>{});
  EXPECT_EQ(thinned(4, 4), (std::vector<int>{0, 1, 2, 3}));
}

TEST(ThinnedSeries, KeepsEveryOtherOfWhatDoesNot)
{
  EXPECT_EQ(thinned(4, 5), (std::vector<int>{0, 2, 4}));
  EXPECT_EQ(thinned(4, 6), (std::vector<int>{0, 2, 4, 5}));
  EXPECT_EQ(thinned(4, 10), (std::vector<int>{0, 4, 8, 9}));
}

RC_GTEST_PROP(ThinnedSeries, KeepsFirstAndLastAndEvenStepsInLittleRoom, ())
{
  const std::size_t capacity = 2 * *rc::gen::inRange<std::size_t>(1, 20);
  const int count = *rc::gen::inRange(1, 5000);
  const std::vector<int> kept = thinned(capacity, count);
  RC_ASSERT(kept.size() <= capacity + 1);
  RC_ASSERT(kept.front() == 0);
  RC_ASSERT(kept.back() == count - 1);
  for (std::size_t i = 2; i + 1 < kept.size(); ++i)
    RC_ASSERT(kept[i] - kept[i - 1] == kept[1] - kept[0]);
}

}  // namespace
}  // namespace ratchet_sieve
