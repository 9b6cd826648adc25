#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "events/event_loop.h"
#include "simd/batch_run.h"
#include "simd/worker_pool.h"
#include "state/contact_execution.h"

namespace ratchet_sieve
{
namespace
{
/// Disks handed to a thread at a time: few, so that all threads finish at nearly the same time.
constexpr std::size_t DISKS_AT_A_TIME = 16;

/// With fewer disks per thread, threads cost more than they gain.
constexpr std::size_t DISKS_PER_THREAD = 64;

/// Every disk has its own event loop. Ordinary contacts are executed for many disks at a time with SIMD
/// (BatchRun), on several threads. All other events are executed one at a time by ContactExecution: see Plan
/// for scenes, batchScene() for times, and CollapseWatch for disks. Which of the two is used depends only on
/// the scene and on the history of the disk.
class EnsembleLoop : public EventLoop
{
public:
  EnsembleLoop(SystemState& state, ContactExecution& execution)
      : state_(state), execution_(execution), base_(state.motion())
  {
    EnsembleLoop::setThreads(1);
  }

  /// After a collapse of one disk the others are still advanced, because all disks must reach the same time.
  double advanceTo(double time) override
  {
    behind_.clear();
    for (std::uint32_t slot = 0; slot < next_.size(); ++slot)
      if (hasEventBy(slot, time))
        behind_.push_back(slot);
    if (const std::optional<BatchScene> scene = batchScene(state_))
      advanceInBatches(*scene, time);
    else
      for (const std::uint32_t slot : behind_)
        while (hasEventBy(slot, time))
          executeNext(slot);
    return time;
  }

  void added(std::uint32_t slot, double time) override
  {
    next_.resize(slot + 1);
    next_[slot] = search(slot, time);
  }

  void motionChanged(double time) override
  {
    base_.forget();
    for (std::uint32_t slot = 0; slot < next_.size(); ++slot)
      if (state_.active(slot))
        next_[slot] = search(slot, time);
  }

  void rebase(double length) override
  {
    base_.forget();
    for (BaseEvent& event : next_)
      event.time -= length;
  }

  void setThreads(std::size_t threads, const StripSettings& /*strips*/ = {}) override
  {
    pool_ = threads > 1 ? std::make_unique<WorkerPool>(threads) : nullptr;
    runs_.resize(pool_ ? pool_->workers() : 1);
    for (std::unique_ptr<BatchRun>& run : runs_)
      if (!run)
        run = std::make_unique<BatchRun>();
  }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(next_);
    requireDisks(next_.size(), state_);
    for (std::uint32_t slot = 0; slot < next_.size(); ++slot)
      state.require(!state_.active(slot) || state_.canBe(next_[slot]), "a disk's event is impossible");
  }

private:
  bool hasEventBy(std::uint32_t slot, double time) const
  {
    return next_[slot].time <= time && state_.active(slot);
  }

  /// Advances the disks in behind_ with SIMD, and executes other events in between.
  void advanceInBatches(const BatchScene& scene, double time)
  {
    while (!behind_.empty())
    {
      runBatches(scene, time);
      behind_.clear();
      for (const std::unique_ptr<BatchRun>& run : runs_)
        takeIn(*run, time);
    }
  }

  void runBatches(const BatchScene& scene, double time)
  {
    std::atomic<std::size_t> handed_out{0};
    const auto work = [&](std::size_t worker)
    {
      std::size_t next = 0;
      std::size_t end = 0;
      runs_[worker]->advance(state_, next_, scene, time,
                             [&](std::uint32_t& slot)
                             {
                               if (next == end)
                               {
                                 next = handed_out.fetch_add(DISKS_AT_A_TIME, std::memory_order_relaxed);
                                 end = next + DISKS_AT_A_TIME;
                               }
                               if (next >= behind_.size())
                                 return false;
                               slot = behind_[next++];
                               return true;
                             });
    };
    if (pool_ && behind_.size() >= DISKS_PER_THREAD * pool_->workers())
      pool_->share(work);
    else
      work(0);
  }

  /// Merges the results of one thread. Leaves in behind_ the disks that have not reached `time`.
  void takeIn(BatchRun& run, double time)
  {
    const BatchRun::Report report = run.takeReport(state_.observers());
    events_ += report.events;
    for (const std::uint32_t slot : report.not_ordinary)
      if (advanceAlone(slot, time))
        behind_.push_back(slot);
  }

  /// Executes an event that is not ordinary, and the following ones until the next is ordinary again.
  /// @return whether its next event is not after `time`
  bool advanceAlone(std::uint32_t slot, double time)
  {
    do
      executeNext(slot);
    while (hasEventBy(slot, time) && state_.collapseWatch().lossless(slot));
    return hasEventBy(slot, time);
  }

  void executeNext(std::uint32_t slot)
  {
    BaseEvent& next = next_[slot];
    const double now = next.time;
    // A collapsed disk reaches no later time. The others advance to the time at which the run is stopped.
    if (state_.collapseWatch().count(slot, now) && state_.collapseWatch().stuck(slot))
      return state_.remove(slot, now);
    ++events_;
    if (next.feature)
      execution_.handleBaseEvent(slot, next.feature, now, base_);
    wrapIntoWidth(slot, now);
    next = search(slot, now);
  }

  /// Also after a long flight over many widths, so that the next search has finer coordinates.
  void wrapIntoWidth(std::uint32_t slot, double now)
  {
    if (state_.scene().boundary == Boundary::PERIODIC)
      state_.wrapIntoWidth(slot, state_.search().seenFromBase(state_.disk(slot), base_.at(now), now).s(),
                           now);
  }

  BaseEvent search(std::uint32_t slot, double from)
  {
    return state_.nextBaseEvent(slot, from, std::numeric_limits<double>::infinity(), base_);
  }

  SystemState& state_;
  ContactExecution& execution_;
  BaseInstant base_;
  std::vector<BaseEvent> next_;                  ///< per disk
  std::vector<std::uint32_t> behind_;            ///< disks that have not reached the requested time
  std::vector<std::unique_ptr<BatchRun>> runs_;  ///< per thread
  std::unique_ptr<WorkerPool> pool_;             ///< null if one thread is enough
};

}  // namespace

std::unique_ptr<EventLoop> makeEnsembleLoop(SystemState& state, ContactExecution& execution)
{
  return std::make_unique<EnsembleLoop>(state, execution);
}

}  // namespace ratchet_sieve
