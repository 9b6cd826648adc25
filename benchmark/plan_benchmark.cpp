// Each choice of a scene's plan, on a scene that does without: `plan/CHOICE/full` works it out all the same,
// `plan/CHOICE/lean` leaves it out. plan_ratios.py sets them beside each other.
#include <string>

#include <benchmark/benchmark.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// For each choice the same number of strides, so that both run the same path.
constexpr int STRIDES = 30;

struct Choice
{
  const char* name;
  bool Plan::*what;
  SceneDefinition scene;
  double stride;  ///< of simulated time per iteration [s]
};

SceneDefinition smooth(SceneDefinition scene)
{
  for (SpeciesDefinition& species : scene.species)
    species.contact.friction = 0.0;
  return scene;
}

SceneDefinition still(SceneDefinition scene)
{
  scene.base.amplitude = 0.0;
  return scene;
}

/// Disks side by side that hop on the spot, on a flat and smooth base: neighbours that never touch, so that
/// it is one physics whether they see each other or not.
SceneDefinition hopping()
{
  constexpr int TEETH = 40;
  constexpr int DISKS_PER_TOOTH = 5;
  SceneDefinition scene = smooth(test::singleParticles(0));
  scene.base.teeth = TEETH;
  scene.base.tooth_height = 0.0;
  for (int i = 0; i < TEETH * DISKS_PER_TOOTH; ++i)
  {
    const double x = (i + 0.5) * scene.base.tooth_width / DISKS_PER_TOOTH;
    scene.initial.push_back({0, x, 0.01 + 1e-5 * (i % 37), 0.0, 0.0, 0.0});
  }
  return scene;
}

void run(benchmark::State& state, Choice choice, bool full)
{
  // Disks that see each other are another scene, not only another plan.
  if (choice.what == &Plan::pairs)
    choice.scene.contact.pair_collisions = full;
  Plan plan = planOf(choice.scene);
  plan.*choice.what = full;
  Simulation simulation(choice.scene, plan);
  simulation.advanceTo(0.5);
  const auto before = simulation.collisions().total();
  for (auto _ : state)
    simulation.advanceTo(simulation.time() + choice.stride);
  state.counters["collisions"] = static_cast<double>(simulation.collisions().total() - before);
}

[[maybe_unused]] const bool REGISTERED = []
{
  const SceneDefinition layer = test::mixture(262);
  // Between walls: the SIMD batches of a periodic base evaluate everything for all at once.
  SceneDefinition singles = test::singleParticles(1000);
  singles.boundary = Boundary::WALLED;
  for (const Choice& choice : {
           Choice{"pairs of single disks", &Plan::pairs, hopping(), 0.2},
           Choice{"spin in a layer", &Plan::spin, smooth(layer), 0.1},
           Choice{"spin of single disks", &Plan::spin, smooth(singles), 0.1},
           Choice{"drive under a layer", &Plan::drive, still(layer), 0.05},
           Choice{"drive under single disks", &Plan::drive, still(singles), 0.1},
           Choice{"search above the band for a layer", &Plan::search_above_band, layer, 0.1},
           Choice{"search above the band for single disks", &Plan::search_above_band, singles, 0.1},
           Choice{"contact times in a layer", &Plan::contact_times, layer, 0.1},
       })
    for (const bool full : {true, false})
    {
      const std::string name = std::string("plan/") + choice.name + (full ? "/full" : "/lean");
      benchmark::RegisterBenchmark(name.c_str(), run, choice, full)
          ->Iterations(STRIDES)
          ->Unit(benchmark::kMillisecond);
    }
  return true;
}();

}  // namespace
}  // namespace ratchet_sieve
