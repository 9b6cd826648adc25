#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lane_run.h"
#include "ratchet_sieve/core/event_loop.h"
#include "ratchet_sieve/core/machine.h"

namespace ratchet_sieve
{
namespace
{

}
extern std::uint64_t looks; std::uint64_t looks;
namespace {
class EnsembleLoop : public EventLoop
{
public:
  explicit EnsembleLoop(Machine& machine) : machine_(machine) {}

  /// A collapse does not keep the other disks from coming as far: all have to be at one time.
  double advanceTo(double time) override
  {
    const std::optional<LaneScene> scene = laneScene(machine_);
    if (!scene)
    {
      for (std::uint32_t id = 0; id < next_.size(); ++id)
        while (isDue(id, time))
          executeNext(id);
      return time;
    }
    due_.clear();
    for (std::uint32_t id = 0; id < next_.size(); ++id)
      if (isDue(id, time))
        due_.push_back(id);
    while (!due_.empty())
    {
      advanceInLanes(*scene, time);
      std::vector<std::uint32_t> left = std::move(due_);
      due_.clear();
      for (const std::uint32_t id : left)
        if (advanceAlone(id, time))
          due_.push_back(id);
    }
    return time;
  }

  void added(std::uint32_t id, double time) override
  {
    next_.resize(id + 1);
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
  }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(next_);
    requireDisks(next_.size(), machine_);
  }

private:
  bool isDue(std::uint32_t id, double time) const { return next_[id].time <= time && machine_.active(id); }

  /// Leaves in due_ the disks whose next event is due, and not an ordinary one.
  void advanceInLanes(const LaneScene& scene, double time)
  {
    std::size_t taken = 0;
    run_.advance(machine_, next_, scene, time,
                 [&](std::uint32_t& id)
                 {
                   if (taken == due_.size())
                     return false;
                   id = due_[taken++];
                   return true;
                 });
    LaneRun::Outcome outcome = run_.takeOutcome();
    events_ += outcome.events;
    looks += outcome.looks;
    machine_.noteOverlap(outcome.max_overlap);
    machine_.collisionCounts().add(outcome.collisions);
    for (const CollisionRecord& record : outcome.records)
      machine_.collisionObserver()(record);
    due_ = std::move(outcome.not_for_lanes);
  }

  /// Advances a disk whose contacts are not ordinary ones, until they are again.
  /// @return whether there is still something due
  bool advanceAlone(std::uint32_t id, double time)
  {
    do
      executeNext(id);
    while (isDue(id, time) && machine_.collapseWatch().loosened(id));
    return isDue(id, time);
  }

  void executeNext(std::uint32_t id)
  {
    BaseEvent& next = next_[id];
    const double now = next.time;
    // For a disk that is stuck there is no later time. The others go on to where the run is stopped.
    if (machine_.collapseWatch().count(id, now) && machine_.collapseWatch().stuck(id))
      return machine_.takeOut(id, now);
    ++events_;
    if (next.feature)
      machine_.meetBase(id, *next.feature, now);
    bringHome(id, now);
    next = search(id, now);
  }

  /// Also where a long flight comes down, far from home: the next contact is found on a finer place.
  void bringHome(std::uint32_t id, double now)
  {
    if (machine_.scene().boundary == Boundary::PERIODIC)
      machine_.bringHome(id, machine_.search().seenFromBase(machine_.disk(id), now).s, now);
  }

  BaseEvent search(std::uint32_t id, double from) const
  {
    return machine_.nextBaseEvent(id, from, std::numeric_limits<double>::infinity());
  }

  Machine& machine_;
  std::vector<BaseEvent> next_;  ///< per disk
  std::vector<std::uint32_t> due_;
  LaneRun run_;
};

}  // namespace

std::unique_ptr<EventLoop> makeEnsembleLoop(Machine& machine)
{
  return std::make_unique<EnsembleLoop>(machine);
}

}  // namespace ratchet_sieve
