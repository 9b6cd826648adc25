#include "ratchet_sieve/ros/bag.h"

#include <errno.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <console_bridge/console.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{
/// Longest error message shown; it may contain a topic name [characters].
constexpr std::size_t LONGEST_REASON = 300;

/// While a bag is read. librosbag trusts its lengths and offsets: where they are damaged it reads outside of
/// its buffers, or its allocator finds that. The program then ends with one line and status 1. What goes
/// wrong in a sink is not the bag's fault.
class DamageGuard
{
public:
  explicit DamageGuard(const std::string& path)
  {
    reading = 1;  // an earlier sink may have thrown
    console_bridge::setLogLevel(
        console_bridge::CONSOLE_BRIDGE_LOG_NONE);  // the exception that follows is told
    line = std::string(program_invocation_short_name) + ": " + path + ": is damaged: try `rosbag reindex`\n";
    struct sigaction action = {};
    action.sa_handler = end;
    for (std::size_t k = 0; k < before_.size(); ++k)
      sigaction(SIGNALS[k], &action, &before_[k]);
  }
  ~DamageGuard()
  {
    for (std::size_t k = 0; k < before_.size(); ++k)
      sigaction(SIGNALS[k], &before_[k], nullptr);
    console_bridge::setLogLevel(level_before_);
  }
  DamageGuard(const DamageGuard&) = delete;
  DamageGuard& operator=(const DamageGuard&) = delete;

  /// Hands a frame over, unguarded.
  template <typename Frame>
  static void give(const Frame& frame, FrameSink& sink)
  {
    reading = 0;
    sink.take(frame);
    reading = 1;
  }

private:
  static void end(int number)
  {
    if (reading == 0)
    {
      signal(number, SIG_DFL);
      raise(number);
      return;
    }
    // Nothing else is safe here.
    const ssize_t written = write(STDERR_FILENO, line.data(), line.size());
    static_cast<void>(written);
    _exit(EXIT_FAILURE);
  }

  static constexpr std::array<int, 3> SIGNALS = {SIGSEGV, SIGBUS, SIGABRT};
  static inline std::string line;
  static inline volatile std::sig_atomic_t reading = 1;
  std::array<struct sigaction, SIGNALS.size()> before_;
  console_bridge::LogLevel level_before_ = console_bridge::getLogLevel();
};

/// The frames of one topic, with one frame of read-ahead.
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
  const auto& frame() const { return frame_; }

  void pass(FrameSink& sink) override
  {
    DamageGuard::give(frame_, sink);
    next();
  }

  void next()
  {
    ++position_;
    read();
  }

private:
  void read()
  {
    if (TopicStream::done())
      return;
    const auto message = position_->instantiate<Message>();
    if (!message)
      throw std::invalid_argument(position_->getTopic() + " does not have its declared type");
    frame_ = toFrame(*message);
    if (!isStamp(frame_.time))
      throw std::invalid_argument(position_->getTopic() + " has a message with an invalid time");
  }

  rosbag::View view_;
  rosbag::View::iterator position_;
  decltype(toFrame(std::declval<Message>())) frame_;
};

/// Which version recorded a bag; empty if its scene is of an unknown type.
std::string recordedBy(const rosbag::Bag& bag)
{
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TypeQuery(ros::message_traits::datatype<SceneDescription>())))
    if (const auto scene = message.instantiate<SceneDescription>())
      return ", recorded by ratchet_sieve " + scene->version;
  return "";
}

/// The one topic that carries messages of this type; empty if none does.
template <typename Message>
std::string topicOf(const rosbag::Bag& bag)
{
  rosbag::View all(bag);
  const std::string type = ros::message_traits::datatype<Message>();
  std::set<std::string> topics;
  for (const rosbag::ConnectionInfo* connection : all.getConnections())
  {
    if (connection->datatype != type)
      continue;
    if (connection->md5sum != ros::message_traits::md5sum<Message>())
      throw std::invalid_argument(connection->topic + " has a " + type + " that ratchet_sieve " + version() +
                                  " does not know" + recordedBy(bag));
    topics.insert(connection->topic);
  }
  if (topics.size() > 1)
    throw std::invalid_argument("holds several runs: " + *topics.begin() + " and " + *topics.rbegin());
  return topics.empty() ? "" : *topics.begin();
}

