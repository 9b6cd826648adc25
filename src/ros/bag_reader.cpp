#include "ratchet_sieve/ros/bag_reader.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "bag_structure.h"
#include "bounded_stream.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
/// What a stamp of ROS can say: 32 bits of seconds [s].
constexpr double LATEST_TIME = 4294967295.0;

/// Of an error, which may name a topic [characters].
constexpr std::size_t LONGEST_REASON = 300;

/// One topic's frames, the next one read ahead.
class Stream
{
public:
  virtual ~Stream() = default;
  virtual bool done() = 0;
  virtual double time() const = 0;
  virtual void pass(FrameSink& sink) = 0;
};

template <typename Message>
class TopicStream : public Stream
{
public:
  TopicStream(const rosbag::Bag& bag, const std::string& topic)
      : view_(bag, rosbag::TopicQuery(topic)), position_(view_.begin())
  {
    read();
  }

  bool done() override { return position_ == view_.end(); }
  double time() const override { return frame_.time; }

  void pass(FrameSink& sink) override
  {
    sink.take(frame_);
    ++position_;
    read();
  }

private:
  void read()
  {
    if (done())
      return;
    if (!position_->isType<Message>())
      throw std::invalid_argument(position_->getTopic() + " is not what its type says");
    std::vector<std::uint8_t> bytes(position_->size());
    if (bytes.empty())
      throw std::invalid_argument(position_->getTopic() + " has an empty message");
    ros::serialization::OStream filled(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    position_->write(filled);
    Message message;
    BoundedStream(bytes).next(message);
    frame_ = toFrame(message);
    if (!(frame_.time >= 0.0 && frame_.time <= LATEST_TIME))
      throw std::invalid_argument(position_->getTopic() + " has a message at a time that is none");
  }

  rosbag::View view_;
  rosbag::View::iterator position_;
  decltype(toFrame(std::declval<Message>())) frame_;
};

/// The topic that carries messages of this type; empty if none does.
template <typename Message>
std::string topicOf(rosbag::View& all)
{
  const std::string type = ros::message_traits::datatype<Message>();
  std::string topic;
  for (const rosbag::ConnectionInfo* connection : all.getConnections())
  {
    if (connection->datatype != type)
      continue;
    if (connection->md5sum != ros::message_traits::md5sum<Message>())
      throw std::invalid_argument(connection->topic + " was recorded with another version of " + type);
    if (!topic.empty() && topic != connection->topic)
      throw std::invalid_argument("holds several runs: " + topic + " and " + connection->topic);
    topic = connection->topic;
  }
  return topic;
}

template <typename Message>
void addStream(const rosbag::Bag& bag, rosbag::View& all, std::vector<std::unique_ptr<Stream>>& streams)
{
  const std::string topic = topicOf<Message>(all);
  if (!topic.empty())
    streams.push_back(std::make_unique<TopicStream<Message>>(bag, topic));
}

void merge(const std::vector<std::unique_ptr<Stream>>& streams, FrameSink& sink)
{
  while (true)
  {
    Stream* next = nullptr;
    for (const auto& stream : streams)
      if (!stream->done() && (next == nullptr || stream->time() < next->time()))
        next = stream.get();
    if (next == nullptr)
      return;
    next->pass(sink);
  }
}

void readOpened(const rosbag::Bag& bag, FrameSink& sink)
{
  rosbag::View all(bag);
  if (topicOf<SceneDescription>(all).empty())
    throw std::invalid_argument("holds no run: no topic of type ratchet_sieve/SceneDescription");
  std::vector<std::unique_ptr<Stream>> streams;
  addStream<SceneDescription>(bag, all, streams);
  addStream<Command>(bag, all, streams);
  addStream<BaseState>(bag, all, streams);
  addStream<ParticleStates>(bag, all, streams);
  addStream<BinCounts>(bag, all, streams);
  addStream<SieveStatistics>(bag, all, streams);
  merge(streams, sink);
}
}  // namespace

void readBag(const std::string& path, FrameSink& sink)
{
  try
  {
    requireSoundBag(path);
    rosbag::Bag bag;
    bag.open(path, rosbag::bagmode::Read);
    readOpened(bag, sink);
  }
  catch (const rosbag::BagUnindexedException&)
  {
    throw BagError(path + ": was not closed, or is damaged: try `rosbag reindex`");
  }
  catch (const ros::Exception& error)
  {
    throw BagError(path + ": cannot be read as a bag: " + shownText(error.what(), LONGEST_REASON));
  }
  catch (const std::invalid_argument& error)
  {
    throw BagError(path + ": " + shownText(error.what(), LONGEST_REASON));
  }
}

}  // namespace ratchet_sieve
