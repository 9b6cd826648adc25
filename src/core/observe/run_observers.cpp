#include "observe/run_observers.h"

#include "state/system_state.h"

namespace ratchet_sieve
{

RunObservers::RunObservers(SystemState& system) : system_(system)
{
  EventLog& log = system.log();
  const SceneDefinition& scene = system.scene();
  bins_ = log.add(std::make_unique<Bins>(system));
  exits_ = log.add(std::make_unique<RecentExits>(system));
  if (scene.feed.any() && scene.boundary != Boundary::PERIODIC)
    flow_ = log.add(std::make_unique<FlowBlocks>(*bins_));
  for (const std::string& name : scene.observe)
    observables_.push_back(log.add(makeObservable(name, system)));
  if (system.shape().isProfile())
    faces_ = log.add(std::make_unique<FaceCounts>(system.shape()));
}

std::vector<Observed> RunObservers::observed(double time, bool settled) const
{
  std::vector<Observed> observed;
  for (std::size_t k = 0; k < observables_.size(); ++k)
  {
    const std::unique_ptr<Observable> begun = makeObservable(system_.scene().observe[k], system_);
    begun->restart(time);
    observed.push_back((settled ? observables_[k] : begun.get())->observed(time));
  }
  return observed;
}

}  // namespace ratchet_sieve
