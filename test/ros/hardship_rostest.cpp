#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "node_reports.h"
#include "read_bags.h"
#include "started_node.h"

namespace ratchet_sieve
{
namespace
{
/// Freed memory that the address sanitizer keeps, to detect later use [bytes].
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t FREED_AND_KEPT = std::size_t{256} << 20;
#else
constexpr std::size_t FREED_AND_KEPT = 0;
#endif

/// The number of nodes that have subscribed to a topic, as the master knows it.
int subscribers(const std::string& topic)
{
  XmlRpc::XmlRpcValue request(ros::this_node::getName()), response, state;
  if (!ros::master::execute("getSystemState", request, response, state, false))
    return 0;
  for (int k = 0; k < state[1].size(); ++k)
    if (static_cast<std::string&>(state[1][k][0]) == topic)
      return state[1][k][1].size();
  return 0;
}

TEST(Stages, areJoinedByAConveyorThatLosesNoDisk)
{
  StartedNode first("/stage1", {});
  StartedNode second("/stage2", {});
  std::map<std::string, std::uint64_t> right;  // by species
  std::uint64_t left = 0;
  const ros::Subscriber exits = first.sieve.node.subscribe<DiskExit>(
      "exits", 1000,
      [&](const DiskExit::ConstPtr& exit) { ++(exit->side == "right" ? right[exit->species] : left); });
  ros::param::set("/belt/from", "stage1");
  ros::param::set("/belt/to", "stage2");
  ChildNode conveyor("conveyor.py", {"__name:=belt"});
  ASSERT_TRUE(waitFor([&] { return exits.getNumPublishers() == 1 && subscribers("/stage1/exits") == 2; }));
  ros::WallDuration(1.0).sleep();  // The master knows of the conveyor, the sieve will in a moment.
  first.sieve.stepAndSee(4.0);
  const std::vector<SpeciesBins> bins = first.sieve.bins.frames.back().bins;
  ASSERT_TRUE(waitFor([&] { return right["A"] == bins[0].right && right["B"] == bins[1].right; }));
  EXPECT_EQ(left, bins[0].left + bins[1].left);
  ASSERT_GT(bins[0].right + bins[1].right, 0u);
  EXPECT_TRUE(waitFor(
      [&]
      {
        second.sieve.stepAndSee(1e-3);
        const std::vector<SpeciesBins> now = second.sieve.bins.frames.back().bins;
        return now[0].on_base == 15 + bins[0].right && now[1].on_base == 15 + bins[1].right;
      }));
}

/// A schedule of an inclination at 0.25 s, and perhaps of what is never reached.
Parameters scheduleFor(const std::string& sieve, bool ends)
{
  XmlRpc::XmlRpcValue schedule;
  schedule[0]["time"] = 0.25;
  schedule[0]["inclination"] = 0.05;
  schedule[0]["frequency"] = 20.0;
  if (!ends)
  {
    schedule[1]["time"] = 1000.0;
    schedule[1]["amplitude"] = 0.001;
  }
  return {{"schedule", schedule}, {"sieve", sieve}};
}

TEST(Hardship, aScheduleBeginsAnewWithTimeAndWithANodeThatComesAgain)
{
  for (const auto& [key, value] : scheduleFor("/staged", false))
    ros::param::set("/conductor/" + key, value);
  const NodeLog log("/conductor");
  ChildNode conductor("schedule.py", {"__name:=conductor"});
  StartedNode started("/staged", {{"real_time_factor", 10.0}});
  SieveClient& sieve = started.sieve;
  std::vector<BaseFrame>& frames = sieve.base.frames;
  const auto firstAt = [&](double inclination)
  {
    return std::find_if(frames.begin(), frames.end(),
                        [=](const BaseFrame& frame)
                        { return frame.base.commanded_inclination == inclination; });
  };
  const auto expectTilt = [&]
  {
    ASSERT_TRUE(
        waitFor([&] { return firstAt(0.05) != frames.end() && sieve.commanded("frequency") == 20.0; }));
    EXPECT_GE(firstAt(0.05)->time, 0.25);
  };
  expectTilt();
  sieve.forget();
  ASSERT_TRUE(sieve.reset().success);
  ASSERT_TRUE(waitFor([&] { return firstAt(0.0) != frames.end(); }));
  frames.erase(frames.begin(), firstAt(0.0));
  expectTilt();
  started.killAtOnce();
  ASSERT_TRUE(waitFor([&] { return log.count("before the end of the schedule") == 1; }));
  started.start();
  expectTilt();
  EXPECT_TRUE(conductor.running());
}

TEST(Hardship, aScheduleThatIsOverDoesNotMindTheEnd)
{
  for (const auto& [key, value] : scheduleFor("/finite", true))
    ros::param::set("/usher/" + key, value);
  const NodeLog log("/usher");
  ChildNode usher("schedule.py", {"__name:=usher"});
  // Paused until the schedule is connected: the run is over in 0.2 s.
  StartedNode started(
      "/finite",
      {{"paused", true}, {"exit_at_end", true}, {"scene/duration", 2.0}, {"real_time_factor", 10.0}});
  EXPECT_EQ(started.node->wait(), 0) << started.node->errors();
  ASSERT_TRUE(waitFor([&] { return log.count("the schedule is over") == 1; }));
  started.start();
  ASSERT_TRUE(waitFor([&] { return log.count("the schedule is over") == 2; }));
  EXPECT_EQ(log.count("before the end of the schedule"), 0);
}

TEST(Hardship, aNameThatIsNoneIsBadInput)
{
  for (const std::string program : {"sieve_node", "sieve_display"})
  {
    ChildNode node(program, {"__name:=my-sieve"});
    EXPECT_EQ(node.wait(), 2);
    EXPECT_EQ(node.errors().rfind(program + ": ", 0), 0u) << node.errors();
    EXPECT_NE(node.errors().find("my-sieve"), std::string::npos) << node.errors();
    EXPECT_EQ(node.errors().find('\n'), node.errors().size() - 1) << node.errors();
  }
}

TEST(Hardship, eachControllerIsToldOnce)
{
  const NodeLog log("/told");
  StartedNode started("/told", {});
  for (const double inclination : {0.1, 0.05, 0.02})
    started.sieve.command("inclination", inclination);
  ChildNode other("/usr/bin/env",
                  {"rostopic", "pub", "-1", "/told/inclination_setpoint", "std_msgs/Float64", "0.2"});
  ASSERT_TRUE(waitFor([&] { return log.count("inclination: 0.2 rad from 0.000 s on, by /rostopic_") == 1; }));
  EXPECT_EQ(log.count("inclination: 0.1 rad from 0.000 s on, by " + ros::this_node::getName()), 1);
  EXPECT_EQ(log.count("inclination: "), 2);
}

TEST(Hardship, aBurstOfGarbage)
{
  constexpr double INF = std::numeric_limits<double>::infinity();
  const NodeLog log("/pelted");
  StartedNode started("/pelted", {});
  SieveClient& sieve = started.sieve;
  Statuses statuses(sieve.node);
  sieve.command("inclination", 0.05);
  for (int k = 0; k < 20000; ++k)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), INF, -INF, 1e308, -0.51, 0.51})
      sieve.publish("inclination", bad);
  sieve.publish("frequency", -1.0);
  for (const char* refusal : {"frequency_setpoint -1 Hz refused", "inclination_setpoint 0.51 rad refused"})
    ASSERT_TRUE(statuses.waitFor("pelted: setpoints", diagnostic_msgs::DiagnosticStatus::WARN, refusal));
  sieve.stepAndSee(0.5);
  EXPECT_EQ(sieve.base.frames.back().base.inclination, 0.05);
  EXPECT_EQ(sieve.base.frames.back().base.frequency, 23.0);

  // Then 100,000 legal ones: the last one is applied.
  for (int k = 0; k < 100000; ++k)
    sieve.publish("inclination", 1e-6 * k);
  sieve.command("inclination", 0.25);
  sieve.publish("frequency", 20.0);
  ASSERT_TRUE(statuses.waitFor("pelted: setpoints", diagnostic_msgs::DiagnosticStatus::OK));
  sieve.stepAndSee(0.5);
  EXPECT_EQ(sieve.commanded("inclination"), 0.25);
  EXPECT_LT(log.lines.size(), 100u);
}

