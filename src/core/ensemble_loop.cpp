#include <algorithm>
#include <limits>
#include <vector>

#include "ratchet_sieve/core/event_loop.h"
#include "ratchet_sieve/core/machine.h"

namespace ratchet_sieve
{
namespace
{

class EnsembleLoop : public EventLoop
{
public:
  explicit EnsembleLoop(Machine& machine) : machine_(machine) {}

  void advanceTo(double time) override
  {
    for (std::uint32_t id = 0; id < next_.size(); ++id)
      advanceDisk(id, time);
  }

  void added(std::uint32_t id, double time) override
  {
    next_.resize(id + 1);
    watches_.resize(id + 1);
    next_[id] = search(id, time);
  }

  void motionChanged(double time) override
  {
    for (std::uint32_t id = 0; id < next_.size(); ++id)
      if (machine_.active(id))
        next_[id] = search(id, time);
  }

  void rebase(double length) override
  {
    for (BaseEvent& event : next_)
      event.time -= length;
    for (StallWatch& watch : watches_)
      watch.rebase(length);
  }

private:
  void advanceDisk(std::uint32_t id, double time)
  {
    BaseEvent& next = next_[id];
    while (next.time <= time && machine_.active(id))
    {
      ++events_;
      watches_[id].count(id, next.time, machine_.timeScale());
      const double now = next.time;
      if (next.feature)
      {
        machine_.meetBase(id, *next.feature, now);
        machine_.bringHome(id, machine_.search().seenFromBase(machine_.disk(id), now).s, now);
      }
      next = search(id, now);
    }
  }

  BaseEvent search(std::uint32_t id, double from) const
  {
    return machine_.nextBaseEvent(id, from, std::numeric_limits<double>::infinity());
  }

  Machine& machine_;
  std::vector<BaseEvent> next_;      ///< per disk
  std::vector<StallWatch> watches_;  ///< per disk
};

}  // namespace

void StallWatch::stalled(std::uint32_t id)
{
  throw StallError("disk " + std::to_string(id) + " met more than " +
                   std::to_string(MAX_EVENTS_PER_TIME_SCALE) +
                   " events within the time of a drive period or of a fall over a tooth (inelastic "
                   "collapse); contact.min_rebound_speed above 0 "
                   "or a larger one avoids it");
}

std::unique_ptr<EventLoop> makeEnsembleLoop(Machine& machine)
{
  return std::make_unique<EnsembleLoop>(machine);
}

}  // namespace ratchet_sieve
