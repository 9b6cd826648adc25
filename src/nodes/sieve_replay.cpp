#include <string>
#include <vector>

#include "become_program.h"
#include "command_line.h"
#include "node_options.h"
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
  app.add_option("BAG", arguments.bags, "Bag of a recorded run; all files of a split one")
      ->required()
      ->type_name("FILE");
  app.add_option("--sieve", arguments.sieve, "Require that the bags are of the run of this node")
      ->type_name("NAME");
  app.footer(
      "Arguments after `--`, such as --clock, and remappings (NAME:=VALUE) are passed to `rosbag play`.\n"
      "Exit status: 1 for a bag that cannot be shown; 2 for bad arguments; otherwise that of `rosbag play`.");
}

/// Arguments of this program, which come before `--`, and those of rosbag.
struct SplitArguments
{
  std::vector<char*> own;
  std::vector<std::string> passed_on;
};

SplitArguments split(int argc, char** argv)
{
  SplitArguments arguments;
  bool after_dashes = false;
  for (int k = 0; k < argc; ++k)
  {
    const std::string word = argv[k];
    if (!after_dashes && word == "--")
      after_dashes = true;
    else if (after_dashes || word.find(":=") != std::string::npos)
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
  writeLogByLines();
  return becomeProgram("sieve_replay", words);
}

}  // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  CLI::App app("Check that recorded bags can be shown, then play them with `rosbag play`.", "sieve_replay");
  describe(app, arguments);
  SplitArguments given = split(argc, argv);
  return runProgram(app, static_cast<int>(given.own.size()), given.own.data(),
                    [&] { return replay(arguments, given.passed_on); });
}
