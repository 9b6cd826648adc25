#include <algorithm>
#include <vector>

#include "events/disk_cells.h"
#include "events/event_loop.h"
#include "events/event_queue.h"
#include "events/prefetch_window.h"
#include "model/prefetch.h"
#include "search/pair_search.h"
#include "state/contact_execution.h"

namespace ratchet_sieve
{
namespace
{

/// Number of events whose memory is prefetched together: a few hundred cache lines, which fit into the cache.
constexpr double EVENTS_AHEAD = 12.0;

/// Number of disks that fit into the processor's cache; with fewer, prefetching gains nothing.
constexpr std::size_t DISKS_IN_CACHE = 30000;

/// Images further apart than this [widths] do not collide: more than any DiskCells::ringShifts().
constexpr int MOST_SHIFTS = 1000;

/// The event loop for colliding disks. Each disk has one event in the queue, its earliest: a pair contact, a
/// base contact or a cell crossing. A predicted pair contact is stale if the partner's flight has changed
/// since; that is checked when the event is due, and the disk is then searched for pairs again (Lubachevsky,
/// J. Comput. Phys. 94, 255 (1991)). Ties within a disk are resolved in the order pair, base, cell; ties
/// between disks by the smaller slot.
///
/// The base is searched lazily, only up to the disk's next other event, because most flights end in a pair
/// contact first.
///
/// No pair is missed, whatever the size of the cells. Whenever a disk begins a flight or enters a cell, it is
/// searched for contacts with all disks in adjacent cells, without a limit in time. Disks in cells that do
/// not touch are further apart than the largest diameter. So if two disks come into contact, the one that
/// last began its flight or entered its cell was searched against the other. On a ring of one column, the
/// cell is as wide as the widths that it extends beyond its ends, and all images that can be within it are
/// searched (PeriodicImageSearch).
class PairLoop : public EventLoop
{
public:
  PairLoop(SystemState& state, ContactExecution& execution)
      : state_(state), execution_(execution), base_(state.motion()), cells_(state)
  {
    predictions_.reserve(state_.disks().size());
    queue_.resize(state_.disks().size());
  }

  double advanceTo(double time) override
  {
    while (queue_.topTime() <= time)
    {
      if (state_.collapseWatch().stops())
        return queue_.topTime();
      if (queue_.topTime() > prefetched_.end())
        prefetchNextEvents();
      process(queue_.top());
    }
    return time;
  }

  void added(std::uint32_t slot, double time) override
  {
    predictions_.resize(slot + 1);
    if (slot + 1 > cells_.capacity())
      queue_.resize(cells_.reserve(slot + 1));
    if (cells_.crowdedBy(slot + 1))
      return motionChanged(time);
    cells_.add(slot, time);
    predict(slot, time);
  }

  void motionChanged(double time) override
  {
    base_.forget();
    cells_.rebuild(predictions_.size(), time);
    forEachActive([&](std::uint32_t slot) { predict(slot, time); });
  }

  void rebase(double length) override
  {
    base_.forget();
    for (Prediction& p : predictions_)
    {
      p.pair.time -= length;
      p.base.time -= length;
      p.cell_time -= length;
    }
    queue_.rebase(length);
    prefetched_.rebase(length);
  }

  bool outgrown(double time) override { return cells_.endEpoch(events_, time); }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(cells_, predictions_);
    requireDisks(predictions_.size(), state_);
    if (state.restoring())
      restoreQueue(state);
  }

private:
  using Edge = DiskCells::Edge;

  /// The first event of each type on a disk's present flight.
  struct Prediction
  {
    PairContact pair;
    std::uint32_t partner_event_count = 0;  ///< the partner's count at the prediction
    Edge edge = Edge::NONE;
    double cell_time = EventQueue::NEVER;  ///< leaves its cell; if there is no edge: not before
    BaseEvent base;

    void archive(StateArchive& state) { state(pair, partner_event_count, edge, cell_time, base); }
  };

  template <typename Visit>
  void forEachActive(Visit&& visit) const
  {
    for (std::uint32_t slot = 0; slot < predictions_.size(); ++slot)
      if (state_.active(slot))
        visit(slot);
  }

  /// Prefetches the memory of the next events together: predictions, partners, cells and the disks in them.
  /// Otherwise each event waits for one cache miss after another.
  void prefetchNextEvents()
  {
    prefetched_.begin(queue_.topTime(), events_);
    if (predictions_.size() < DISKS_IN_CACHE)
      return;
    queue_.upTo(prefetched_.end(), next_);
    for (const std::uint32_t slot : next_)
      prefetchEvent(slot);
    for (const std::uint32_t slot : next_)
    {
      const PairContact& pair = predictions_[slot].pair;
      if (pair.time <= prefetched_.end())
        prefetchEvent(pair.partner);
      cells_.prefetchAround(slot);
    }
    for (const std::uint32_t slot : next_)
      cells_.visit(slot, Edge::NONE, near_,
                   [this](const std::uint32_t* others, std::size_t count, int)
                   {
                     for (std::size_t i = 0; i < count; ++i)
                       prefetch(state_.disk(others[i]));
                   });
  }

  void prefetchEvent(std::uint32_t slot) const
  {
    prefetch(predictions_[slot]);
    cells_.prefetchCellOf(slot);
    state_.prefetchEvent(slot);
  }

