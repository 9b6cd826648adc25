#include <benchmark/benchmark.h>

#include "events/event_queue.h"
#include "events/spin_barrier.h"
#include "model/random.h"
#include "model/sine.h"
#include "search/contact_search.h"
#include "search/pair_search.h"
#include "simd/worker_pool.h"

namespace ratchet_sieve
{
namespace
{

void sineAndCosine(benchmark::State& state)
{
  double turns = 0.1;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(sineCosineOfTurns(turns));
    turns += 0.37;
  }
}
BENCHMARK(sineAndCosine);

/// A typical flight of Fig. 3 from over a slope to its contact. The argument is where along the
/// tooth it starts [0.1 mm]: 30 over the left slope, 60 over the apex, 130 over the right slope.
void firstContactWithTheBase(benchmark::State& state)
{
  const BaseDefinition base;
  const BaseShape shape(base, Boundary::PERIODIC);
  const BaseMotion motion(base, 1.0);
  const ContactSearch search(shape, motion, 9.81, 1e-15);
  Disk disk;
  disk.position = {0.1 + 1e-4 * static_cast<double>(state.range(0)), 0.012};
  disk.velocity = {0.05, 0.1};
  for (auto _ : state)
    benchmark::DoNotOptimize(search.find(disk, 0.001, 0.0, 1.0));
}
BENCHMARK(firstContactWithTheBase)->Arg(30)->Arg(60)->Arg(130);

void timeUntilAPairTouches(benchmark::State& state)
{
  Random random(1);
  std::vector<double> draws(4096);
  for (double& draw : draws)
    draw = random.uniform() - 0.5;
  std::size_t i = 0;
  for (auto _ : state)
  {
    const double* d = &draws[i];
    benchmark::DoNotOptimize(timeToContact({d[0], d[1]}, {d[2], d[3]}, 0.1));
    i = (i + 4) % 4092;
  }
}
BENCHMARK(timeUntilAPairTouches);

/// The event at the top is given a new time a little later: what the loop does all the time.
void updateOfTheQueue(benchmark::State& state)
{
  const auto count = static_cast<std::uint32_t>(state.range(0));
  Random random(1);
  EventQueue queue;
  queue.resize(count);
  for (std::uint32_t id = 0; id < count; ++id)
    queue.update(id, random.uniform());
  for (auto _ : state)
    queue.update(queue.top(), queue.topTime() + random.uniform());
}
BENCHMARK(updateOfTheQueue)->Arg(524)->Arg(10000)->Arg(100000);

/// Two threads that meet and do nothing in between.
void meetingOfTwoThreads(benchmark::State& state)
{
  constexpr int MEETINGS = 10000;
  WorkerPool pool(2);
  if (pool.workers() < 2)
    return state.SkipWithError("the system provides no second thread");
  for (auto _ : state)
  {
    SpinBarrier barrier(2);
    pool.run(
        [&](std::size_t)
        {
          for (int k = 0; k < MEETINGS; ++k)
            barrier.wait([] {});
        });
  }
  state.counters["meetings"] = benchmark::Counter(MEETINGS, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(meetingOfTwoThreads)->UseRealTime();

}  // namespace
}  // namespace ratchet_sieve
