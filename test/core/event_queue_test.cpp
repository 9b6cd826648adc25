#include "events/event_queue.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace ratchet_sieve
{
namespace
{

TEST(EventQueue, FollowsASortedSetThroughRandomUpdates)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto count = *rc::gen::inRange<std::uint32_t>(1, 70);
        EventQueue queue;
        queue.resize(count);
        std::vector<double> times(count, EventQueue::NEVER);
        std::set<std::pair<double, std::uint32_t>> reference;
        for (std::uint32_t id = 0; id < count; ++id)
          reference.emplace(EventQueue::NEVER, id);
        // Few different times, so that ties are frequent.
        const auto updates = *rc::gen::container<std::vector<std::pair<std::uint32_t, int>>>(
            rc::gen::pair(rc::gen::inRange<std::uint32_t>(0, count), rc::gen::inRange(0, 12)));
        for (const auto& [id, when] : updates)
        {
          const double time = when == 11 ? EventQueue::NEVER : 0.125 * when;
          reference.erase({times[id], id});
          times[id] = time;
          reference.emplace(time, id);
          queue.update(id, time);
          RC_ASSERT(queue.topTime() == reference.begin()->first);
          RC_ASSERT(queue.top() == reference.begin()->second);
        }
      }));
}

TEST(EventQueue, FindsAllThatIsDue)
{
  EXPECT_TRUE(rc::check(
      []
      {
        // Up to three rounds of groups.
        const auto count = *rc::gen::inRange<std::uint32_t>(1, 600);
        const auto times = *rc::gen::container<std::vector<int>>(count, rc::gen::inRange(0, 100));
        const auto until = *rc::gen::inRange(-1, 101);
        EventQueue queue;
        queue.resize(count);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t id = 0; id < count; ++id)
        {
          queue.update(id, times[id]);
          if (times[id] <= until)
            expected.push_back(id);
        }
        std::vector<std::uint32_t> due{7, 7};
        queue.upTo(until, due);
        RC_ASSERT(due == expected);
      }));
}

TEST(EventQueue, GrowingKeepsWhatWasThere)
{
  EventQueue queue;
  queue.resize(3);
  queue.update(2, 5.0);
  queue.update(0, 7.0);
  queue.resize(100);
  EXPECT_EQ(queue.top(), 2u);
  queue.update(99, 1.0);
  EXPECT_EQ(queue.top(), 99u);
}

TEST(EventQueue, RebaseMovesEveryTimeAndKeepsNever)
{
  EventQueue queue;
  queue.resize(4);
  queue.update(1, 5.0);
  queue.rebase(4.0);
  EXPECT_EQ(queue.topTime(), 1.0);
  queue.update(1, EventQueue::NEVER);
  EXPECT_EQ(queue.topTime(), EventQueue::NEVER);
}

TEST(EventQueue, EmptyIsDueNever)
{
  EventQueue queue;
  EXPECT_EQ(queue.topTime(), EventQueue::NEVER);
  queue.resize(0);
  EXPECT_EQ(queue.topTime(), EventQueue::NEVER);
}

}  // namespace
}  // namespace ratchet_sieve
