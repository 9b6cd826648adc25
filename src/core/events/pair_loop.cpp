#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "events/disk_cells.h"
#include "events/event_loop.h"
#include "events/event_queue.h"
#include "events/pair_events.h"
#include "events/pair_strips.h"
#include "model/processor.h"

namespace ratchet_sieve
{
namespace
{

/// Number of events whose memory is prefetched together: a few hundred cache lines, which fit into the cache.
constexpr double EVENTS_AHEAD = 12.0;

/// Number of disks that fit into the processor's cache; with fewer, prefetching gains nothing.
constexpr std::size_t DISKS_IN_CACHE = 30000;

/// Strips pay if the caller's strides are this number of windows, on average.
constexpr double WINDOWS_IN_STRIPS = 1.5;

/// The share of the last stride in their average: a few short ones do not matter.
constexpr double LAST_STRIDE = 0.1;

/// After this time strips are considered anew [time scales].
constexpr double LOOK_AHEAD = 0.05;

/// Windows that fail are shortened to this share of the settings'.
constexpr double LEAST_WINDOW_SHARE = 0.125;

/// Largest number of windows for the single queue after strips have failed.
constexpr double MOST_QUEUED_WINDOWS = 1024.0;

/// The window of time whose events are prefetched together: about EVENTS_AHEAD of them, by the event rate of
/// the window before. Most events of a window are known at its start. Results do not depend on it.
struct PrefetchWindow
{
  double start = 0.0;
  double end = 0.0;
  std::uint64_t events_before = 0;

  /// @param now time of the next event; @param events number of events so far
  void begin(double now, std::uint64_t events)
  {
    const double length = events > events_before
                              ? (now - start) * EVENTS_AHEAD / static_cast<double>(events - events_before)
                              : end - start;
    start = now;
    end = now + length;
    events_before = events;
  }
};

/// The event loop for colliding disks (PairEvents). A single queue has the events of all disks, or each strip
/// of the layer its own (PairStrips), whichever is faster; the bits are the same.
class PairLoop : public EventLoop
{
public:
  explicit PairLoop(SystemState& state)
      : state_(state), layer_(state), events_of_queue_(layer_, queue_, nullptr)
  {
    queue_.resize(state_.disks().size());
  }

  double advanceTo(double time) override
  {
    if (time > reached_)
      stride_ += (stride_ > 0.0 ? LAST_STRIDE : 1.0) * (time - reached_ - stride_);
    while (reached_ < time && plansStrips())
    {
      // A while later there may be more events.
      double end = std::min(time, reached_ + LOOK_AHEAD * state_.timeScale());
      if (useStrips() && advanceStrips(time, end))
        return time;
      if (const double reached = advanceQueue(end); reached < end || state_.collapseWatch().stops())
        return reached;
    }
    return advanceQueue(time);
  }

  void added(std::uint32_t slot, double time) override
  {
    useQueue();
    layer_.predictions.resize(slot + 1);
    if (slot + 1 > cells_.capacity())
      queue_.resize(cells_.reserve(slot + 1));
    if (cells_.crowdedBy(slot + 1))
      return motionChanged(time);
    cells_.add(slot, time);
    events_of_queue_.predict(slot, time);
    reached_ = time;
  }

  void motionChanged(double time) override
  {
    useQueue();
    events_of_queue_.renew();
    cells_.rebuild(layer_.predictions.size(), time);
    forEachActive([&](std::uint32_t slot) { events_of_queue_.predict(slot, time); });
    reached_ = time;
  }

  void rebase(double length) override
  {
    useQueue();
    events_of_queue_.renew();
    for (DiskPrediction& p : layer_.predictions)
    {
      p.pair.time -= length;
      p.base.time -= length;
      p.cell_time -= length;
    }
    queue_.rebase(length);
    prefetched_.start -= length;
    prefetched_.end -= length;
    reached_ -= length;
  }

  bool outgrown(double time) override { return cells_.endEpoch(events_, time); }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(cells_, layer_.predictions);
    if (!state.restoring())
      return;
    events_of_queue_.renew();
    fillQueue();
  }

  void setThreads(std::size_t threads, const StripSettings& settings = {}) override
  {
    settings_ = settings;
    useQueue();
    pool_.reset();
    threads_ = threads;
  }

  std::uint64_t eventsInStrips() const override { return events_in_strips_; }

private:
  std::size_t mostStrips() const { return PairStrips::mostStrips(cells_, settings_); }
  std::size_t usefulThreads() const
  {
    return std::min({threads_, mostStrips(), state_.activeCount() / settings_.disks_per_thread});
  }

  /// Whether strips are faster for a layer of so many disks.
  bool plansStrips() const
  {
    const std::size_t disks = state_.activeCount();
    return mostStrips() > 1 && (usefulThreads() > 1 || (disks >= settings_.least_on_one_thread &&
                                                        disks <= settings_.most_on_one_thread));
  }

  /// Whether they are for strides as long as these; makes them. @pre plansStrips()
  bool useStrips()
  {
    if (window_length_ == 0.0 || stride_ < WINDOWS_IN_STRIPS * window_length_)
      return false;
    if (strips_)
      return true;
    const std::size_t disks = state_.activeCount();
    const std::size_t threads = usefulThreads();
    if (threads < 2)
      pool_.reset();
    else if (!pool_ || pool_->workers() != threads)
      pool_ = std::make_unique<WorkerPool>(threads);
    const std::size_t workers = std::max<std::size_t>(threads, 1);
    const std::size_t strips = workers * ((disks - 1) / (workers * settings_.disks_per_strip) + 1);
    strips_.emplace(layer_, std::clamp<std::size_t>(strips, 2, mostStrips()), settings_, pool_.get());
    strips_->setWindows(window_length_, window_share_);
    return true;
  }

