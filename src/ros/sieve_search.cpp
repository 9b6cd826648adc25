#include "ratchet_sieve/ros/sieve_search.h"

#include <set>

#include <ros/console.h>
#include <ros/master.h>

#include "ratchet_sieve/SceneDescription.h"

namespace ratchet_sieve
{
namespace
{
/// The nodes that publish a scene on a topic of their own.
std::set<std::string> sieves()
{
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  std::set<std::string> names;
  for (const ros::master::TopicInfo& topic : topics)
  {
    const std::size_t slash = topic.name.rfind('/');
    if (topic.datatype == ros::message_traits::datatype<SceneDescription>() &&
        topic.name.substr(slash + 1) == "scene")
      names.insert(topic.name.substr(0, slash));
  }
  return names;
}
}  // namespace

std::string missingSieveText(const std::string& sieve)
{
  const std::set<std::string> names = sieves();
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

std::optional<std::string> findSieve()
{
  const std::set<std::string> names = sieves();
  if (names.empty())
    return {};
  if (names.size() > 1)
    ROS_WARN("there are %zu sieves; %s is taken", names.size(), names.begin()->c_str());
  return *names.begin();
}

}  // namespace ratchet_sieve
