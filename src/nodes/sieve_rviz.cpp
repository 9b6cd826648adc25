#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <unistd.h>

#include "node_options.h"
#include "ratchet_sieve/SceneDescription.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/ros/rviz_view.h"
#include "ratchet_sieve/ros/sieve_search.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace
{
using namespace ratchet_sieve;

constexpr const char* HELP =
    "Opens RViz on a sieve, its camera moved so that all of the machine is in the picture.\n"
    "\n"
    "Usage: rosrun ratchet_sieve sieve_rviz CONFIG.rviz [RVIZ ARGUMENT...] [ROS ARGUMENT...]\n"
    "\n"
    "Waits for the scene of the sieve, and becomes RViz. Parameters: ~sieve, the name of the sieve's node,\n"
    "/sieve by default; empty: the sieve that there is. ~view, what the camera shows: machine, all of it\n"
    "(default); teeth, ten in the middle of the base; config, what CONFIG.rviz says, and no scene is waited\n"
    "for. RViz gets a copy of CONFIG.rviz, in ~/.ros; for config CONFIG.rviz itself.\n"
    "Exit status: 2 for bad arguments or a bad parameter, 1 where RViz cannot be run; else RViz's own.\n";

constexpr double PATIENCE = 0.1;  // between looks whether the scene has come [s of wall time]

/// Ahead of Xlib in RViz: see rviz_windows.cpp.
constexpr const char* RVIZ_WINDOWS = "libratchet_sieve_rviz_windows.so";

std::string contents(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf()))
    throw std::invalid_argument(path + ": cannot be read");
  return text.str();
}

/// The scene of a sieve, when it has come; nothing where this program is stopped before.
/// @param sieve name of its node; empty: the one that there is
std::optional<SceneDefinition> waitForScene(ros::NodeHandle& node, std::string sieve)
{
  std::optional<SceneDefinition> scene;
  ros::Subscriber subscriber;
  while (ros::ok() && !scene)
  {
    if (sieve.empty())
      sieve = findSieve().value_or("");
    if (!subscriber && !sieve.empty())
      subscriber =
          node.subscribe<SceneDescription>(sieve + "/scene", 1,
                                           [&scene](const SceneDescription::ConstPtr& message)
                                           { scene = sceneFromText(message->yaml, "scene").definition; });
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(PATIENCE));
    if (!subscriber)
      ros::WallDuration(PATIENCE).sleep();
  }
  return scene;
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
  std::string path = directory / (node_name.substr(node_name.rfind('/') + 1) + ".rviz");
  AtomicFile file(path);
  file.stream() << config;
  file.commit();
  return path;
}

/// The configuration that RViz is to have, as a file; nothing where this program is stopped before it is
/// known.
std::optional<std::string> chosenConfig(const std::string& path)
{
  const std::string config = contents(path);
  ros::NodeHandle node("~");
  ParameterReader reader(node);
  const std::string view = reader.text("view", "machine");
  if (view == "config")
    return path;
  if (view != "machine" && view != "teeth")
    throw std::invalid_argument("~view = " + view + ": must be machine, teeth or config");
  const auto scene = waitForScene(node, reader.text("sieve", "/sieve"));
  if (!scene)
    return {};
  return writtenToFile(fittedToScene(config, *scene, view == "teeth" ? RvizView::TEETH : RvizView::MACHINE),
                       ros::this_node::getName());
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

/// @param arguments as given, those of ROS as well: RViz is to have this node's name
int becomeRviz(const std::string& config, const std::vector<std::string>& arguments)
{
  std::vector<std::string> words = {"rviz", "-d", config};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  preload(RVIZ_WINDOWS);
  execvp("rviz", argv.data());
  std::fprintf(stderr, "sieve_rviz: rviz cannot be run: %s\n", std::strerror(errno));
  return 1;
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
    ros::init(argc, argv, "sieve_rviz");
    const std::optional<std::string> chosen = chosenConfig(path);
    ros::shutdown();
    return chosen ? becomeRviz(*chosen, arguments) : 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_rviz: %s\n", error.what());
    return 2;
  }
}
