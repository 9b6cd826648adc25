#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "command_server.h"
#include "display.h"
#include "ratchet_sieve/live/journal.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/ros/nodes.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "scene_parameters.h"
#include "topic_publisher.h"

namespace ratchet_sieve
{
namespace
{
/// Time for roscpp's thread to send the last messages before the node exits [s of wall time].
constexpr double FLUSH_TIME = 0.25;

RunLog rosLog()
{
  return {[](const std::string& line) { ROS_INFO_STREAM(line); },
          [](const std::string& line) { ROS_WARN_STREAM(line); }};
}

class SieveNode
{
public:
  SieveNode(const SieveNode&) = delete;
  SieveNode& operator=(const SieveNode&) = delete;

  /// Reads the private parameters and pours the scene.
  /// @param stop outlives this
  /// @throws SceneError, ParameterError, BagError, std::invalid_argument if disks overlap
  SieveNode(const ros::NodeHandle& private_node, const SceneParameter& scene, const std::atomic<bool>& stop)
      : node_(private_node),
        stop_(stop),
        parameters_(readNodeParameters(private_node)),
        journal_(rosLog()),
        recorder_(parameters_.record, private_node.getNamespace(), parameters_.recording,
                  parameters_.frames.world),
        control_(scene.root, scene.source, parameters_, recorder_, rosLog(),
                 [this](std::size_t poured, std::size_t of) { watchPour(poured, of); }),
        real_time_factor_(private_node, parameters_.real_time_factor),
        pacer_(parameters_.real_time_factor),
        clock_(node_, parameters_.clock_rate, parameters_.publish_clock),
        transforms_(node_, &clock_),
        topics_(
            node_, [this]() -> const Run& { return control_.run(); }, parameters_, clock_, transforms_),
        display_(node_, parameters_.display_rate),
        diagnostics_(control_, {real_time_factor_, pacer_, speed_}, recorder_, clock_),
        commands_(
            node_, parameters_, control_, diagnostics_, [this](double time) { return stride(time); },
            [this]
            {
              pacer_.anchor(control_.run().time(), Pacer::Clock::now());
              clock_.publish(control_.run().time());
            })
  {
    requireDistinct(
        {{"~scene_file", node_.param<std::string>("scene_file", "")}, {"feed.file", scene.feed_file}},
        {{"~record", parameters_.record}});
    if (!clock_.conflict().empty())
      ROS_WARN("%s", clock_.conflict().c_str());
    if (clock_.enabled() && !ros::Time::isSimTime())
      ROS_WARN("this node publishes /clock, but /use_sim_time is not set: other nodes use wall time");
    if (parameters_.mountedElsewhere())
      own_world_.emplace().sendTransform(ownWorldTransform(parameters_.mount, parameters_.frames));
    control_.addSink(topics_);
    control_.observeExits([this](const ExitRecord& exit) { topics_.publish(exit); });
    control_.observeSensors([this](const Sensor& sensor, const Reading& reading)
                            { topics_.publish(sensor, reading); });
    // After the scene was checked, so that a run that cannot begin leaves no bag.
    recorder_.open();
  }

  /// Runs until the end, and closes the bag. @throws StallError, BagError
  void run()
  {
    const Run& run = control_.run();
    ROS_INFO("%s, %g s, seed %lu%s%s", countText(run.simulation().activeDisks(), "disk").c_str(),
             run.endTime(), static_cast<unsigned long>(run.simulation().scene().seed),
             recorder_.path().empty() ? "" : ", recorded into ", recorder_.path().c_str());
    control_.begin();
    pacer_.anchor(run.time(), Pacer::Clock::now());
    while (!stopped() && !ended())
    {
      commands_.serve(control_.paused() ? Pacer::LONGEST_WAIT : waitUntilDue());
      if (!control_.paused() && !stopped())
        advance();
      keepAlive();
    }
    end();
    if (ended() && control_.run().stopped())
      throw StallError(*control_.run().stopReason());
    if (!recorder_.firstFailure().empty())
      throw BagError("the recording of the run is incomplete: " + recorder_.firstFailure());
  }

private:
  bool stopped() const { return stop_ || !ros::ok(); }

  bool ended() const { return control_.run().finished() && parameters_.exit_at_end; }

