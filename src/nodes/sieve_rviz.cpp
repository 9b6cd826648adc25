#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "become_program.h"
#include "node_options.h"
#include "ratchet_sieve/SceneDescription.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/ros/rviz_view.h"
#include "ratchet_sieve/ros/sieve_search.h"
#include "ratchet_sieve/scene/input_file.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace
{
using namespace ratchet_sieve;

constexpr const char* HELP =
    "Open RViz on a sieve, with the camera on the whole machine.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_rviz [--help | --version]\n"
    "       rosrun ratchet_sieve sieve_rviz CONFIG.rviz [RVIZ ARGUMENT...] [ROS ARGUMENT...]\n"
    "\n"
    "Waits for the scene of the sieve and for a node that draws it (the sieve itself or sieve_display),\n"
    "then starts RViz on a copy of CONFIG.rviz in ~/.ros.\n"
    "\n"
    "Parameters:\n"
    "  ~sieve  name of the sieve's node; empty: the only sieve (default: sieve)\n"
    "  ~view   what the camera shows: the whole machine (machine), ten teeth in the middle of the base\n"
    "          (teeth), or what CONFIG.rviz says, without waiting (config) (default: machine)\n"
    "\n"
    "Exit status: 2 for bad arguments or a bad parameter; 1 if RViz cannot be run; otherwise RViz's.\n";

// All in wall time [s].
constexpr double POLL_PERIOD = 0.1;   // between two checks for the scene
constexpr double WARN_AFTER = 5.0;    // until the first warning that it is missing
constexpr double WARN_PERIOD = 30.0;  // between two warnings

/// Name of the node whose topics the configuration shows.
constexpr const char* SHOWN = "/sieve";

/// Warns periodically why nothing is shown yet.
class WaitingLog
{
public:
  void say(const std::function<std::string()>& why)
  {
    const ros::WallTime now = ros::WallTime::now();
    if (now < next_)
      return;
    next_ = now + ros::WallDuration(WARN_PERIOD);
    ROS_WARN("waiting: %s", why().c_str());
  }

private:
  ros::WallTime next_ = ros::WallTime::now() + ros::WallDuration(WARN_AFTER);
};

/// Preloaded into RViz before Xlib: see rviz_windows.cpp.
constexpr const char* RVIZ_WINDOWS = "libratchet_sieve_rviz_windows.so";

std::string contents(const std::string& path)
{
  if (const auto why = whyUnreadable(path))
    throw std::invalid_argument(path + ": " + *why);
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The scene of a sieve and its frame.
struct PlacedScene
{
  SceneDefinition definition;
  std::string frame_id;
};

/// Waits for the scene. @return nothing if this program is stopped before
/// @param sieve name of its node; empty: the only sieve
std::optional<PlacedScene> waitForScene(ros::NodeHandle node, std::string sieve)
{
  std::optional<PlacedScene> scene;
  ros::Subscriber subscriber;
  WaitingLog log;
  while (ros::ok() && !scene)
  {
    log.say([&] { return missingSieveText(sieve.empty() ? sieve : ros::names::resolve(sieve)); });
    if (sieve.empty())
      sieve = findSieve().value_or("");
    if (!subscriber && !sieve.empty())
      subscriber = node.subscribe<SceneDescription>(
          ros::names::resolve(sieve) + "/scene", 1,
          [&scene](const SceneDescription::ConstPtr& message) {
            scene = {sceneFromText(message->yaml, "scene").definition, message->header.frame_id};
          });
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(POLL_PERIOD));
    if (!subscriber)
      ros::WallDuration(POLL_PERIOD).sleep();
  }
  return scene;
}

/// Waits for the node that draws the sieve: the one that the launch names, or else the only one.
std::optional<std::string> waitForDisplay()
{
  const std::string markers = ros::names::resolve(std::string(SHOWN) + "/markers");
  const std::string named = markers.substr(0, markers.rfind('/'));
  WaitingLog log;
  std::optional<std::string> display;
  while (ros::ok() && !(display = findDisplay(named)))
  {
    log.say(
        []
        {
          return "no node draws the sieve: to show a played bag, also run `rosrun ratchet_sieve "
                 "sieve_display`";
        });
    ros::WallDuration(POLL_PERIOD).sleep();
  }
  return display;
}

/// Writes the configuration into ~/.ros, under the name of this node. @return its path
std::string writtenToFile(const std::string& config, const std::string& node_name)
{
  const char* ros_home = std::getenv("ROS_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path directory = ros_home != nullptr
                                              ? std::filesystem::path(ros_home)
                                              : std::filesystem::path(home ? home : "/tmp") / ".ros";
  std::filesystem::create_directories(directory);
  // Nodes with the same name may run in different namespaces.
  std::string file_name = node_name.substr(1);
  std::replace(file_name.begin(), file_name.end(), '/', '_');
  std::string path = directory / (file_name + ".rviz");
  AtomicFile file(path);
  file.stream() << config;
  file.commit();
  return path;
}

/// Makes the program that replaces this one load a library of this package before all others.
void preload(const char* library)
{
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  std::string libraries = program.parent_path().parent_path() / library;
  if (const char* others = std::getenv("LD_PRELOAD"))
    libraries += std::string(":") + others;
  setenv("LD_PRELOAD", libraries.c_str(), 1);
}

/// @param frame_id RViz's fixed frame, unless the arguments contain one; empty: that of the configuration
/// @param arguments as given, including those of ROS, so that RViz has the name of this node
int becomeRviz(const std::string& config, const std::string& frame_id,
               const std::vector<std::string>& arguments)
{
  std::vector<std::string> words = {"rviz", "-d", config};
  const auto given = [&](const char* option)
  { return std::find(arguments.begin(), arguments.end(), option) != arguments.end(); };
  if (!frame_id.empty() && !given("-f") && !given("--fixed-frame"))
    words.insert(words.end(), {"-f", frame_id});
  words.insert(words.end(), arguments.begin(), arguments.end());
  preload(RVIZ_WINDOWS);
  return becomeProgram("sieve_rviz", words);
}

/// Waits for a sieve and starts RViz with its camera on it. @return 0 if this program is stopped before
int showSieve(const std::string& config, const std::string& view, std::vector<std::string> arguments)
{
  if (view != "machine" && view != "teeth")
    throw std::invalid_argument("~view = " + view + ": must be machine, teeth or config");
  const ros::NodeHandle node("~");  // the node ends with its last handle
  const auto scene = waitForScene(node, ParameterReader(node).text("sieve", DEFAULT_SIEVE));
  const std::optional<std::string> display = scene ? waitForDisplay() : std::nullopt;
  ros::shutdown();
  if (!display)
    return 0;
  // The last of two remappings of one name applies.
  for (const std::string topic : {"/markers", "/cloud"})
    arguments.push_back(std::string(SHOWN).append(topic).append(":=").append(*display).append(topic));
  const RvizView shown = view == "teeth" ? RvizView::TEETH : RvizView::MACHINE;
  return becomeRviz(writtenToFile(fittedToScene(config, scene->definition, shown), ros::this_node::getName()),
                    scene->frame_id, arguments);
}
}  // namespace

int main(int argc, char** argv)
{
  if (answerOptions(argc, argv, "sieve_rviz", HELP))
    return 0;
  writeLogByLines();
  if (argc < 2)
  {
    std::fputs("sieve_rviz: no configuration is given; see --help\n", stderr);
    return 2;
  }
  const std::string path = argv[1];
  const std::vector<std::string> arguments(argv + 2, argv + argc);
  try
  {
    const std::string config = contents(path);
    ros::init(argc, argv, "sieve_rviz");
    const std::string view = ParameterReader(ros::NodeHandle("~")).text("view", "machine");
    if (view != "config")
      return showSieve(config, view, arguments);
    ros::shutdown();
    return becomeRviz(path, "", arguments);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_rviz: %s\n", error.what());
    return 2;
  }
}
