#include <algorithm>
#include <atomic>
#include <cmath>
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
#include "state/contact_prediction.h"

namespace ratchet_sieve
{
namespace
{
/// Disks handed to a thread at a time: few, so that all threads finish at nearly the same time.
constexpr std::size_t DISKS_AT_A_TIME = 16;

/// With fewer disks per thread, threads cost more than they gain.
constexpr std::size_t DISKS_PER_THREAD = 64;

/// A disk with more events in a pass may be in a collapse: it is not taken further than the others.
constexpr std::size_t EVENTS_IN_A_PASS = 1 << 14;

/// Observers are told of so many events of all disks at a time: what waits for that takes some 200 bytes
/// each. But not less than a few of a disk, whose passes would be too short.
constexpr std::size_t NOTICES_IN_A_PASS = 1 << 16;
constexpr std::size_t FEW_EVENTS = 16;

/// After a pass that was too much, the next are short, at least this fraction of the machine's time scale,
/// and grow by this factor. So not many have to be repeated.
constexpr double SHORTEST_PASS = 1e-12;
constexpr double GROWTH_OF_A_PASS = 1.0625;

/// Every disk has its own event loop. Ordinary contacts are executed for many disks at a time with SIMD
/// (BatchRun), on several threads. All other events are executed one at a time by ContactExecution: see Plan
/// for scenes, batchScene() for times, and CollapseWatch for disks. Which of the two is used depends only on
/// the scene and on the history of the disk.
///
/// A pass takes all disks to one time. If a disk comes to an event that ends the run, or has too many events,
/// the disks go back to the beginning of the pass, and it is repeated up to that event. So an
/// ensemble stops at the first collapse, as a single queue does, and its notices do not fill the memory.
class EnsembleLoop : public EventLoop
{
public:
  explicit EnsembleLoop(SystemState& state)
      : state_(state),
        buffer_(state.log().buffer()),
        prediction_(state),
        execution_(state, &buffer_),
        kernel_(widestKernel(laneLimit()))
  {
    EnsembleLoop::setThreads(1);
  }

  double advanceTo(double time) override
  {
    LastEvent last{slice_ < std::numeric_limits<double>::infinity() ? std::min(time, firstEvent() + slice_)
                                                                    : time};
    const double first = copyDisks(last);
    const CollapseCounts collapses = state_.collapseWatch().counts();
    bool repeated = false;
    for (pass(last); pass_break_; pass(last))
    {
      last = pass_break_.take();
      repeated = true;
      restoreDisks();
      state_.collapseWatch().setCounts(collapses);
    }
    events_ += pass_events_;
    state_.merge(std::move(buffer_));
    if (repeated && next_[last.slot].time == last.time && state_.collapseWatch().endsAt(last.slot, last.time))
    {
      state_.collapseWatch().count(last.slot, last.time);
      return last.time;
    }
    slice_ = repeated ? std::max(last.time - first, SHORTEST_PASS * state_.timeScale())
                      : GROWTH_OF_A_PASS * slice_;
    return repeated ? std::nextafter(last.time, -std::numeric_limits<double>::infinity()) : last.time;
  }

  void added(std::uint32_t slot, double time) override
  {
    next_.resize(slot + 1);
    next_[slot] = search(slot, time);
  }

  void motionChanged(double time) override
  {
    prediction_.renew();
    for (std::uint32_t slot = 0; slot < next_.size(); ++slot)
      if (state_.active(slot))
        next_[slot] = search(slot, time);
  }

  void rebase(double length) override
  {
    prediction_.renew();
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
    prediction_.renew();
  }

private:
  /// A disk as it is before a pass.
  struct Copy
  {
    Copy(const SystemState& state, const BaseEvent& next_event, std::uint32_t of_slot)
        : disk(state.copyOf(of_slot)), next(next_event), slot(of_slot)
    {
    }

    SystemState::DiskCopy disk;
    BaseEvent next;
    std::uint32_t slot;
  };

  bool hasEventUntil(const LastEvent& last, std::uint32_t slot) const
  {
    return last.isAtOrAfter(next_[slot].time, slot) && state_.active(slot);
  }

  double firstEvent() const
  {
    double first = std::numeric_limits<double>::infinity();
    for (std::uint32_t slot = 0; slot < next_.size(); ++slot)
      if (state_.active(slot))
        first = std::min(first, next_[slot].time);
    return first;
  }

  /// Copies the disks that have events until the last. @return the time of the first
  double copyDisks(const LastEvent& last)
  {
    double first = last.time;
    copies_.clear();
    for (std::uint32_t slot = 0; slot < next_.size(); ++slot)
      if (hasEventUntil(last, slot))
      {
        copies_.emplace_back(state_, next_[slot], slot);
        first = std::min(first, next_[slot].time);
      }
    return first;
  }

  void restoreDisks()
  {
    for (const Copy& copy : copies_)
    {
      state_.restore(copy.slot, copy.disk);
      next_[copy.slot] = copy.next;
    }
  }

