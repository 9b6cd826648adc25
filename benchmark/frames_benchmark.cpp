#include <cstdio>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/bag.h"
#include "ratchet_sieve/ros/conversions.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Fig. 8 on 382 teeth, 10^4 disks, after a while: what a frame of it costs beside the engine.
const Simulation& manyDisks()
{
  static const Simulation simulation = []
  {
    SceneDefinition scene = test::mixture(5004);
    scene.base.teeth = 382;
    Simulation poured(scene);
    poured.advanceTo(0.05);
    return poured;
  }();
  return simulation;
}

void particleFrame(benchmark::State& state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(makeParticleFrame(manyDisks()));
}
BENCHMARK(particleFrame)->Unit(benchmark::kMicrosecond);

/// As roscpp does for a subscriber.
void serializedParticleMessage(benchmark::State& state)
{
  const ParticleFrame frame = makeParticleFrame(manyDisks());
  for (auto _ : state)
    benchmark::DoNotOptimize(ros::serialization::serializeMessage(toMessage(frame)));
}
BENCHMARK(serializedParticleMessage)->Unit(benchmark::kMicrosecond);

/// Into an lz4 bag, written to the temporary directory.
void recordedParticleFrame(benchmark::State& state)
{
  const std::string path = "/tmp/frames_benchmark_" + std::to_string(getpid()) + ".bag";
  ParticleFrame frame = makeParticleFrame(manyDisks());
  BagWriter bag(path);
  for (auto _ : state)
  {
    frame.time += 1.0 / 60.0;
    bag.take(frame);
  }
  bag.close();
  std::remove(path.c_str());
}
BENCHMARK(recordedParticleFrame)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ratchet_sieve