/// Memory of a process in RAM [bytes].
std::size_t residentMemory(pid_t process)
{
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::size_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(Hardship, oneSubscriberHangsAndTheOtherGetsEveryMessage)
{
  // 4000 disks without disk-disk collisions: a message of about 270 kB.
  StartedNode started("/talkative", {{"scene/boundary", "periodic"},
                                     {"scene/contact/pair_collisions", false},
                                     {"set", "{species.0.count: 2000, species.1.count: 2000}"}});
  SieveClient& sieve = started.sieve;
  ChildNode deaf("/usr/bin/env", {"rostopic", "hz", "/talkative/particles"});
  ASSERT_TRUE(waitFor([] { return subscribers("/talkative/particles") == 2; }));
  sieve.stepAndSee(0.25);
  deaf.interrupt(SIGSTOP);
  std::size_t memory_before = 0;
  for (int k = 1; k < 48; ++k)
  {
    sieve.particles.forget();
    sieve.stepAndSee(0.25);
    ASSERT_EQ(sieve.particles.frames.size(), 15u);
    for (int j = 0; j < 15; ++j)
      ASSERT_EQ(sieve.particles.frames[static_cast<std::size_t>(j)].time, (15 * k + j + 1) / 60.0);
    if (k == 7)
      memory_before = residentMemory(started.node->process());
  }
  // 600 messages were sent since: 160 MB if they were kept.
  EXPECT_LT(residentMemory(started.node->process()), memory_before + FREED_AND_KEPT + (50u << 20));
}
}  // namespace
}  // namespace ratchet_sieve
