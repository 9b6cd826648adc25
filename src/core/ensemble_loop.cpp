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
  explicit EnsembleLoop(Machine& machine) : machine_(machine), base_(machine.motion()) {}

  /// A collapse does not keep the other disks from coming as far: all have to be at one time.
  double advanceTo(double time) override
  {
    for (std::uint32_t id = 0; id < next_.size(); ++id)
      advanceDisk(id, time);
    return time;
  }

  void added(std::uint32_t id, double time) override
  {
    next_.resize(id + 1);
    next_[id] = search(id, time);
  }

  void motionChanged(double time) override
  {
    base_.forget();
    for (std::uint32_t id = 0; id < next_.size(); ++id)
      if (machine_.active(id))
        next_[id] = search(id, time);
  }

  void rebase(double length) override
  {
    base_.forget();
    for (BaseEvent& event : next_)
      event.time -= length;
  }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(next_);
    requireDisks(next_.size(), machine_);
  }

private:
  void advanceDisk(std::uint32_t id, double time)
  {
    BaseEvent& next = next_[id];
    while (next.time <= time && machine_.active(id))
    {
      const double now = next.time;
      // For a disk that is stuck there is no later time. The others go on to where the run is stopped.
      if (machine_.collapseWatch().count(id, now) && machine_.collapseWatch().stuck(id))
        return machine_.takeOut(id, now);
      ++events_;
      if (next.feature)
        machine_.meetBase(id, *next.feature, now, base_);
      bringHome(id, now);
      next = search(id, now);
    }
  }

  /// Also where a long flight comes down, far from home: the next contact is found on a finer place.
  void bringHome(std::uint32_t id, double now)
  {
    if (machine_.scene().boundary == Boundary::PERIODIC)
      machine_.bringHome(id, machine_.search().seenFromBase(machine_.disk(id), base_.at(now), now).s, now);
  }

  BaseEvent search(std::uint32_t id, double from)
  {
    return machine_.nextBaseEvent(id, from, std::numeric_limits<double>::infinity(), base_);
  }

  Machine& machine_;
  BaseInstant base_;
  std::vector<BaseEvent> next_;  ///< per disk
};

}  // namespace

std::unique_ptr<EventLoop> makeEnsembleLoop(Machine& machine)
{
  return std::make_unique<EnsembleLoop>(machine);
}

}  // namespace ratchet_sieve
