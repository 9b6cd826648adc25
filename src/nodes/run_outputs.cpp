#include "run_outputs.h"

#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>

#include "command_line.h"
#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{
namespace
{

/// A run may go on from the checkpoint that it then replaces.
void requireDistinctFiles(const RunArguments& arguments, const std::string& feed_file)
{
  const std::string active = arguments.bag.empty() ? "" : linkTarget(arguments.bag) + ".active";
  const std::string stream = arguments.summary.empty() ? "/dev/stdout" : "";
  std::vector<NamedFile> outputs = {{"standard output", stream},
                                    {"--summary", arguments.summary},
                                    {"--collisions", arguments.collisions},
                                    {"--exits", arguments.exits},
                                    {"--bag", arguments.bag},
                                    {"--bag", active},
                                    {"--html", arguments.page.path}};
  for (const std::string& path : trajectoryPaths(arguments.trajectory))
    outputs.push_back({"--trajectory", path});
  requireDistinct({{"--resume", arguments.resume}}, outputs);
  outputs.push_back({"--checkpoint", arguments.checkpoint});
  requireDistinct({{"SCENE", arguments.scene}, {"feed.file", feed_file}}, outputs);
}

/// Never unloads the library, because ROS's libraries do not support it.
/// @throws std::runtime_error if the bag cannot be written or this build has no ROS
BagOutput openBag(const std::string& path)
{
#ifdef RATCHET_SIEVE_BAG_PLUGIN
  void* library = dlopen(RATCHET_SIEVE_BAG_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  void* function = library != nullptr ? dlsym(library, BAG_PLUGIN_FUNCTION) : nullptr;
  if (function == nullptr)
    throw std::runtime_error(
        "--bag " + path +
        ": bags need the ROS part (on Debian: install ros-ratchet-sieve_*.deb): " + dlerror());
  BagOutput bag;
  reinterpret_cast<OpenBagPlugin*>(function)(path, bag);
  return bag;
#else
  throw std::runtime_error("--bag " + path + ": bags need ROS, and this build has none");
#endif
}

}  // namespace

/// Takes nothing after its first failure, at which its file is closed: that error may say what is in it.
class RunOutputs::GuardedSink : public FrameSink
{
public:
  GuardedSink(OutputAttempts& attempts, FrameSink& sink, std::function<void()> finish)
      : attempts_(attempts), sink_(sink), finish_(std::move(finish))
  {
  }

  bool wants(FrameKind kind) const override { return finish_ && sink_.wants(kind); }

  void take(const AnyFrame& frame) override
  {
    if (!finish_)
      return;
    attempts_.attempt([&] { takeOrFinish(frame); });
  }

  /// @throws what its file throws
  void finish()
  {
    if (const std::function<void()> write = std::exchange(finish_, nullptr))
      write();
  }

private:
  void takeOrFinish(const AnyFrame& frame)
  {
    try
    {
      sink_.take(frame);
    }
    catch (const std::exception&)
    {
      finish();
      throw;
    }
  }

  OutputAttempts& attempts_;
  FrameSink& sink_;
  std::function<void()> finish_;  ///< nothing once the file is closed
};

RunOutputs::RunOutputs(const RunArguments& arguments, const std::string& feed_file)
{
  orRefuse<std::exception>(
      [&]
      {
        requireDistinctFiles(arguments, feed_file);
        open(arguments);
      });
}

RunOutputs::~RunOutputs() = default;

void RunOutputs::open(const RunArguments& arguments)
{
  if (!arguments.summary.empty())
    summary_ = std::make_unique<AtomicFile>(arguments.summary);
  if (!arguments.collisions.empty())
    collisions_ = std::make_unique<CollisionFile>(arguments.collisions);
  if (!arguments.exits.empty())
    exits_ = std::make_unique<ExitFile>(arguments.exits);
  if (!arguments.bag.empty())
  {
    bag_ = openBag(arguments.bag);
    FrameRates rates;
    rates.particles = arguments.bag_rate;
    add(*bag_.sink, rates, bag_.close);
  }
  if (!arguments.trajectory.empty())
  {
    trajectory_ = std::make_unique<TrajectoryFile>(arguments.trajectory);
    add(*trajectory_, trajectoryRates(arguments.trajectory_rate), [this] { trajectory_->commit(); });
  }
  if (arguments.page.isWanted())
  {
    page_file_ = std::make_unique<AtomicFile>(arguments.page.path);
    page_ = std::make_unique<RunPage>(arguments.page.bytes());
    // The name of the scene's file, without the folders of its writer.
    add(*page_, pageRates(arguments.page_rate),
        [this, scene = std::filesystem::path(arguments.scene).filename().string()]
        { page_->write(std::move(*page_file_), scene, page_summary_); });
  }
}

void RunOutputs::add(FrameSink& sink, const FrameRates& rates, std::function<void()> finish)
{
  sinks_.push_back(std::make_unique<GuardedSink>(attempts_, sink, std::move(finish)));
  streams_.push_back({sinks_.back().get(), rates});
}

void RunOutputs::watch(Simulation& simulation, RunWatchers& watchers)
{
  if (collisions_)
    simulation.observeCollisions([this](const CollisionRecord& record) { collisions_->add(record); });
  if (exits_)
    simulation.observeExits([this, &species = simulation.scene().species](const ExitRecord& record)
                            { exits_->add(record, species); });
  watchers.frames = streams_;
}

bool RunOutputs::finish(const nlohmann::ordered_json& summary)
{
  page_summary_ = summary;
  attempts_.attempt([&] { writeSummary(summary.dump(2) + "\n"); });
  if (collisions_)
    attempts_.attempt([this] { collisions_->commit(); });
  if (exits_)
    attempts_.attempt([this] { exits_->commit(); });
  for (const auto& sink : sinks_)
    attempts_.attempt([&sink] { sink->finish(); });
  return attempts_.complete();
}

void RunOutputs::writeSummary(const std::string& text)
{
  if (summary_)
  {
    summary_->stream() << text;
    summary_->commit();
  }
  else
    print(text);
}

}  // namespace ratchet_sieve
