#include <limits>

#include <gtest/gtest.h>
#include <rosgraph_msgs/Clock.h>

#include "sieve_client.h"
#include "statuses.h"

namespace ratchet_sieve
{
namespace
{
constexpr const char* PARAMETER = "/sieve/real_time_factor";
constexpr const char* STATUS = "sieve: speed";

/// So slow that no frame is due during a test: 20 s of wall time are 20 us.
constexpr double STANDSTILL = 1e-6;

/// A sieve launched with this factor, reset for each test.
class Speed : public testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(sieve.connect());
    sieve.resetAndSee();
    ros::param::set(PARAMETER, STANDSTILL);
    ASSERT_TRUE(waitFor([&] { return asked() == "1e-06"; }));
  }
  void TearDown() override { sieve.call("pause_physics"); }

  std::string asked() { return statuses.value(STATUS, "real-time factor, requested"); }
  std::uint8_t level() { return statuses[STATUS].level; }

  /// The next `count` times on /clock.
  std::vector<double> nextTimes(std::size_t count)
  {
    std::vector<double> times;
    const ros::Subscriber clock = sieve.node.subscribe<rosgraph_msgs::Clock>(
        "/clock", 1000,
        [&](const rosgraph_msgs::Clock::ConstPtr& message) { times.push_back(message->clock.toSec()); });
    EXPECT_TRUE(waitFor([&] { return times.size() >= count; }));
    return times;
  }

  SieveClient sieve{"/sieve"};
  Statuses statuses{sieve.node};
};

TEST_F(Speed, changesWhileItRuns)
{
  ASSERT_TRUE(sieve.call("unpause_physics"));
  EXPECT_LT(nextTimes(50).back(), 1e-3);
  ros::param::set(PARAMETER, 0);              // as `rosparam set` gives it: an integer
  ASSERT_TRUE(sieve.bins.waitForTime(20.0));  // the end of the run
  EXPECT_TRUE(waitFor([&] { return asked() == "0"; }));
}

TEST_F(Speed, refusesABadFactorAndKeepsTheLastGoodOne)
{
  XmlRpc::XmlRpcValue list;
  list[0] = 1.0;
  const std::vector<std::pair<XmlRpc::XmlRpcValue, std::string>> bad = {
      {-1.0, "-1"},     {std::numeric_limits<double>::quiet_NaN(), "nan"},
      {"fast", "fast"}, {1e9, "1000000000"},
      {true, "1"},      {list, "{1}"}};
  ASSERT_TRUE(sieve.call("unpause_physics"));
  for (const auto& [value, shown] : bad)
  {
    ros::param::set(PARAMETER, value);
    const std::string why =
        "parameter /sieve/real_time_factor: " + shown + ": must be a number from 0 to 1e+06";
    ASSERT_TRUE(waitFor(
        [&]
        {
          return level() == diagnostic_msgs::DiagnosticStatus::WARN &&
                 statuses[STATUS].message.find(why) != std::string::npos;
        }))
        << why << " / " << statuses[STATUS].message;
    EXPECT_EQ(asked(), "1e-06");
  }
  ros::param::set(PARAMETER, 0.5);
  EXPECT_TRUE(waitFor([&] { return level() == diagnostic_msgs::DiagnosticStatus::OK && asked() == "0.5"; }));
}

TEST_F(Speed, staysWhereTheParameterIsTakenAway)
{
  ros::param::set(PARAMETER, 0.25);
  ASSERT_TRUE(waitFor([&] { return asked() == "0.25"; }));
  ros::param::del(PARAMETER);
  ros::param::set(PARAMETER, 0.75);
  ASSERT_TRUE(waitFor([&] { return asked() == "0.75"; }));
  EXPECT_EQ(level(), diagnostic_msgs::DiagnosticStatus::OK);
}

/// No machine simulates 30 disks at a million times real time.
TEST_F(Speed, saysThatItCannotKeepUp)
{
  ros::param::set(PARAMETER, 1e6);
  ASSERT_TRUE(sieve.reset(0, {"boundary=periodic", "duration=1e6"}).success);
  ASSERT_TRUE(sieve.call("unpause_physics"));
  ASSERT_TRUE(waitFor([&] { return statuses[STATUS].message.rfind("too slow: ", 0) == 0; }));
  EXPECT_NE(statuses[STATUS].message.find(" times real time instead of 1e+06"), std::string::npos);
  EXPECT_EQ(level(), diagnostic_msgs::DiagnosticStatus::WARN);
  EXPECT_GT(std::stod(statuses.value(STATUS, "wall time lost [s]")), 0.0);
  // It continues at the requested factor, not faster.
  ros::param::set(PARAMETER, STANDSTILL);
  ASSERT_TRUE(waitFor([&] { return asked() == "1e-06"; }));
  const double before = nextTimes(1).back();
  EXPECT_LT(nextTimes(20).back() - before, 1e-3);
  ASSERT_TRUE(waitFor([&] { return level() == diagnostic_msgs::DiagnosticStatus::OK; }));
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "speed_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
