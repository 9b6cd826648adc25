#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command_line.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/recording/resimulation.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/ros/bag.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace
{

using namespace ratchet_sieve;

/// Other versions may round differently. Called before a difference is printed.
void warnOfVersion(const Resimulation& resimulation)
{
  if (const auto& scene = resimulation.scene(); scene && scene->version != version())
    fmt::print(stderr, "sieve_resimulate: warning: recorded by version {}, this is {}\n", scene->version,
               version());
}

int resimulate(const std::vector<std::string>& bags)
{
  std::optional<ProgressBar> progress(std::in_place);
  Resimulation resimulation([&](const Simulation& simulation) { progress->show(simulation); });
  try
  {
    readBags(bags, resimulation);
    resimulation.finish();
  }
  catch (const BagError&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw BagError(bags.front() + ": " + error.what());
  }
  progress.reset();
  warnOfVersion(resimulation);
  if (const auto& difference = resimulation.difference())
  {
    print(resimulation.lacksCommands() ? fmt::format("{}: cannot be repeated\n", *difference)
                                       : fmt::format("differs: {}\n", *difference));
    return FAILED;
  }
  print(fmt::format(
      "the same, bit for bit: {} over {:g} s, with {}\n", countText(resimulation.frames(), "frame"),
      resimulation.time() - resimulation.scene()->start_time, countText(resimulation.commands(), "command")));
  return DONE;
}

}  // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> bags;
  CLI::App app(
      "Run a recorded run again, from its scene, seed and commands, and compare every recorded state bit for "
      "bit.",
      "sieve_resimulate");
  app.add_option("BAG", bags, "Bag of a recorded run; all files of a split one")
      ->required()
      ->type_name("FILE");
  app.footer(
      "Exit status: 0 if all states are the same; 1 if one differs (a line that begins with 'differs: '), if "
      "the bag lacks commands (a line that ends with ': cannot be repeated'), or if it cannot be read; 2 for "
      "bad arguments.");
  return runProgram(app, argc, argv, [&] { return resimulate(bags); });
}
