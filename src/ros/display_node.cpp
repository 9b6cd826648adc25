#include "ratchet_sieve/ros/display_node.h"

#include <stdexcept>
#include <type_traits>

#include <ros/console.h>
#include <ros/message_event.h>
#include <ros/names.h>

#include "queue_size.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/ros/earlier_publisher.h"
#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/ros/sieve_search.h"

namespace ratchet_sieve
{
namespace
{
constexpr double SEARCH_PERIOD = 0.2;  // of the search for a sieve [s of wall time]
constexpr double WARN_SILENT_AFTER =
    5.0;                          // after which a warning says that no message was received [s of wall time]
constexpr double MAX_RATE = 1e3;  // [1/s]

/// Timer ticks per picture: a tick that is slightly early then delays a picture by a fraction of its period.
constexpr double TICKS_PER_PICTURE = 4.0;
}  // namespace

DisplayNode::DisplayNode(const ros::NodeHandle& private_node)
    : DisplayNode(private_node, ParameterReader(private_node).text("sieve", DEFAULT_SIEVE),
                  ParameterReader(private_node).number("rates/display", 30.0, 1.0, MAX_RATE))
{
}

DisplayNode::DisplayNode(const ros::NodeHandle& private_node, const std::string& sieve, double rate)
    : node_(private_node), display_(private_node, rate), transforms_(private_node)
{
  show_timer_ = node_.createWallTimer(ros::WallDuration(1.0 / (TICKS_PER_PICTURE * rate)),
                                      [this](const ros::WallTimerEvent&) { show(); });
  silence_timer_ = node_.createWallTimer(ros::WallDuration(WARN_SILENT_AFTER),
                                         [this](const ros::WallTimerEvent&) { warnOfSilence(); });
  if (sieve.empty())
    search_timer_ = node_.createWallTimer(ros::WallDuration(SEARCH_PERIOD),
                                          [this](const ros::WallTimerEvent&) { search(); });
  else
    subscribe(sieve);
}

void DisplayNode::search()
{
  const auto sieve = findSieve();
  if (!sieve)
    return;
  search_timer_.stop();
  subscribe(*sieve);
}

void DisplayNode::subscribe(const std::string& sieve)
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
void DisplayNode::subscribe(const std::string& topic)
{
  const boost::function<void(const ros::MessageEvent<const Message>&)> take = [this, topic](const auto& event)
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

template <typename Frame>
void DisplayNode::see(const Frame& frame, const std::string& publisher, const std::string& frame_id)
{
  if (!isStamp(frame.time))
    throw std::invalid_argument("an invalid time");
  mirror_.take(frame);
  // Only the messages tell whether the sieve has a world frame of its own.
  frames_.world = frame_id;
  if constexpr (std::is_same_v<Frame, BaseFrame>)
    if (!haveTransforms(publisher))
    {
      transforms_.setNames(frames_);
      transforms_.publish(frame);
    }
  if constexpr (std::is_same_v<Frame, SceneFrame>)
    if (mirror_.sceneError())
      ROS_ERROR("the scene cannot be shown: %s", mirror_.sceneError()->c_str());
}

/// Whether the transforms come with the frames: a live sieve publishes them, and so does the player of a bag
/// that holds /tf. tf2 warns of repeated ones.
bool DisplayNode::haveTransforms(const std::string& publisher)
{
  if (publisher != publisher_)
  {
    publisher_ = publisher;
    have_transforms_ = publisher == sieve_ || publishes(publisher, "/tf");
  }
  return have_transforms_;
}

/// Logs one warning if no message was received in time.
void DisplayNode::warnOfSilence()
{
  silence_timer_.stop();
  if (!mirror_.time())
    ROS_WARN("nothing to show: %s", missingSieveText(sieve_).c_str());
}

void DisplayNode::show()
{
  const auto time = mirror_.time();
  if (time && display_.due(*time))
    display_.show(mirror_.picture(), frames_.world);
}

}  // namespace ratchet_sieve
