#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command_line.h"
#include "ratchet_sieve/bag/bag_error.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/recording/resimulation.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/ros/bag_reader.h"

namespace
{

using namespace ratchet_sieve;

/// Other versions may round differently: said before a difference is.
void warnOfVersion(const Resimulation& resimulation)
{
  if (const auto& scene = resimulation.scene(); scene && scene->version != version())
    fmt::print(stderr, "sieve_resimulate: warning: recorded by version {}, this is {}\n", scene->version,
               version());
}

int resimulate(const std::vector<std::string>& bags)
{
  std::optional<ProgressBar> progress;
  Resimulation resimulation(
      [&](const Simulation& simulation)
      {
        if (!progress)
          progress.emplace(simulation);
        progress->show(simulation);
      });
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
    fmt::print("differs: {}\n", *difference);
    return FAILED;
  }
  fmt::print("the same, bit for bit: {} frames over {:g} s, with {} commands\n", resimulation.frames(),
             resimulation.time() - resimulation.scene()->start_time, resimulation.commands());
  return DONE;
}

}  // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> bags;
  CLI::App app(
      "Runs a recorded run again, from its scene, seed and commands, and says whether every recorded\n"
      "state comes out bit for bit.",
      "sieve_resimulate");
  app.add_option("BAG", bags, "A recorded run: its bag, or all the files of a split one")
      ->required()
      ->type_name("FILE");
  app.footer("Exit status: 0 the same; 1 it differs, or the bag cannot be read; 2 bad arguments.");
  return runProgram(app, argc, argv, [&] { return resimulate(bags); });
}