std::string sceneTopic(const rosbag::Bag& bag)
{
  std::string topic = topicOf<SceneDescription>(bag);
  if (topic.empty())
    throw std::invalid_argument("holds no run: no topic of type ratchet_sieve/SceneDescription");
  return topic;
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

/// Runs that begin at the same time would be mixed in a bag, and their frames could not be distinguished.
void requireOneRunAtATime(const rosbag::Bag& bag, const std::string& topic)
{
  std::set<double> starts;
  for (TopicStream<SceneDescription> scenes(bag, topic); !scenes.done(); scenes.next())
    if (!starts.insert(scenes.frame().start_time).second)
      throw std::invalid_argument("holds two runs from " + std::to_string(scenes.frame().start_time) +
                                  " s on, as `rosbag record` keeps them across a ~reset: record with the "
                                  "node's ~record, or reset with keep_time");
}

/// @param begins_run whether to hand over the scene, which begins a run
void readOpened(const rosbag::Bag& bag, bool begins_run, FrameSink& sink)
{
  requireOneRunAtATime(bag, sceneTopic(bag));
  std::vector<std::unique_ptr<Stream>> streams;
  forEachFrameType(
      [&](auto type)
      {
        using Frame = typename decltype(type)::Frame;
        const std::string topic = topicOf<MessageOf<Frame>>(bag);
        if (!topic.empty() && (begins_run || kindOf<Frame>() != FrameKind::SCENE))
          streams.push_back(std::make_unique<TopicStream<MessageOf<Frame>>>(bag, topic));
      });
  merge(streams, sink);
}

/// One of the files of a run.
struct RunPart
{
  std::string path;
  SceneFrame scene;
  ros::Time start, end;  ///< of its first and its last message, bag time
};

RunPart partOf(const rosbag::Bag& bag, const std::string& path)
{
  rosbag::View all(bag);
  TopicStream<SceneDescription> scenes(bag, sceneTopic(bag));
  if (scenes.done())
    throw std::invalid_argument("holds no scene");
  return {path, scenes.frame(), all.getBeginTime(), all.getEndTime()};
}

bool sameRun(const SceneFrame& a, const SceneFrame& b)
{
  return a.yaml == b.yaml && a.start_time == b.start_time && a.scene_hash == b.scene_hash &&
         a.seed == b.seed && a.version == b.version;
}

/// Checks that the files follow one another without a gap: each begins at the time at which the previous one
/// ends.
void requireOneRun(const std::vector<RunPart>& parts)
{
  for (std::size_t k = 1; k < parts.size(); ++k)
  {
    const RunPart& before = parts[k - 1];
    const RunPart& part = parts[k];
    if (!sameRun(before.scene, part.scene))
      throw BagError(part.path + ": is of another run than " + before.path);
    if (part.start != before.end)
      throw BagError(part.path + ": begins at " + std::to_string(part.start.toSec()) +
                     " s, and does not continue " + before.path + ", which ends at " +
                     std::to_string(before.end.toSec()) + " s");
  }
}

/// Opens a bag for `read`, and converts errors to BagError.
template <typename Read>
void withBag(const std::string& path, const Read& read)
{
  if (const auto why = whyUnreadable(path))
    throw BagError(path + ": " + *why);
  const DamageGuard guard(path);
  try
  {
    const rosbag::Bag bag(path);
    read(bag);
  }
  catch (const rosbag::BagUnindexedException&)
  {
    throw BagError(path + ": was not closed, or is damaged: try `rosbag reindex`");
  }
  catch (const ros::Exception& error)
  {
    throw BagError(path + ": cannot be read as a bag: " + shownText(error.what(), LONGEST_REASON));
  }
  catch (const std::bad_alloc&)
  {
    throw BagError(path + ": cannot be read as a bag: it asks for more memory than there is");
  }
  catch (const std::logic_error& error)  // also of a length that is none
  {
    throw BagError(path + ": " + shownText(error.what(), LONGEST_REASON));
  }
}
}  // namespace

void readBags(const std::vector<std::string>& paths, FrameSink& sink)
{
  if (paths.size() == 1)
    return withBag(paths.front(), [&](const rosbag::Bag& bag) { readOpened(bag, true, sink); });
  std::vector<RunPart> parts;
  for (const std::string& path : paths)
    withBag(path, [&](const rosbag::Bag& bag) { parts.push_back(partOf(bag, path)); });
  std::sort(parts.begin(), parts.end(),
            [](const RunPart& a, const RunPart& b)
            { return std::tie(a.start, a.end, a.path) < std::tie(b.start, b.end, b.path); });
  requireOneRun(parts);
  for (const RunPart& part : parts)
    withBag(part.path, [&](const rosbag::Bag& bag) { readOpened(bag, &part == &parts.front(), sink); });
}

}  // namespace ratchet_sieve
