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
    "Opens RViz on a sieve, its camera moved so that all of the machine is in the picture.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_rviz CONFIG.rviz [RVIZ ARGUMENT...] [ROS ARGUMENT...]\n"
    "\n"
    "Waits for the scene of the sieve and for a node that draws it (the sieve itself, or sieve_display),\n"
    "and becomes RViz. Parameters: ~sieve, the name of the sieve's node, `sieve` by default; empty: the\n"
    "sieve that there is. ~view, what the camera shows: machine, all of it (default); teeth, ten in the\n"
    "middle of the base; config, what CONFIG.rviz says, and nothing is waited for. RViz gets a copy of\n"
    "CONFIG.rviz, in ~/.ros; for config CONFIG.rviz itself.\n"
    "Exit status: 2 for bad arguments or a bad parameter, 1 where RViz cannot be run; else RViz's own.\n";

// All of wall time [s].
constexpr double PATIENCE = 0.1;    // between checks whether the scene has come
constexpr double SILENCE = 5.0;     // after which it is said that it has not
constexpr double SAY_AGAIN = 30.0;  // between two lines that do

/// The node whose topics the configuration shows, by its name.
constexpr const char* SHOWN = "/sieve";

/// Logs from time to time why nothing is shown yet.
class WaitingLog
{
public:
  void say(const std::function<std::string()>& why)
  {
    const ros::WallTime now = ros::WallTime::now();
    if (now < next_)
      return;
    next_ = now + ros::WallDuration(SAY_AGAIN);
    ROS_WARN("waiting: %s", why().c_str());
  }

private:
  ros::WallTime next_ = ros::WallTime::now() + ros::WallDuration(SILENCE);
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

/// The scene of a sieve and the frame in which it stands.
struct PlacedScene
{
  SceneDefinition definition;
  std::string frame_id;
};

/// The scene, when it has come; nothing where this program is stopped before.
/// @param sieve name of its node; empty: the one that there is
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
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(PATIENCE));
    if (!subscriber)
      ros::WallDuration(PATIENCE).sleep();
  }
  return scene;
}

/// The node that draws the sieve: the one that the launch names, or else the one that there is.
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
          return "nothing draws the sieve: a bag that is played needs `rosrun ratchet_sieve sieve_display` "
                 "beside it";
        });
    ros::WallDuration(PATIENCE).sleep();
  }
  return display;
}

/// Beside the logs of ROS, named after this node. @return its path
std::string writtenToFile(const std::string& config, const std::string& node_name)
{
  const char* ros_home = std::getenv("ROS_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path directory = ros_home != nullptr
                                              ? std::filesystem::path(ros_home)
                                              : std::filesystem::path(home ? home : "/tmp") / ".ros";
  std::filesystem::create_directories(directory);
  // Nodes of one name in different namespaces run side by side.
  std::string file_name = node_name.substr(1);
  std::replace(file_name.begin(), file_name.end(), '/', '_');
  std::string path = directory / (file_name + ".rviz");
  AtomicFile file(path);
  file.stream() << config;
  file.commit();
  return path;
}

/// Has the programs that this one becomes load a library of this package, first of all.
void preload(const char* library)
{
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  std::string libraries = program.parent_path().parent_path() / library;
  if (const char* others = std::getenv("LD_PRELOAD"))
    libraries += std::string(":") + others;
  setenv("LD_PRELOAD", libraries.c_str(), 1);
}

/// @param frame_id that RViz holds still, unless the arguments say another; empty: the configuration's
/// @param arguments as given, those of ROS as well: RViz is to have this node's name
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

/// RViz with its camera on the sieve, once there is one; nothing where this program is stopped before.
int showSieve(const std::string& config, const std::string& view, std::vector<std::string> arguments)
{
  if (view != "machine" && view != "teeth")
    throw std::invalid_argument("~view = " + view + ": must be machine, teeth or config");
  const ros::NodeHandle node("~");  // with the last of its handles, this node would end
  const auto scene = waitForScene(node, ParameterReader(node).text("sieve", DEFAULT_SIEVE));
  const std::optional<std::string> display = scene ? waitForDisplay() : std::nullopt;
  ros::shutdown();
  if (!display)
    return 0;
  // Of two remappings of one name the last holds.
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
