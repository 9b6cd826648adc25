#include "state/contact_prediction.h"

#include <algorithm>
#include <limits>

#include "ratchet_sieve/core/resolution.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

ContactPrediction::ContactPrediction(const SystemState& system)
    : system_(system),
      pairs_{system.disks(), system.motion(), system.shape().width(), timeResolution(system.epoch().length)},
      search_(system.shape(), system.motion(), system.scene().gravity, pairs_.time_resolution),
      base_(system.motion())
{
}

void ContactPrediction::renew()
{
  pairs_.time_resolution = timeResolution(system_.epoch().length);
  search_.setTimeResolution(pairs_.time_resolution);
  base_.forget();
}

BaseEvent ContactPrediction::nextBaseEvent(std::uint32_t slot, const Kinematics& from, double until)
{
  // Without gravity there may be no event for very long; one epoch at a time is enough.
  double end = std::min(until, from.time + system_.epoch().length);
  const auto change = system_.motion().nextChange();
  if (change)
    end = std::min(end, *change);
  BaseEvent event = search_.find(system_.disk(slot), from, end, base_);
  if (!event.feature && change && event.time >= *change)
    event.time = std::numeric_limits<double>::infinity();
  return event;
}

}  // namespace ratchet_sieve