  void process(std::uint32_t slot)
  {
    const double now = queue_.topTime();
    if (state_.collapseWatch().count(slot, now) && state_.collapseWatch().stops())
      return;
    ++events_;
    Prediction& p = predictions_[slot];
    if (p.pair.time <= now)
      processPair(slot, now);
    else if (p.base.feature && p.base.time <= now)
      processBase(slot, now);
    else if (p.edge != Edge::NONE && p.cell_time <= now)
      crossEdge(slot, now);
    else
      refresh(slot);
  }

  void processPair(std::uint32_t slot, double now)
  {
    const Prediction p = predictions_[slot];
    if (!state_.active(p.pair.partner) || state_.disk(p.pair.partner).event_count != p.partner_event_count)
    {
      searchPairs(slot, now);
      refresh(slot);
      return;
    }
    execution_.collidePair(slot, p.pair.partner, p.pair.shift, now);
    predict(slot, now);
    predict(p.pair.partner, now);
  }

  void processBase(std::uint32_t slot, double now)
  {
    const BaseFeature feature = predictions_[slot].base.feature;
    execution_.handleBaseEvent(slot, feature, now, base_);
    if (state_.active(slot))
    {
      if (feature.isEnd())
        cells_.replace(slot, now);
      return predict(slot, now);
    }
    cells_.remove(slot);
    predictions_[slot] = Prediction();
    queue_.update(slot, EventQueue::NEVER);
  }

  void crossEdge(std::uint32_t slot, double now)
  {
    const Edge edge = predictions_[slot].edge;
    if (cells_.cross(slot, edge, now))
      return predict(slot, now);
    searchPairsIn(slot, edge, now);
    predictions_[slot].edge = Edge::NONE;
    predictions_[slot].cell_time = now;
    refresh(slot);
  }

  /// Predicts everything for a new flight.
  void predict(std::uint32_t slot, double now)
  {
    searchPairs(slot, now);
    Prediction& p = predictions_[slot];
    p.edge = Edge::NONE;
    p.cell_time = now;
    p.base = {now, {}};
    refresh(slot);
  }

  void searchPairs(std::uint32_t slot, double now)
  {
    predictions_[slot].pair = PairContact();
    searchPairsIn(slot, Edge::NONE, now);
  }

  void searchPairsIn(std::uint32_t slot, Edge entered, double now)
  {
    Prediction& p = predictions_[slot];
    const PairSearch search(state_.pairScene(), slot, now);
    const int ring_shifts = cells_.ringShifts();
    cells_.visit(slot, entered, near_,
                 [&](const std::uint32_t* others, std::size_t count, int shift)
                 {
                   const PairContact found = ring_shifts > 0
                                                 ? search.firstOnRing(others, count, ring_shifts)
                                                 : search.firstAmong(others, count, shift, cells_.images());
                   if (!found.isBefore(p.pair))
                     return;
                   p.pair = found;
                   p.partner_event_count = state_.disk(found.partner).event_count;
                 });
  }

  /// Continues the searches for cell edges and base contacts up to the disk's next other event, and queues
  /// the earliest.
  void refresh(std::uint32_t slot)
  {
    Prediction& p = predictions_[slot];
    if (p.edge == Edge::NONE && p.cell_time < p.pair.time)
    {
      const DiskCells::Crossing crossing = cells_.nextCrossing(slot, p.cell_time, p.pair.time);
      p.edge = crossing.edge;
      p.cell_time = crossing.time;
    }
    const double others = std::min(p.pair.time, p.cell_time);
    if (!p.base.feature && p.base.time < others)
      p.base = state_.nextBaseEvent(slot, p.base.time, others, base_);
    queue_.update(slot, std::min(others, p.base.time));
  }

  /// The queue contains the earliest prediction of each active disk.
  void restoreQueue(const StateArchive& state)
  {
    queue_.resize(cells_.capacity());
    for (std::uint32_t slot = 0; slot < predictions_.size(); ++slot)
    {
      const Prediction& p = predictions_[slot];
      const double earliest = std::min({p.pair.time, p.cell_time, p.base.time});
      state.require(p.pair.partner < predictions_.size() && p.pair.shift >= -MOST_SHIFTS &&
                        p.pair.shift <= MOST_SHIFTS && p.edge <= Edge::UPPER,
                    "a disk's event has no partner");
      if (!state_.active(slot))
        continue;
      state.require(state_.canBeTime(earliest) && state_.shape().has(p.base.feature),
                    "a disk's event is impossible");
      queue_.update(slot, earliest);
    }
  }

  SystemState& state_;
  ContactExecution& execution_;
  BaseInstant base_;
  DiskCells cells_;
  EventQueue queue_;
  std::vector<Prediction> predictions_;  ///< per disk
  PrefetchWindow prefetched_{EVENTS_AHEAD};
  std::vector<std::uint32_t> next_;  ///< the disks whose events were prefetched
  std::vector<std::uint32_t> near_;  ///< candidates of the neighbour search
};

}  // namespace

std::unique_ptr<EventLoop> makePairLoop(SystemState& state, ContactExecution& execution)
{
  return std::make_unique<PairLoop>(state, execution);
}

}  // namespace ratchet_sieve
