#include <stdexcept>

#include "state/height_profile.h"
#include "state/mass_flow.h"
#include "state/observable.h"
#include "state/residence_times.h"

namespace ratchet_sieve
{
namespace
{
template <typename Kind>
std::unique_ptr<Observable> made(const SystemState& system)
{
  return std::make_unique<Kind>(system);
}

/// Every observable: its name, and what makes it.
constexpr struct
{
  const char* name;
  std::unique_ptr<Observable> (*make)(const SystemState& system);
} OBSERVABLES[] = {
    {ResidenceTimes::NAME, made<ResidenceTimes>},
    {HeightProfile::NAME, made<HeightProfile>},
    {MassFlow::NAME, made<MassFlow>},
};
}  // namespace

std::vector<std::string> observableNames()
{
  std::vector<std::string> names;
  for (const auto& observable : OBSERVABLES)
    names.emplace_back(observable.name);
  return names;
}

std::unique_ptr<Observable> makeObservable(const std::string& name, const SystemState& system)
{
  for (const auto& observable : OBSERVABLES)
    if (name == observable.name)
      return observable.make(system);
  throw std::invalid_argument("there is nothing to observe named " + name);
}

}  // namespace ratchet_sieve
