#include <algorithm>

#include <gtest/gtest.h>

#include "ratchet_sieve/SeekTrial.h"
#include "sieve_client.h"

namespace ratchet_sieve
{
namespace
{
/// A search with restarts and interruptions may take this long [s of wall time]; usually about ten.
constexpr double TIMEOUT = 120.0;

/// Of two seconds: a trial takes about seven steps.
constexpr int MOST_STEPS = 300;

/// Q of config/seek.yaml by docs/seeking.md: 0.43 at 0.15 rad, above 0.33 from 0.1 to 0.19, 0.15 at 0. A
/// trial's Q has a standard error of 0.06, that of the held inclination 0.03.
constexpr double LEAST_BEST = 0.09;
constexpr double MOST_BEST = 0.21;
constexpr double CLEAR_GAIN = 0.1;

/// Receives all trials of the node.
class SeekClient
{
public:
  SeekClient()
  {
    subscriber_ = node_.subscribe<SeekTrial>(
        "/seek/trials", 1000, [this](const SeekTrial::ConstPtr& trial) { trials.push_back(*trial); });
  }

  bool connect()
  {
    return waitFor([&] { return subscriber_.getNumPublishers() > 0; });
  }

  bool waitForTrials(std::size_t count)
  {
    return waitFor([&] { return trials.size() >= count; }, TIMEOUT);
  }

  std::vector<SeekTrial> trials;

private:
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
};

/// The node as launched, the sieve as fast as possible; meanwhile the sieve is reset, and stepped while
/// paused.
TEST(Seek, findsTheBestInclinationFromAPoorOne)
{
  SeekClient seek;
  SieveClient sieve("/sieve");
  ASSERT_TRUE(seek.connect());
  ASSERT_TRUE(sieve.connect());
  ASSERT_TRUE(sieve.call("unpause_physics"));
  ASSERT_TRUE(seek.waitForTrials(4));
  const SeekTrial first = seek.trials.front();
  EXPECT_EQ(first.trial, 1u);
  EXPECT_EQ(first.phase, "approach");
  EXPECT_EQ(first.inclination, 0.0);
  EXPECT_GT(first.balance, 0.5);  // nearly all disks leave on the right
  EXPECT_EQ(first.next_inclination, 0.1);
  EXPECT_EQ(first.species, (std::vector<std::string>{"A", "B"}));

  // Time jumps back, and the base is level: the setpoint is sent again, and the trial restarts.
  ASSERT_TRUE(sieve.call("pause_physics"));
  sieve.resetAndSee();
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination != 0.0; }));
  EXPECT_EQ(sieve.base.frames.back().time, 0.0);
  const std::size_t before = seek.trials.size();
  double now = 0.0;
  const auto tried_again = [&]
  {
    return std::any_of(seek.trials.begin() + static_cast<std::ptrdiff_t>(before), seek.trials.end(),
                       [now](const SeekTrial& trial) { return trial.time <= now; });
  };
  for (int k = 0; k < MOST_STEPS && !tried_again(); ++k)
  {
    now = sieve.step(2.0).time;
    waitFor(tried_again, 0.1);
  }
  ASSERT_TRUE(tried_again());
  ASSERT_TRUE(sieve.call("unpause_physics"));

  ASSERT_TRUE(waitFor([&] { return seek.trials.back().phase == "hold"; }, TIMEOUT));
  EXPECT_TRUE(std::is_sorted(seek.trials.begin(), seek.trials.end(),
                             [](const SeekTrial& one, const SeekTrial& other)
                             { return one.trial < other.trial; }));
  const SeekTrial held = seek.trials.back();
  EXPECT_GE(held.best_inclination, LEAST_BEST);
  EXPECT_LE(held.best_inclination, MOST_BEST);
  EXPECT_GT(held.best_quality, first.quality + CLEAR_GAIN);

  sieve.base.forget();
  ASSERT_TRUE(waitFor([&] { return !sieve.base.frames.empty(); }));
  EXPECT_EQ(sieve.base.frames.back().base.commanded_inclination, held.best_inclination);
  ASSERT_TRUE(waitFor([&] { return seek.trials.back().granular_temperature.size() == 2; }, TIMEOUT));
}

/// A result is valid for one drive: another drive needs another search.
TEST(Seek, seeksAgainWhereTheDriveIsChanged)
{
  SeekClient seek;
  SieveClient sieve("/sieve");
  ASSERT_TRUE(seek.waitForTrials(1));  // latched
  ASSERT_TRUE(waitFor([&] { return seek.trials.back().phase == "hold"; }, TIMEOUT));
  const double held = seek.trials.back().best_inclination;
  seek.trials.clear();
  ASSERT_TRUE(sieve.connect());
  sieve.publish("frequency", 26.0);
  const auto approach = [&]
  {
    return std::find_if(seek.trials.begin(), seek.trials.end(),
                        [](const SeekTrial& trial) { return trial.phase == "approach"; });
  };
  ASSERT_TRUE(waitFor([&] { return approach() != seek.trials.end(); }, TIMEOUT));
  EXPECT_EQ(approach()->inclination, held);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "seek_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
