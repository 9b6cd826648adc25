#pragma once

#include <map>
#include <string>

#include "child_node.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{

/// Parameters of a node, by their names.
using Parameters = std::map<std::string, XmlRpc::XmlRpcValue>;

/// Sets a node's parameters: the scene at /scene, paused, and these.
inline void setParameters(const std::string& name, const Parameters& parameters)
{
  XmlRpc::XmlRpcValue scene;
  ASSERT_TRUE(ros::param::get("/scene", scene));
  ros::param::set(name + "/scene", scene);
  ros::param::set(name + "/start_paused", true);
  ros::param::set(name + "/exit_at_end", false);
  for (const auto& [key, value] : parameters)
    ros::param::set(name + "/" + key, value);
}

/// A node that the test has started with parameters of its own, and a client of it.
class StartedNode
{
public:
  StartedNode(const std::string& name, const Parameters& parameters) : sieve(name)
  {
    setParameters(name, parameters);
    start();
  }

  void start()
  {
    sieve.forget();
    sieve.scene.forget();
    node = std::make_unique<ChildNode>("sieve_node", std::vector<std::string>{"__name:=" + sieve.name()});
    ASSERT_TRUE(sieve.connect());
  }

  /// Kills it, and waits until this process has lost all connections to it.
  void killAtOnce()
  {
    node->killAtOnce();
    EXPECT_EQ(node->wait(), -1);
    ASSERT_TRUE(waitFor(
        [&]
        {
          int connected = 0;
          for (const auto& [name, publisher] : sieve.setpoints)
            connected += static_cast<int>(publisher.getNumSubscribers());
          return connected == 0;
        }));
  }

  /// Ends it as Ctrl-C does. @return its exit status
  int end()
  {
    node->interrupt();
    return node->wait();
  }

  std::unique_ptr<ChildNode> node;
  SieveClient sieve;
};

}  // namespace ratchet_sieve
