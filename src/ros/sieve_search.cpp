#include "ratchet_sieve/ros/sieve_search.h"

#include <set>

#include <ros/console.h>
#include <ros/master.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "ratchet_sieve/SceneDescription.h"

namespace ratchet_sieve
{
namespace
{
/// The nodes that publish messages of this type on a topic of their own.
template <typename Message>
std::set<std::string> publishersOf(const std::string& topic_name)
{
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  std::set<std::string> names;
  for (const ros::master::TopicInfo& topic : topics)
  {
    const std::size_t slash = topic.name.rfind('/');
    if (topic.datatype == ros::message_traits::datatype<Message>() &&
        topic.name.substr(slash + 1) == topic_name)
      names.insert(topic.name.substr(0, slash));
  }
  return names;
}
}  // namespace

std::string missingSieveText(const std::string& sieve)
{
  const std::set<std::string> names = publishersOf<SceneDescription>("scene");
  const std::string missing = sieve.empty() ? "no sieve yet" : "no scene of " + sieve + " yet";
  if (names.empty())
    return missing + ": no sieve runs, and no bag of one is played";
  if (names.count(sieve) > 0)
    return missing + ", though it is there: a bag that is paused?";
  std::string others;
  for (const std::string& name : names)
    others += (others.empty() ? "" : ", ") + name;
  return missing + "; there is " + others + ", to be named in the parameter ~sieve";
}

std::optional<std::string> findDisplay(const std::string& preferred)
{
  const std::set<std::string> clouds = publishersOf<sensor_msgs::PointCloud2>("cloud");
  std::optional<std::string> found;
  for (const std::string& name : publishersOf<visualization_msgs::MarkerArray>("markers"))
    if (clouds.count(name) > 0 && (!found || name == preferred))
      found = name;
  return found;
}

std::optional<std::string> findSieve()
{
  const std::set<std::string> names = publishersOf<SceneDescription>("scene");
  if (names.empty())
    return {};
  if (names.size() > 1)
    ROS_WARN("there are %zu sieves; %s is taken", names.size(), names.begin()->c_str());
  return *names.begin();
}

}  // namespace ratchet_sieve
