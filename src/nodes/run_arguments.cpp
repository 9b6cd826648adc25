#include "run_arguments.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "command_line.h"
#include "key_table.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// The error in an option's time; empty if it is valid. The message of CLI11's validator would contain the
/// largest double, with all its digits.
std::string requireSeconds(const std::string& text)
{
  return std::strtod(text.c_str(), nullptr) >= 0.0 ? "" : text + ": must be 0 s or more";
}

/// The error in a rate of frames; empty if it is valid. See requireSeconds().
std::string requireRate(const std::string& text)
{
  const double rate = std::strtod(text.c_str(), nullptr);
  return rate >= 0.0 && rate <= MAX_FRAME_RATE
             ? ""
             : fmt::format("{}: must be a number from 0 to {:g} Hz", text, MAX_FRAME_RATE);
}

/// The error in an argument of --until: only some keys of accuracy decide when a run ends.
std::string requireCertaintyKey(const std::string& assignment)
{
  const std::string key = assignment.substr(0, assignment.find('='));
  std::string known;
  for (const std::string& name : certaintyKeyNames())
  {
    if (key == name)
      return "";
    known += (known.empty() ? "" : ", ") + name;
  }
  return key + ": unknown key; must be one of " + known;
}

/// What is run.
void describeScene(CLI::App& app, RunArguments& arguments)
{
  app.add_option("SCENE", arguments.scene, "Scene file (YAML)")->type_name("FILE");
  app.add_option("--set", arguments.overrides,
                 "Set a key of the scene, such as base.inclination=0.105 or species.0.radius=0.004, or take "
                 "it out (KEY=null); repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--seed", arguments.seed, "Set the seed")->type_name("N");
  app.add_option("--duration", arguments.duration, "Set the duration [s of simulated time]")->type_name("S");
  app.add_option(
         "--until", arguments.until,
         "Set accuracy.KEY, with KEY mean_vx [m/s], quality or confidence: the run ends before its duration "
         "once the results are known within these half-widths; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->check(requireCertaintyKey);
}

/// What is written.
void describeOutputs(CLI::App& app, RunArguments& arguments)
{
  CLI::Option* bag =
      app.add_option("--bag", arguments.bag, "Record the run into a ROS bag")->type_name("FILE");
  app.add_option(
         "--bag-rate", arguments.bag_rate,
         "Rate of the recorded frames of the disks [Hz of simulated time]; 0: only the first and the last")
      ->type_name("HZ")
      ->needs(bag)
      ->check(requireRate)
      ->capture_default_str();
  CLI::Option* trajectory =
      app.add_option(
             "--trajectory", arguments.trajectory,
             "Write the motion of the disks, and of the base beside it, as extended XYZ for OVITO and "
             "ASE; FILE ends in .xyz or .extxyz")
          ->type_name("FILE");
  app.add_option("--trajectory-rate", arguments.trajectory_rate,
                 "Rate of the frames of --trajectory [Hz of simulated time]; 0: only the first and the last")
      ->type_name("HZ")
      ->needs(trajectory)
      ->check(requireRate)
      ->capture_default_str();
  app.add_option("--html-rate", arguments.page_rate,
                 "Rate of the frames of --html, before they are thinned [Hz of simulated time]; 0: only the "
                 "first and the last")
      ->type_name("HZ")
      ->needs(describe(app, arguments.page))
      ->check(requireRate)
      ->capture_default_str();
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
      ->check(requireSeconds)
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
}

/// --keys is answered as soon as it is parsed, since it needs no scene.
void answerKeys(const std::vector<std::string>& parts)
{
  const std::string part = parts.empty() ? "" : parts.front();
  const std::string table = keyTable(part);
  if (table.empty())
    throw Refusal("--keys " + part + ": no key of a scene contains this");
  if (std::fputs(table.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw std::runtime_error("the keys could not be written to standard output");
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
  app.footer(
      "Exit status: 0 if the run is complete; 2 for bad arguments or a bad scene (nothing is written); 1 for "
      "any other "
      "failure, or if it was stopped.");
}

}  // namespace ratchet_sieve
