#include "events/event_queue.h"

#include <set>
#include <utility>
#include <vector>

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

}  // namespace
}  // namespace ratchet_sieve
