#include <string>
#include <vector>

#include "become_program.h"
#include "command_line.h"
#include "ratchet_sieve/ros/bag_reader.h"

namespace
{

using namespace ratchet_sieve;

struct Arguments
{
  std::vector<std::string> bags;
  std::string sieve;
};

void describe(CLI::App& app, Arguments& arguments)
{
  app.add_option("BAG", arguments.bags, "A recorded run; all its files, where it was split")
      ->required()
      ->type_name("FILE");
  app.add_option("--sieve", arguments.sieve, "Node whose run it is to be; else any")->type_name("NAME");
  app.footer(
      "What follows `--` goes to `rosbag play`, such as --clock; so do ROS's own arguments.\n"
      "Exit status: 1 for a bag that cannot be shown, 2 for bad arguments; else that of rosbag.");
}

/// What is for this program alone comes before `--`.
struct SplitArguments
{
  std::vector<char*> own;
  std::vector<std::string> passed_on;
};

SplitArguments split(int argc, char** argv)
{
  SplitArguments arguments;
  bool behind = false;
  for (int k = 0; k < argc; ++k)
  {
    const std::string word = argv[k];
    if (!behind && word == "--")
      behind = true;
    else if (behind || word.find(":=") != std::string::npos)
      arguments.passed_on.push_back(word);
    else
      arguments.own.push_back(argv[k]);
  }
  return arguments;
}

int replay(const Arguments& arguments, const std::vector<std::string>& passed_on)
{
  for (const std::string& bag : arguments.bags)
    requireShowable(bag, arguments.sieve);
  std::vector<std::string> words = {"rosrun", "rosbag", "play"};
  words.insert(words.end(), passed_on.begin(), passed_on.end());
  words.insert(words.end(), arguments.bags.begin(), arguments.bags.end());
  return becomeProgram("sieve_replay", words);
}

}  // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  CLI::App app("Sees that a sieve can be shown from recorded bags, and becomes `rosbag play` of them.",
               "sieve_replay");
  describe(app, arguments);
  SplitArguments given = split(argc, argv);
  return runProgram(app, static_cast<int>(given.own.size()), given.own.data(),
                    [&] { return replay(arguments, given.passed_on); });
}