  void keepAlive()
  {
    clock_.publishDue(control_.run().time());
    const Run& run = control_.run();
    if (display_.due(run.time()))
    {
      clock_.reach(run.time());
      display_.show(
          {run.simulation().scene(), run.now<BaseFrame>(), run.now<BinFrame>(), run.now<ParticleFrame>(),
           run.simulation().means(), defaultFramePrefix(node_.getNamespace())},
          parameters_.frames.world);
    }
    watchSpeed();
    diagnostics_.updateDue();
    journal_.look(run);
  }

  void watchSpeed()
  {
    const auto now = Pacer::Clock::now();
    const Run& run = control_.run();
    if (const auto factor = real_time_factor_.changed())
    {
      pacer_.setFactor(*factor, run.time(), now);
      speed_.forget();
      ROS_INFO("real-time factor: %g from %.3f s on%s", *factor, run.time(),
               *factor > 0.0 ? "" : ": as fast as possible");
    }
    speed_.update(!control_.paused(), run.time(), pacer_.lost(), now);
    if (const auto line = speed_.line(pacer_.factor(), now))
      ROS_LOG_STREAM(line->warning ? ros::console::levels::Warn : ros::console::levels::Info,
                     ROSCONSOLE_DEFAULT_NAME, line->text);
  }

  /// Logs the progress of a pour, and cancels it if the node is stopped.
  void watchPour(std::size_t poured, std::size_t of)
  {
    if (stopped())
      throw std::runtime_error(
          fmt::format("stopped when {} of {} were poured", poured, countText(of, "disk")));
    journal_.pouring(poured, of, Journal::Clock::now());
  }

  double waitUntilDue() const
  {
    const Run& run = control_.run();
    return pacer_.wait(std::min(run.nextTime(), run.time() + pacer_.stride()), Pacer::Clock::now());
  }

  void advance()
  {
    advanceTo(pacer_.allowed(control_.run().time(), Pacer::Clock::now()));
    const Run& run = control_.run();
    if (!run.finished())
      return;
    control_.pause();
    if (run.stopped())
      ROS_ERROR("stopped at %.6f s: %s", run.time(), run.stopReason()->c_str());
  }

  /// Advances towards a time, and reports to the pacer how long that took.
  void advanceTo(double time)
  {
    const auto begin = Pacer::Clock::now();
    const double from = control_.run().time();
    control_.advanceTo(time);
    const std::chrono::duration<double> wall = Pacer::Clock::now() - begin;
    pacer_.advanced(control_.run().time() - from, wall.count());
  }

  /// One stride of a step requested by a service.
  bool stride(double time)
  {
    keepAlive();
    if (stopped())
      return false;
    advanceTo(std::min(time, control_.run().time() + pacer_.stride()));
    return true;
  }

  void end()
  {
    const std::string path = recorder_.path();
    control_.end();
    clock_.publish(control_.run().time());
    const bool well = ended() && !control_.run().stopped() && recorder_.firstFailure().empty();
    ROS_INFO(
        "ended at %.3f s%s%s%s", control_.run().time(), path.empty() ? "" : ", recorded in ", path.c_str(),
        well ? ": all done; what roslaunch says next, that a required process has died, is no error" : "");
    const auto until = Pacer::Clock::now() + std::chrono::duration<double>(FLUSH_TIME);
    while (ros::ok() && Pacer::Clock::now() < until)
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(Pacer::LONGEST_WAIT));
  }

  ros::NodeHandle node_;
  const std::atomic<bool>& stop_;
  NodeParameters parameters_;
  Journal journal_;
  Recorder recorder_;
  RunControl control_;
  RealTimeFactor real_time_factor_;
  Pacer pacer_;
  SpeedWatch speed_;
  ClockPublisher clock_;
  std::optional<tf2_ros::StaticTransformBroadcaster> own_world_;  ///< if the sieve has its own world frame
  TransformPublisher transforms_;
  TopicPublisher topics_;
  Display display_;
  Diagnostics diagnostics_;
  CommandServer commands_;
};
}  // namespace

int runSieve(const ros::NodeHandle& private_node, const std::atomic<bool>& stop)
{
  std::optional<SieveNode> node;
  try
  {
    node.emplace(private_node, readSceneParameter(private_node), stop);
    node->run();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_node: %s\n", errorText(error).c_str());
    return node ? 1 : stop ? 0 : 2;
  }
}

}  // namespace ratchet_sieve
