#include <algorithm>
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
    "Waits for the scene of the sieve, and becomes RViz. Parameter: ~sieve, the name of the sieve's node,\n"
    "`sieve` by default; empty: the sieve that there is. RViz gets a copy of CONFIG.rviz, in ~/.ros.\n"
    "Exit status: 2 for bad arguments or a bad parameter, 1 where RViz cannot be run; else RViz's own.\n";

constexpr double PATIENCE = 0.1;  // between looks whether the scene has come [s of wall time]

std::string contents(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf()))
    throw std::invalid_argument(path + ": cannot be read");
  return text.str();
}

/// The scene of a sieve and the frame in which it stands.
struct PlacedScene
{
  SceneDefinition definition;
  std::string frame_id;
};

/// The scene, when it has come; nothing where this program is stopped before.
std::optional<PlacedScene> waitForScene()
{
  ros::NodeHandle node("~");
  std::string sieve = ParameterReader(node).text("sieve", DEFAULT_SIEVE);
  std::optional<PlacedScene> scene;
  ros::Subscriber subscriber;
  while (ros::ok() && !scene)
  {
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

/// @param frame_id that RViz holds still, unless the arguments say another
/// @param arguments as given, those of ROS as well: RViz is to have this node's name
int becomeRviz(const std::string& config, const std::string& frame_id,
               const std::vector<std::string>& arguments)
{
  std::vector<std::string> words = {"rviz", "-d", config};
  const auto given = [&](const char* option)
  { return std::find(arguments.begin(), arguments.end(), option) != arguments.end(); };
  if (!given("-f") && !given("--fixed-frame"))
    words.insert(words.end(), {"-f", frame_id});
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
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
    const std::string config = contents(path);
    ros::init(argc, argv, "sieve_rviz");
    const std::optional<PlacedScene> scene = waitForScene();
    ros::shutdown();
    if (!scene)
      return 0;
    return becomeRviz(writtenToFile(fittedToScene(config, scene->definition), ros::this_node::getName()),
                      scene->frame_id, arguments);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "sieve_rviz: %s\n", error.what());
    return 2;
  }
}
