#include <cmath>

#include "mixture_run.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/scene/scene_file.h"

int main(int argc, char** argv)
{
  using namespace ratchet_sieve;
  const nlohmann::json run = peers::readRun(argc, argv);
  Simulation simulation(loadSceneFile(run["file"], run["set"]).definition);
  const std::vector<DiskState> start = simulation.disks();
  peers::Samples samples(run);
  const auto look = [&]
  {
    std::vector<peers::Point> places;
    for (const DiskState& disk : simulation.disks())
      places.push_back({start[places.size()].x + disk.displacement, disk.y});
    samples.write(simulation.time(), simulation.base().displacement, places);
  };

  const double settle = run["settle"];
  const double interval = run["look"];
  simulation.advanceTo(settle);
  look();
  const auto before = simulation.collisions().total();
  peers::StopWatch clock;
  for (long k = 1; k <= std::lround(run["duration"].get<double>() / interval); ++k)
  {
    clock.start();
    simulation.advanceTo(settle + static_cast<double>(k) * interval);
    clock.stop();
    look();
  }
  nlohmann::json outcome = clock.outcome("", simulation.collisions().total() - before, 0);
  for (const DiskState& disk : start)
    outcome["disks"].push_back({disk.species, disk.x, disk.y});
  std::printf("%s\n", outcome.dump().c_str());
}
