#include "ratchet_sieve/live/log_throttle.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
using std::chrono::milliseconds;

const LogThrottle::Clock::time_point START = LogThrottle::Clock::now();

TEST(LogThrottle, saysLinesThatComeSeldomAtOnce)
{
  LogThrottle log;
  EXPECT_EQ(log.put("a", START), "a");
  EXPECT_EQ(log.due(START), std::nullopt);
  EXPECT_EQ(log.put("b", START + LogThrottle::PERIOD), "b");
}

TEST(LogThrottle, saysTheLastOfAFloodAndHowManyThereWere)
{
  LogThrottle log;
  int said = 0;
  std::optional<std::string> last;
  const auto keep = [&](const std::optional<std::string>& line)
  {
    said += line ? 1 : 0;
    last = line ? line : last;
  };
  for (int k = 0; k <= 2500; ++k)  // a thousand a second
    keep(log.put(std::to_string(k), START + milliseconds(k)));
  EXPECT_EQ(said, 3);
  EXPECT_EQ(last, "2000 (the last of 1000)");
  keep(log.due(START + milliseconds(2999)));
  EXPECT_EQ(said, 3);
  keep(log.due(START + milliseconds(3000)));
  EXPECT_EQ(last, "2500 (the last of 500)");
  EXPECT_EQ(log.due(START + milliseconds(9000)), std::nullopt);
}
}  // namespace
}  // namespace ratchet_sieve
