#include "ratchet_sieve/ros/earlier_publisher.h"

#include <vector>

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcException.h>

namespace ratchet_sieve
{
namespace
{
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

}  // namespace ratchet_sieve
