#include "run_arguments.h"

#include <algorithm>

#include <fmt/format.h>

#include "command_line.h"
#include "ratchet_sieve/scene/key_list.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// The error in an argument of --until: only some keys of accuracy decide when a run ends.
std::string requireCertaintyKey(const std::string& assignment)
{
  const std::string key = assignment.substr(0, assignment.find('='));
  const std::vector<std::string> known = certaintyKeyNames();
  return std::count(known.begin(), known.end(), key) > 0
             ? ""
             : fmt::format("{}: unknown key; must be one of {}", key, fmt::join(known, ", "));
}

/// What is run. The rules of the scene check the values of all options that set its keys. --set is the first:
/// it replaces the list of assignments, the others add to it.
void describeScene(CLI::App& app, RunArguments& arguments)
{
  const auto setting = [&arguments](const std::string& begin)
  { return [&arguments, begin](const std::string& rest) { arguments.overrides.push_back(begin + rest); }; };
  app.add_option("SCENE", arguments.scene, "Scene file (YAML)")->type_name("FILE");
  app.add_option("--set", arguments.overrides,
                 "Set a key of the scene, such as base.inclination=0.105 or species.0.radius=0.004, or take "
                 "it out (KEY=null); repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option_function<std::string>("--seed", setting("seed="), "Set the seed")->type_name("N");
  app.add_option_function<std::string>("--duration", setting("duration="),
                                       "Set the duration [s of simulated time]")
      ->type_name("S");
  app.add_option_function<std::vector<std::string>>(
         "--until",
         [&arguments](const std::vector<std::string>& all)
         {
           for (const std::string& assignment : all)
             arguments.overrides.push_back("accuracy." + assignment);
         },
         "Set accuracy.KEY, with KEY mean_vx [m/s], quality or confidence: the run ends before its duration "
         "once the results are known within these half-widths; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->check(requireCertaintyKey);
}

/// What is written.
void describeOutputs(CLI::App& app, RunArguments& arguments)
{
  const auto rate = [&app](const char* name, double& value, CLI::Option* of, const char* text)
  {
    app.add_option(name, value, text)
        ->type_name("HZ")
        ->needs(of)
        ->check(within(0.0, MAX_FRAME_RATE, "Hz"))
        ->capture_default_str();
  };
  CLI::Option* bag =
      app.add_option("--bag", arguments.bag, "Record the run into a ROS bag")->type_name("FILE");
  rate("--bag-rate", arguments.bag_rate, bag,
       "Rate of the recorded frames of the disks [Hz of simulated time]; 0: only the first and the last");
  CLI::Option* trajectory =
      app.add_option(
             "--trajectory", arguments.trajectory,
             "Write the motion of the disks, and of the base beside it, as extended XYZ for OVITO and "
             "ASE; FILE ends in .xyz or .extxyz")
          ->type_name("FILE");
  rate("--trajectory-rate", arguments.trajectory_rate, trajectory,
       "Rate of the frames of --trajectory [Hz of simulated time]; 0: only the first and the last");
  rate("--html-rate", arguments.page_rate, describe(app, arguments.page),
       "Rate of the frames of --html, before they are thinned [Hz of simulated time]; 0: only the first and "
       "the last");
  app.add_option("--collisions", arguments.collisions, "Write every collision to a CSV file")
      ->type_name("FILE");
  app.add_option(
         "--exits", arguments.exits,
         "Write every disk that leaves the machine to a CSV file, which feed.file of another scene reads")
      ->type_name("FILE");
  app.add_option("--summary", arguments.summary, "Write the summary to a file instead of standard output")
      ->type_name("FILE");
}

/// How it is run.
void describeRun(CLI::App& app, RunArguments& arguments)
{
  app.add_option("--checkpoint", arguments.checkpoint,
                 "Save the run periodically, when it is stopped, and at its end")
      ->type_name("FILE");
  app.add_option("--checkpoint-every", arguments.checkpoint_every, "Period of --checkpoint [s of wall time]")
      ->type_name("S")
      ->check(within(0.0, 1e9, "s"))
      ->capture_default_str();
  app.add_option(
         "--resume", arguments.resume,
         "Continue the run saved in a checkpoint until the end of the scene, bit for bit as without the "
         "interruption; of the scene only duration and the keys of --until may differ")
      ->type_name("FILE");
  app.add_flag(
      "--check-floor", arguments.check_floor,
      "Run the scene again at a half and a quarter of contact.min_rebound_speed; print whether the results "
      "depend on it, and add floor_check to the summary");
  app.add_option("--threads", arguments.threads,
                 "Number of threads, at most 256; 0: one per processor. A run takes as many as its disks are "
                 "worth; the "
                 "results are the same")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{0}, MOST_THREADS))
      ->capture_default_str();
  app.add_flag("-v,--verbose", arguments.verbose,
               "Say which parts of the model are computed; the summary has it as plan");
}

std::string rowOf(const KeyText& text)
{
  return fmt::format("{:<38}  {:<7}  {:<6}  {:<25}  {}\n", text.key, text.type,
                     text.unit.empty() ? "-" : text.unit, text.values, text.default_text);
}

/// A heading for each part of a scene, two lines for each of its keys. Cells are at least two spaces apart,
/// which no cell contains; docs/scenes.md is made from it.
/// @param part only keys that contain this @return an empty text if there is none
std::string keyTable(const std::string& part)
{
  std::string table;
  for (const KeyGroup& group : sceneKeyGroups())
  {
    std::string rows;
    for (const KeyText& key : group.keys)
      if (key.key.find(part) != std::string::npos)
        rows += rowOf(key) + wrappedText(key.meaning, 4);
    if (!rows.empty())
      table += fmt::format("{}{}: {}\n\n", table.empty() ? "" : "\n",
                           group.name.empty() ? "scene" : group.name, group.meaning) +
               rows;
  }
  if (table.empty())
    return "";
  return rowOf({"KEY", "TYPE", "UNIT", "ALLOWED", "DEFAULT", ""}) + "\n" + table;
}

/// --keys is answered as soon as it is parsed, since it needs no scene.
void answerKeys(const std::vector<std::string>& parts)
{
  const std::string part = parts.empty() ? "" : parts.front();
  const std::string table = keyTable(part);
  if (table.empty())
    throw Refusal("--keys " + part + ": no key of a scene contains this");
  print(table);
  throw CLI::Success();
}

}  // namespace

void describe(CLI::App& app, RunArguments& arguments)
{
  app.add_option_function<std::vector<std::string>>(
         "--keys", answerKeys, "Print every key of a scene, or only those whose name contains PART, and exit")
      ->type_name("[PART]")
      ->expected(0, 1);
  describeScene(app, arguments);
  describeOutputs(app, arguments);
  describeRun(app, arguments);
  // As of a variable of a shell that is not set: the output would be lost without a word.
  for (CLI::Option* option :
       app.get_options([](CLI::Option* each) { return each->get_type_name() == "FILE"; }))
    option->check([](const std::string& path)
                  { return std::string(path.empty() ? "the name of a file must not be empty" : ""); });
  app.footer(
      "Exit status: 0 if the run is complete; 2 for bad arguments or a bad scene (nothing is written); 1 for "
      "any other "
      "failure, or if it was stopped.");
}

}  // namespace ratchet_sieve
