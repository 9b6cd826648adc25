#include "events/prefetch_window.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

TEST(PrefetchWindow, TakesSoManyEventsByThePaceOfThoseBefore)
{
  PrefetchWindow ahead(10.0);
  // One event per quarter of a second, then one per sixteenth.
  ahead.begin(1.0, 4);
  EXPECT_EQ(ahead.end(), 1.0 + 10 * 0.25);
  ahead.begin(3.0, 36);
  EXPECT_EQ(ahead.end(), 3.0 + 10 * 0.0625);
}

TEST(PrefetchWindow, KeepsItsPaceWhereNothingHasHappened)
{
  PrefetchWindow ahead(10.0);
  ahead.begin(1.0, 4);
  ahead.begin(8.0, 4);
  EXPECT_EQ(ahead.end(), 8.0 + 10 * 0.25);
}

TEST(PrefetchWindow, GoesOnAfterTheZeroOfTimeHasMoved)
{
  PrefetchWindow ahead(10.0);
  ahead.begin(1.0, 4);
  ahead.rebase(0.5);
  EXPECT_EQ(ahead.end(), 0.5 + 10 * 0.25);
  ahead.begin(2.5, 36);
  EXPECT_EQ(ahead.end(), 2.5 + 10 * 0.0625);
}

}  // namespace
}  // namespace ratchet_sieve
