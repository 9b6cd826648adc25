#include "ratchet_sieve/live/setpoint.h"

#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
using std::chrono::milliseconds;

/// A run in which a command takes some time, on a simulated clock.
class SlowRun
{
public:
  explicit SlowRun(milliseconds cost) : cost_(cost) {}

  void deliver(SetpointInbox& inbox, bool wait)
  {
    inbox.deliver(
        wait,
        [this](Quantity quantity, double value)
        {
          commands.emplace_back(quantity, value);
          now += cost_;
        },
        [this] { return now; });
  }

  std::vector<std::pair<Quantity, double>> commands;
  SetpointInbox::Clock::time_point now = SetpointInbox::Clock::now();

private:
  milliseconds cost_;
};

TEST(SetpointInbox, handsOverTheNewestOfEachQuantityOnce)
{
  SetpointInbox inbox;
  SlowRun run(milliseconds(0));
  run.deliver(inbox, true);
  EXPECT_TRUE(run.commands.empty());
  inbox.put(Quantity::AMPLITUDE, 0.001);
  inbox.put(Quantity::INCLINATION, 0.1);
  inbox.put(Quantity::AMPLITUDE, 0.002);
  run.deliver(inbox, true);
  run.deliver(inbox, true);
  const std::vector<std::pair<Quantity, double>> expected = {{Quantity::INCLINATION, 0.1},
                                                             {Quantity::AMPLITUDE, 0.002}};
  EXPECT_EQ(run.commands, expected);
}

TEST(SetpointInbox, takesNoMoreThanItsShareOfTheTime)
{
  SetpointInbox inbox;
  SlowRun run(milliseconds(20));
  const auto begin = run.now;
  int sent = 0;
  while (run.now < begin + std::chrono::seconds(10))
  {
    inbox.put(Quantity::FREQUENCY, ++sent);
    run.deliver(inbox, true);
    run.now += milliseconds(1);
  }
  // 20 ms each, with a share of a tenth: 5 per second.
  EXPECT_NEAR(static_cast<double>(run.commands.size()), 50.0, 2.0);
  run.now += std::chrono::seconds(1);
  run.deliver(inbox, true);
  EXPECT_EQ(run.commands.back().second, sent);
}

TEST(SetpointInbox, waitsForNothingWhereNothingRuns)
{
  SetpointInbox inbox;
  SlowRun run(milliseconds(20));
  for (const double value : {1.0, 2.0, 3.0})
  {
    inbox.put(Quantity::FREQUENCY, value);
    run.deliver(inbox, false);
  }
  EXPECT_EQ(run.commands.size(), 3u);
}

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

const Setpoint INCLINATION{Quantity::INCLINATION, {-0.25, 0.5}};

TEST(Setpoint, isRefusedOutsideItsLimitsWithTheNumbers)
{
  for (const double value : {-0.25, 0.0, 0.5})
    EXPECT_FALSE(INCLINATION.refusal(value)) << value;
  EXPECT_EQ(INCLINATION.refusal(0.75),
            "inclination_setpoint 0.75 rad refused: must be from -0.25 to 0.5 rad");
  EXPECT_TRUE(INCLINATION.refusal(-0.2500001));
  EXPECT_EQ(INCLINATION.refusal(-std::numeric_limits<double>::quiet_NaN()),
            "inclination_setpoint nan rad refused: must be from -0.25 to 0.5 rad");
  EXPECT_TRUE(INCLINATION.refusal(-std::numeric_limits<double>::infinity()));
}
}  // namespace
}  // namespace ratchet_sieve
