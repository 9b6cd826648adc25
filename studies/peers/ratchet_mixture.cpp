#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "mixture_run.h"

namespace
{

using namespace ratchet_sieve;
using peers::Point;

void printStart(const SceneDefinition& scene)
{
  nlohmann::json disks = nlohmann::json::array();
  for (const DiskState& disk : peers::startOf(scene))
    disks.push_back({disk.species, disk.x, disk.y});
  std::printf("%s\n", disks.dump().c_str());
}

/// Takes a sample with the clock stopped.
void look(Simulation& simulation, peers::Watch& watch, bool restart)
{
  std::vector<double> x;
  std::vector<Point> places;
  for (const DiskState& disk : simulation.disks())
  {
    x.push_back(disk.displacement);
    places.push_back({disk.x, disk.y});
  }
  if (restart)
    watch.restart(simulation.time(), x);
  else
    watch.look(simulation.time(), simulation.base().displacement, x, places);
}

void run(const SceneDefinition& scene, const peers::RunOptions& options, const std::string& configuration)
{
  Simulation simulation(scene);
  std::vector<std::uint32_t> species;
  for (const DiskState& disk : simulation.disks())
    species.push_back(disk.species);
  peers::Watch watch(scene, species);
  simulation.advanceTo(options.settle);
  look(simulation, watch, true);
  const auto before = simulation.collisions().total();
  peers::StopWatch clock;
  for (long k = 1; k <= std::lround(options.duration / peers::LOOK); ++k)
  {
    clock.start();
    simulation.advanceTo(options.settle + static_cast<double>(k) * peers::LOOK);
    clock.stop();
    look(simulation, watch, false);
  }
  peers::Outcome outcome;
  outcome.program = "ratchet_sieve";
  outcome.configuration = configuration;
  outcome.wall_seconds = clock.wallSeconds();
  outcome.processor_seconds = clock.processorSeconds();
  outcome.collisions = static_cast<double>(simulation.collisions().total() - before);
  peers::print(outcome, options, watch);
}

}  // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> chosen;
  const peers::RunOptions options = peers::readOptions(
      argc, argv, "ratchet_sieve",
      {{"--tangential", {"scene", "none"}, "beta: the scene's 0.4, or 0 as in programs that do not have it"},
       {"--print", {"run", "start"}, "start: print the disks' species, x and y at t = 0, and run nothing"}},
      &chosen);
  SceneDefinition scene = peers::mixtureScene(options.seed);
  if (chosen[0] == "none")
    for (SpeciesDefinition& kind : scene.species)
      kind.contact.tangential_restitution = 0.0;
  if (chosen[1] == "start")
    printStart(scene);
  else
    run(scene, options, chosen[0] == "none" ? "beta = 0" : "beta = 0.4");
}
