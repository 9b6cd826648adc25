#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "events/engine.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "simd/simd_batch.h"

namespace ratchet_sieve
{
namespace
{

using benchmark::Counter;

/// Advances a simulation by `stride` [s] of simulated time per iteration; counts collisions and
/// simulated seconds per second of processor time.
void advance(benchmark::State& state, Simulation& simulation, double stride)
{
  const auto before = simulation.collisions().total();
  const double start = simulation.time();
  for (auto _ : state)
    simulation.advanceTo(simulation.time() + stride);
  const auto collisions = static_cast<double>(simulation.collisions().total() - before);
  state.counters["collisions"] = Counter(collisions, Counter::kIsRate);
  state.counters["simulated_seconds"] = Counter(simulation.time() - start, Counter::kIsRate);
}

/// The same, of a scene that has run for a second.
void advance(benchmark::State& state, const SceneDefinition& scene, double stride, std::size_t threads = 1)
{
  Simulation simulation(scene);
  simulation.setThreads(threads);
  simulation.advanceTo(1.0);
  advance(state, simulation, stride);
}

/// Fig. 3, a thousand single disks.
void singleParticles(benchmark::State& state)
{
  advance(state, test::singleParticles(1000), 0.1);
}
BENCHMARK(singleParticles)->Unit(benchmark::kMillisecond);

/// The same in so many lanes of the processor's registers; see simd_batch.h.
void singleParticlesInLanes(benchmark::State& state)
{
  const auto lanes = static_cast<int>(state.range(0));
  if (widestKernel(lanes).lanes != lanes)
    return state.SkipWithError("this processor has no registers as wide");
  setenv("RATCHET_SIEVE_LANES", std::to_string(lanes).c_str(), 1);
  advance(state, test::singleParticles(1000), 0.5);
  unsetenv("RATCHET_SIEVE_LANES");
}
BENCHMARK(singleParticlesInLanes)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

/// Ten thousand single disks on so many threads.
void singleParticlesOnThreads(benchmark::State& state)
{
  advance(state, test::singleParticles(10000), 0.5, static_cast<std::size_t>(state.range(0)));
}
BENCHMARK(singleParticlesOnThreads)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Fig. 8, 13.1 disks of each species to a tooth.
SceneDefinition mixtureOf(int teeth)
{
  SceneDefinition scene = test::mixture(teeth * 131 / 10);
  scene.base.teeth = teeth;
  return scene;
}

/// As soon as the layer has come down, for a large one takes long.
double landed(int teeth)
{
  return teeth < 1000 ? 1.0 : 0.2;
}

/// The argument is the number of teeth.
void mixture(benchmark::State& state)
{
  const auto teeth = static_cast<int>(state.range(0));
  const SceneDefinition scene = mixtureOf(teeth);
  static std::map<int, Simulation> running;
  const auto [found, is_new] = running.try_emplace(teeth, scene);
  if (is_new)
    found->second.advanceTo(landed(teeth));
  // Whole periods of the drive: within one, a layer is now packed, now flying.
  advance(state, found->second, 1.0 / scene.base.frequency);
}
BENCHMARK(mixture)->Arg(20)->Arg(38)->Arg(382)->Arg(3817)->Unit(benchmark::kMillisecond);

/// A mixture that has come down; always the same disks.
const std::string& landedState(int teeth)
{
  static std::map<int, std::string> states;
  std::string& state = states[teeth];
  if (state.empty())
  {
    Simulation simulation(mixtureOf(teeth));
    simulation.setThreads(0);
    simulation.advanceTo(landed(teeth));
    state = simulation.saveState();
  }
  return state;
}

/// Six periods of the drive, which always begin with the same disks.
void layerInStrips(benchmark::State& state, int teeth, std::size_t threads, const StripSettings& strips)
{
  const SceneDefinition scene = mixtureOf(teeth);
  Engine engine(scene, landedState(teeth));
  engine.setThreads(threads, strips);
  const auto collisions = [&] { return engine.state().sums().contacts.counts.collisions.total(); };
  const auto before = collisions();
  for (auto _ : state)
    engine.advanceTo(engine.time() + 1.0 / scene.base.frequency);
  state.counters["collisions"] = Counter(static_cast<double>(collisions() - before), Counter::kIsRate);
}

/// The second argument is the number of threads; 0: one, with a single queue whatever the number of disks.
void mixtureOnThreads(benchmark::State& state)
{
  StripSettings strips;
  if (state.range(1) == 0)
    strips.least_on_one_thread = SIZE_MAX;
  layerInStrips(state, static_cast<int>(state.range(0)),
                static_cast<std::size_t>(std::max<std::int64_t>(1, state.range(1))), strips);
}
BENCHMARK(mixtureOnThreads)
    ->ArgsProduct({{20, 153, 382, 3817}, {0, 1, 2}})
    ->Iterations(6)  // over the same periods of the drive, whatever the threads
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// A layer on a periodic base at rest (0) or turning at 0.1 rad/s (1). Both begin with the same disks.
void slewing(benchmark::State& state)
{
  const auto teeth = static_cast<int>(state.range(0));
  const SceneDefinition scene = mixtureOf(teeth);
  Simulation simulation(scene, landedState(teeth));
  if (state.range(1) != 0)
    simulation.command(Quantity::INCLINATION, 1.0);
  advance(state, simulation, 1.0 / scene.base.frequency);
}
BENCHMARK(slewing)->ArgsProduct({{20, 382}, {0, 1}})->Iterations(6)->Unit(benchmark::kMillisecond);

/// Two thousand equal disks and one that is so many times as large.
void wideSizes(benchmark::State& state)
{
  advance(state, test::oneLarge(2000, static_cast<double>(state.range(0))), 0.2);
}
BENCHMARK(wideSizes)->Arg(1)->Arg(5)->Arg(10)->Arg(25)->Arg(50)->Unit(benchmark::kMillisecond);

/// Two thousand disks with lognormal radii; the argument is the standard deviation of the logarithm in
/// percent.
void lognormalSizes(benchmark::State& state)
{
  advance(state, test::lognormalSizes(2000, 0.01 * static_cast<double>(state.range(0))), 0.2);
}
BENCHMARK(lognormalSizes)->Arg(25)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ratchet_sieve
