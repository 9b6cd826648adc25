#include "ratchet_sieve/ros/sieve_search.h"

#include <set>

#include <ros/console.h>
#include <ros/master.h>

#include "ratchet_sieve/SceneDescription.h"

namespace ratchet_sieve
{

std::optional<std::string> findSieve()
{
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics))
    return {};
  std::set<std::string> names;
  for (const ros::master::TopicInfo& topic : topics)
    if (topic.datatype == ros::message_traits::datatype<SceneDescription>())
      names.insert(topic.name.substr(0, topic.name.rfind('/')));
  if (names.empty())
    return {};
  if (names.size() > 1)
    ROS_WARN("there are %zu sieves; %s is taken", names.size(), names.begin()->c_str());
  return *names.begin();
}

}  // namespace ratchet_sieve
