// Runs a scene file with the engine and prints its collisions.
#include <ratchet_sieve/core/simulation.h>
#include <ratchet_sieve/recording/summary.h>
#include <ratchet_sieve/scene/scene_file.h>
#include <iostream>

int main(int, char** arguments)
{
  ratchet_sieve::Simulation simulation(ratchet_sieve::loadSceneFile(arguments[1]).definition);
  simulation.advanceTo(0.1);
  std::cout << nlohmann::ordered_json(simulation.collisions()) << '\n';
}
