#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/message_event.h>
#include <ros/names.h>

#include "display.h"
#include "node_parameters.h"
#include "ratchet_sieve/live/run_mirror.h"
#include "ratchet_sieve/ros/nodes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double SEARCH_PERIOD = 0.2;  // of the search for a sieve [s of wall time]

/// Time after which a warning says that no message was received [s of wall time].
constexpr double WARN_SILENT_AFTER = 5.0;

/// Timer ticks per picture: a tick that is slightly early then delays a picture by a fraction of its period.
constexpr double TICKS_PER_PICTURE = 4.0;

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

/// The text of a warning that the scene of a sieve is not received; lists the other sieves.
/// @param sieve name of its node; empty: any
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

class DisplayNode
{
public:
  DisplayNode(const ros::NodeHandle& private_node, const std::string& sieve, double rate)
      : node_(private_node), display_(private_node, rate), transforms_(private_node)
  {
    const auto every = [this](double period, void (DisplayNode::*action)())
    {
      return node_.createWallTimer(ros::WallDuration(period),
                                   [this, action](const ros::WallTimerEvent&) { (this->*action)(); });
    };
    show_timer_ = every(1.0 / (TICKS_PER_PICTURE * rate), &DisplayNode::show);
    silence_timer_ = every(WARN_SILENT_AFTER, &DisplayNode::warnOfSilence);
    if (sieve.empty())
      search_timer_ = every(SEARCH_PERIOD, &DisplayNode::search);
    else
      subscribe(sieve);
  }

private:
  /// Takes the first sieve in alphabetical order, live or played from a bag, once there is one.
  void search()
  {
    const std::set<std::string> names = sieves();
    if (names.empty())
      return;
    if (names.size() > 1)
      ROS_WARN("there are %zu sieves; %s is taken", names.size(), names.begin()->c_str());
    search_timer_.stop();
    subscribe(*names.begin());
  }

  void subscribe(const std::string& sieve)
  {
    sieve_ = ros::names::resolve(sieve);
    ParameterReader reader(node_);
    frames_ = frameNames(readFramePrefix(reader, sieve_), false);
    ROS_INFO("shows %s", sieve_.c_str());
    forEachFrameType(
        [this](auto type)
        {
          using Frame = typename decltype(type)::Frame;
          if (kindOf<Frame>() != FrameKind::COMMANDS && kindOf<Frame>() != FrameKind::OBSERVED)
            subscribe<MessageOf<Frame>>(sieve_ + "/" + describe(kindOf<Frame>()).name);
        });
  }

  template <typename Message>
  void subscribe(const std::string& topic)
  {
    const boost::function<void(const ros::MessageEvent<const Message>&)> take =
        [this, topic](const auto& event)
    {
      try
      {
        const Message& message = *event.getMessage();
        see(toFrame(message), event.getPublisherName(), message.header.frame_id);
      }
      catch (const std::invalid_argument& error)
      {
        ROS_WARN_THROTTLE(1.0, "%s: ignored: %s", topic.c_str(), error.what());
      }
    };
    subscribers_.push_back(node_.subscribe<Message>(topic, QUEUE_SIZE, take));
  }

  /// @param publisher name of the node that published the frame @param frame_id of the message
  template <typename Frame>
  void see(const Frame& frame, const std::string& publisher, const std::string& frame_id)
  {
    if (!isStamp(frame.time))
      throw std::invalid_argument("an invalid time");
    mirror_.take(frame);
    // Only the messages tell whether the sieve has a world frame of its own.
    frames_.world = frame_id;
    if constexpr (std::is_same_v<Frame, BaseFrame>)
      if (!haveTransforms(publisher))
        transforms_.publish(frame, frames_);
    if constexpr (std::is_same_v<Frame, SceneFrame>)
      if (mirror_.sceneError())
        ROS_ERROR("the scene cannot be shown: %s", mirror_.sceneError()->c_str());
  }

  /// Whether the transforms come with the frames: a live sieve publishes them, and so does the player of a
  /// bag that holds /tf. tf2 warns of repeated ones.
  bool haveTransforms(const std::string& publisher)
  {
    if (publisher != publisher_)
    {
      publisher_ = publisher;
      have_transforms_ = publisher == sieve_ || publishes(publisher, "/tf");
    }
    return have_transforms_;
  }

  /// Logs one warning if no message was received in time.
  void warnOfSilence()
  {
    silence_timer_.stop();
    if (!mirror_.time())
      ROS_WARN("nothing to show: %s", missingSieveText(sieve_).c_str());
  }

  void show()
  {
    const auto time = mirror_.time();
    if (!time || !display_.due(*time))
      return;
    Picture picture = mirror_.picture();
    picture.sieve = defaultFramePrefix(sieve_);
    display_.show(picture, frames_.world);
  }

  ros::NodeHandle node_;
  Display display_;
  TransformPublisher transforms_;
  RunMirror mirror_;
  std::string sieve_;             ///< name of its node, once known
  FrameNames frames_;             ///< of that sieve
  std::string publisher_;         ///< of the latest base
  bool have_transforms_ = false;  ///< whether it publishes /tf, too
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer search_timer_;
  ros::WallTimer silence_timer_;
  ros::WallTimer show_timer_;
};
}  // namespace

void runDisplay(const ros::NodeHandle& private_node)
{
  ParameterReader reader(private_node);
  const DisplayNode node(private_node, reader.text("sieve", "sieve"),
                         reader.number("rates/display", 30.0, 1.0, MAX_WALL_RATE));
  ros::spin();
}

}  // namespace ratchet_sieve