  /// Of each disk in a pass.
  std::uint32_t mostEvents() const
  {
    std::size_t most = std::numeric_limits<std::uint32_t>::max();
    if (state_.scene().contact.on_collapse == CollapseAction::STOP)
      most = EVENTS_IN_A_PASS;
    if (state_.log().collects())
      most =
          std::min(most, std::max(FEW_EVENTS, NOTICES_IN_A_PASS / std::max<std::size_t>(1, copies_.size())));
    return static_cast<std::uint32_t>(most);
  }

  /// Executes the events of the copied disks until the last, or breaks off.
  void pass(const LastEvent& last)
  {
    most_events_ = mostEvents();
    pass_events_ = 0;
    buffer_ = state_.log().buffer();
    behind_.clear();
    for (const Copy& copy : copies_)
      if (hasEventUntil(last, copy.slot))
        behind_.push_back(copy.slot);
    if (const std::optional<BatchScene> scene = batchScene(state_))
      advanceInBatches(*scene, last);
    else
      for (std::size_t k = 0; k < behind_.size() && !pass_break_; ++k)
        advanceAlone(behind_[k], last, [] { return true; });
  }

  /// Advances the disks in behind_ with SIMD, and executes other events in between.
  void advanceInBatches(const BatchScene& scene, const LastEvent& last)
  {
    while (!behind_.empty() && !pass_break_)
    {
      runBatches(scene, last);
      behind_.clear();
      for (const std::unique_ptr<BatchRun>& run : runs_)
        takeIn(*run, last);
    }
  }

  void runBatches(const BatchScene& scene, const LastEvent& last)
  {
    std::atomic<std::size_t> handed_out{0};
    const auto work = [&](std::size_t worker)
    {
      std::size_t next = 0;
      std::size_t end = 0;
      runs_[worker]->advance(kernel_, state_, next_, scene, last, most_events_, pass_break_,
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

  /// Merges the results of one thread. Leaves in behind_ the disks that have not reached the last event.
  void takeIn(BatchRun& run, const LastEvent& last)
  {
    const BatchRun::Report report = run.takeReport(buffer_);
    pass_events_ += report.events;
    for (const std::uint32_t slot : report.not_ordinary)
    {
      if (pass_break_)
        return;
      if (advanceAlone(slot, last, [&] { return state_.collapseWatch().lossless(slot); }))
        behind_.push_back(slot);
    }
  }

  /// Executes the disk's next event, and the following ones until the last as long as `goes_on()`, or breaks
  /// off.
  /// @return whether more of its events are to be executed
  template <typename GoesOn>
  bool advanceAlone(std::uint32_t slot, const LastEvent& last, GoesOn&& goes_on)
  {
    std::uint32_t events_left = most_events_;
    do
    {
      const double now = next_[slot].time;
      if (events_left-- == 0 || state_.collapseWatch().endsAt(slot, now))
      {
        if (!last.isAt(now, slot))
          pass_break_.set({now, slot});
        return false;
      }
      executeNext(slot);
    } while (hasEventUntil(last, slot) && goes_on());
    return hasEventUntil(last, slot);
  }

  void executeNext(std::uint32_t slot)
  {
    BaseEvent& next = next_[slot];
    const double now = next.time;
    state_.collapseWatch().count(slot, now);
    ++pass_events_;
    if (next.feature)
      execution_.handleBaseEvent(slot, next.feature, now, prediction_.base());
    wrapIntoWidth(slot, now);
    next = search(slot, now);
  }

  /// Also after a long flight over many widths, so that the next search has finer coordinates.
  void wrapIntoWidth(std::uint32_t slot, double now)
  {
    if (state_.scene().boundary == Boundary::PERIODIC)
      state_.wrapIntoWidth(slot, prediction_.base().at(now).see(state_.flown(slot, now)).s(), now, &buffer_);
  }

  BaseEvent search(std::uint32_t slot, double from)
  {
    return prediction_.nextBaseEvent(slot, state_.flown(slot, from), std::numeric_limits<double>::infinity());
  }

  SystemState& state_;
  ThreadBuffer buffer_;  ///< of the present pass
  ContactPrediction prediction_;
  ContactExecution execution_;
  const BatchKernel& kernel_;
  std::vector<BaseEvent> next_;        ///< per disk
  std::vector<std::uint32_t> behind_;  ///< disks that have not reached the last event
  std::vector<Copy> copies_;
  std::uint64_t pass_events_ = 0;
  std::uint32_t most_events_ = 0;  ///< of a disk in the present pass
  PassBreak pass_break_;
  double slice_ = std::numeric_limits<double>::infinity();  ///< longest pass [s]
  std::vector<std::unique_ptr<BatchRun>> runs_;             ///< per thread
  std::unique_ptr<WorkerPool> pool_;                        ///< null if one thread is enough
};

}  // namespace

std::unique_ptr<EventLoop> makeEnsembleLoop(SystemState& state)
{
  return std::make_unique<EnsembleLoop>(state);
}

}  // namespace ratchet_sieve