  /// Executes events strip by strip. @return whether all up to `time` are executed; otherwise the single
  /// queue has to go on, up to `end`
  bool advanceStrips(double time, double& end)
  {
    const bool advanced = strips_->advance(reached_, time);
    const std::uint64_t events = strips_->takeEvents();
    events_ += events;
    events_in_strips_ += events;
    window_length_ = strips_->windowLength();
    window_share_ = strips_->windowShare();
    if (advanced)
    {
      reached_ = time;
      return true;
    }
    window_share_ = std::max(0.5 * window_share_, LEAST_WINDOW_SHARE);
    end = std::min(time, strips_->failedBefore() + queued_windows_ * window_length_);
    queued_windows_ = strips_->copies() > 1 ? 1.0 : std::min(2.0 * queued_windows_, MOST_QUEUED_WINDOWS);
    return false;
  }

  /// Puts the events of all disks into the single queue.
  void useQueue()
  {
    if (!strips_)
      return;
    strips_.reset();
    queue_ = EventQueue();
    fillQueue();
  }

  /// Executes events from the single queue. @return the time reached
  double advanceQueue(double time)
  {
    useQueue();
    while (queue_.topTime() <= time)
    {
      const double now = queue_.topTime();
      if (state_.collapseWatch().stops())
        return finishQueue(now);
      if (now > prefetched_.end)
        prefetchNextEvents();
      const std::uint32_t slot = queue_.top();
      if (!state_.collapseWatch().count(slot, now) || !state_.collapseWatch().stops())
        events_of_queue_.process(slot, now);
    }
    return finishQueue(time);
  }

  double finishQueue(double reached)
  {
    const std::uint64_t events = events_of_queue_.takeEvents();
    if (events > 0)
      window_length_ = (reached - reached_) * window_share_ * settings_.events_per_column *
                       cells_.grid().columns() / static_cast<double>(events);
    events_ += events;
    cells_.countCrossings(events_of_queue_.takeCrossings());
    reached_ = reached;
    return reached;
  }

  template <typename Visit>
  void forEachActive(Visit&& visit) const
  {
    for (std::uint32_t slot = 0; slot < layer_.predictions.size(); ++slot)
      if (state_.active(slot))
        visit(slot);
  }

  /// Prefetches the memory of the next events together: predictions, partners, cells and the disks in them.
  /// Otherwise each event waits for one cache miss after another.
  void prefetchNextEvents()
  {
    prefetched_.begin(queue_.topTime(), events_ + events_of_queue_.events());
    if (layer_.predictions.size() < DISKS_IN_CACHE)
      return;
    queue_.upTo(prefetched_.end, next_);
    for (const std::uint32_t slot : next_)
      prefetchEvent(slot);
    for (const std::uint32_t slot : next_)
    {
      const PairContact& pair = layer_.predictions[slot].pair;
      if (pair.time <= prefetched_.end)
        prefetchEvent(pair.partner);
      cells_.grid().prefetchAround(slot);
    }
    for (const std::uint32_t slot : next_)
      cells_.grid().visit(slot, CellEdge::NONE, near_,
                          [this](const std::uint32_t* others, std::size_t count, int)
                          {
                            for (std::size_t i = 0; i < count; ++i)
                              prefetch(state_.disk(others[i]));
                          });
  }

  void prefetchEvent(std::uint32_t slot) const
  {
    prefetch(layer_.predictions[slot]);
    cells_.grid().prefetchCellOf(slot);
    state_.prefetchEvent(slot);
  }

  /// The queue contains the earliest prediction of each active disk.
  void fillQueue()
  {
    queue_.resize(cells_.capacity());
    forEachActive([&](std::uint32_t slot) { queue_.update(slot, layer_.predictions[slot].earliest()); });
  }

  SystemState& state_;
  PairLayer layer_;
  DiskCells& cells_{layer_.cells};
  EventQueue queue_;
  PairEvents<EventQueue> events_of_queue_;
  double reached_ = 0.0;
  PrefetchWindow prefetched_;
  std::vector<std::uint32_t> next_;  ///< the disks whose events were prefetched
  std::vector<std::uint32_t> near_;  ///< candidates of the neighbour search
  std::size_t threads_ = 1;
  StripSettings settings_;
  std::unique_ptr<WorkerPool> pool_;  ///< null if one thread is enough
  std::optional<PairStrips> strips_;  ///< while these have the events, not the queue
  std::uint64_t events_in_strips_ = 0;
  double stride_ = 0.0;          ///< mean of the last [s]
  double window_length_ = 0.0;   ///< of the strips so far [s]
  double window_share_ = 1.0;    ///< events in a window, as a share of the settings
  double queued_windows_ = 1.0;  ///< windows for the queue after strips have failed
};

}  // namespace

std::unique_ptr<EventLoop> makePairLoop(SystemState& state)
{
  return std::make_unique<PairLoop>(state);
}

}  // namespace ratchet_sieve
