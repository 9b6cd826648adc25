#include "clock_publisher.h"

#include <algorithm>
#include <optional>
#include <thread>
#include <vector>

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <rosgraph_msgs/Clock.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcException.h>

namespace ratchet_sieve
{
namespace
{
constexpr const char* TOPIC = "/clock";

/// A message of /clock or /tf passes three threads on its way to a tf2 listener's buffer: a few ms, and some
/// tens of ms for each thread on an overloaded machine. tf2 gives no sign that it has arrived.
constexpr std::chrono::milliseconds ARRIVAL(250);

/// A small scene that runs as fast as it can makes ten thousand frames per second of wall time, more than
/// subscribers of /clock can process. Messages are in transit for about as long as this.
constexpr std::chrono::milliseconds SHORTEST_PERIOD(1);

/// The clock's message at a time. Never 0, which means "no time yet" in ROS: `rosbag record` ends with the
/// first message that it receives at 0, and ros::Time::waitForValid() would block while a run is paused
/// there.
ros::Time shownAt(double time)
{
  return std::max(ros::Time(time), ros::TIME_MIN);
}

using XmlRpc::XmlRpcValue;

/// Timeout for an answer [s of wall time]. A live node answers within milliseconds; a stopped one, or one on
/// a machine that is switched off, does not answer.
constexpr double ANSWER_TIMEOUT = 2.0;

XmlRpcValue arguments(const std::string& second = "")
{
  XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  if (!second.empty())
    arguments[1] = second;
  return arguments;
}

/// The publishers of a topic, in the order of registration at the master. Waits if the master is too busy to
/// answer at once, as advertising does.
std::vector<std::string> publishersOf(const std::string& topic)
{
  XmlRpcValue response, state;
  std::vector<std::string> names;
  if (!ros::master::execute("getSystemState", arguments(), response, state, true))
    return names;
  XmlRpcValue& published = state[0];
  for (int k = 0; k < published.size(); ++k)
    if (static_cast<std::string&>(published[k][0]) == topic)
      for (int node = 0; node < published[k][1].size(); ++node)
        names.push_back(published[k][1][node]);
  return names;
}

/// Calls a node's XML-RPC server. @return false if no answer comes in time
bool call(const std::string& uri, const char* method, XmlRpcValue& response)
{
  std::string host;
  std::uint32_t port = 0;
  // This node may have got the port of one that was killed.
  if (uri == ros::XMLRPCManager::instance()->getServerURI() || !ros::network::splitURI(uri, host, port))
    return false;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.executeNonBlock(method, arguments()))
    return false;
  client._disp.work(ANSWER_TIMEOUT);  // until done
  return client.executeCheckDone(response) && !client.isFault();
}

/// The node that advertised a topic before this one and still publishes it; nothing if there is none. If two
/// nodes advertise a topic and then call this at nearly the same time, exactly one of them gets the other's
/// name.
///
/// The master lists publishers in the order of registration. Each is asked whether it publishes the topic.
/// The entry of a killed node either gets no answer or is answered by another process.
/// @pre this node has advertised the topic @param topic resolved
std::optional<std::string> earlierPublisher(const std::string& topic)
{
  for (const std::string& name : publishersOf(topic))
  {
    if (name == ros::this_node::getName())
      return {};
    if (publishes(name, topic))
      return name;
  }
  return {};
}
}  // namespace

bool publishes(const std::string& node, const std::string& topic)
{
  XmlRpcValue response, uri;
  if (!ros::master::execute("lookupNode", arguments(node), response, uri, true) ||
      !call(uri, "getPublications", response))
    return false;
  try
  {
    XmlRpcValue& topics = response[2];  // after the status code and the status message
    for (int k = 0; k < topics.size(); ++k)
      if (static_cast<std::string&>(topics[k][0]) == topic)
        return true;
  }
  catch (const XmlRpc::XmlRpcException&)
  {
    // Not the answer of a ROS node.
  }
  return false;
}

ClockPublisher::ClockPublisher(ros::NodeHandle node, double rate, bool enabled)
    : period_(1.0 / rate), enabled_(enabled)
{
  if (!enabled_)
    return;
  publisher_ = node.advertise<rosgraph_msgs::Clock>(TOPIC, 1);
  const std::optional<std::string> other = earlierPublisher(TOPIC);
  if (!other)
    return;
  conflict_ = *other +
              " already publishes /clock, so this node does not: its stamps are its own simulated "
              "time, not that of /clock";
  enabled_ = false;
  publisher_.shutdown();
}

void ClockPublisher::publishDue(double time)
{
  if (std::chrono::steady_clock::now() - last_ >= period_)
    publish(time);
}

void ClockPublisher::publish(double time)
{
  if (!enabled_)
    return;
  last_ = std::chrono::steady_clock::now();
  rosgraph_msgs::Clock clock;
  clock.clock = shownAt(time);
  shown_ = clock.clock;
  publisher_.publish(clock);
}

void ClockPublisher::reach(double time)
{
  const ros::Time stamp = shownAt(time);
  if (!enabled_ || stamp == shown_)
    return;
  const bool jumps_back = shown_ && stamp < *shown_;
  if (jumps_back)
    std::this_thread::sleep_until(transform_sent_ + ARRIVAL);
  else if (shown_ && std::chrono::steady_clock::now() - last_ < SHORTEST_PERIOD)
    return;
  publish(time);
  if (jumps_back)
    jumped_back_ = std::chrono::steady_clock::now();
}

void ClockPublisher::waitForTimeJump() const
{
  std::this_thread::sleep_until(jumped_back_ + ARRIVAL);
}

}  // namespace ratchet_sieve
