#include <algorithm>
#include <vector>

#include "events/disk_cells.h"
#include "events/event_loop.h"
#include "events/event_queue.h"
#include "events/prefetch_window.h"
#include "model/prefetch.h"
#include "search/pair_search.h"
#include "state/machine.h"

namespace ratchet_sieve
{
namespace
{

/// So many events are known in advance at a time, and what they need is prefetched: a few hundred lines of
/// the cache, which has room for them.
constexpr double EVENTS_AHEAD = 12.0;

/// As many disks as fit into the processor's own caches; for fewer there is nothing to prefetch.
constexpr std::size_t DISKS_IN_CACHE = 30000;

/// One event a disk, its earliest: with a pair, with the base, or with a cell's edge. A predicted
/// pair whose partner has changed its flight since is found stale when its time comes, and
/// the disk is searched for pairs again (Lubachevsky, J. Comput. Phys. 94, 255 (1991)). Ties within a disk
/// go to the pair, then to the base's feature, then to the cell; ties between disks to the smaller slot.
///
/// The base is searched lazily: no further than the disk's next other event, for most flights end
/// in a pair before they come to the base.
///
/// No pair is missed, however large cells are: whenever a disk begins a flight or comes into a cell it is
/// searched for contacts with all disks in the cells that touch its own, as of both flights for ever; and two
/// disks whose cells do not touch are further apart than the largest diameter. So of two disks that come to
/// touch, the one that last began its flight or came into its cell was searched against the other. On a ring
/// of one column the cell is as wide as the laps it reaches beyond its ends, and all images that can be
/// within it are searched (RingCourse).
class PairLoop : public EventLoop
{
public:
  explicit PairLoop(Machine& machine)
      : machine_(machine), state_(machine.state()), base_(state_.motion()), cells_(state_)
  {
    predictions_.reserve(state_.disks().size());
    queue_.resize(state_.disks().size());
  }

  double advanceTo(double time) override
  {
    while (queue_.topTime() <= time)
    {
      if (machine_.collapseWatch().stops())
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
    state(cells_, queue_, predictions_);
    requireDisks(predictions_.size(), state_);
  }

private:
  using Edge = DiskCells::Edge;

  /// The first event of each sort on a disk's present flight.
  struct Prediction
  {
    PairContact pair;
    std::uint32_t partner_flights = 0;  ///< the partner's count when this was predicted
    Edge edge = Edge::NONE;
    double cell_time = EventQueue::NEVER;  ///< when it leaves its cell; without an edge: not before
    BaseEvent base;

    void archive(StateArchive& state) { state(pair, partner_flights, edge, cell_time, base); }
  };

  template <typename Visit>
  void forEachActive(Visit&& visit) const
  {
    for (std::uint32_t slot = 0; slot < predictions_.size(); ++slot)
      if (state_.active(slot))
        visit(slot);
  }

  /// Prefetches what the next events need, all at once, where each event by itself would miss the cache for
  /// one thing after another: its prediction, its partner, the cells, the disks in them.
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
      cells_.visit(slot, {}, near_,
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
    machine_.prefetchEvent(slot);
  }

  void process(std::uint32_t slot)
  {
    const double now = queue_.topTime();
    if (machine_.collapseWatch().count(slot, now) && machine_.collapseWatch().stops())
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
    if (!state_.active(p.pair.partner) || state_.disk(p.pair.partner).flights != p.partner_flights)
    {
      searchPairs(slot, now);
      refresh(slot);
      return;
    }
    machine_.collidePair(slot, p.pair.partner, p.pair.shift, now);
    predict(slot, now);
    predict(p.pair.partner, now);
  }

  void processBase(std::uint32_t slot, double now)
  {
    machine_.handleBaseEvent(slot, predictions_[slot].base.feature, now, base_);
    if (state_.active(slot))
      return predict(slot, now);
    cells_.remove(slot);
    predictions_[slot] = Prediction();
    queue_.update(slot, EventQueue::NEVER);
  }

  void crossEdge(std::uint32_t slot, double now)
  {
    const Edge edge = predictions_[slot].edge;
    if (cells_.cross(slot, edge, now))
      return predict(slot, now);
    searchPairsIn(slot, DiskCells::beyond(edge), now);
    predictions_[slot].edge = Edge::NONE;
    predictions_[slot].cell_time = now;
    refresh(slot);
  }

  /// A new flight: everything is predicted again.
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
    searchPairsIn(slot, {}, now);
  }

  void searchPairsIn(std::uint32_t slot, const CellGrid::Surroundings& around, double now)
  {
    Prediction& p = predictions_[slot];
    const PairSearch search(state_.pairScene(), slot, now);
    const int ring_shifts = cells_.ringShifts();
    cells_.visit(slot, around, near_,
                 [&](const std::uint32_t* others, std::size_t count, int shift)
                 {
                   const PairContact found = ring_shifts > 0 ? search.firstOnRing(others, count, ring_shifts)
                                                             : search.firstAmong(others, count, shift);
                   if (!found.isBefore(p.pair))
                     return;
                   p.pair = found;
                   p.partner_flights = state_.disk(found.partner).flights;
                 });
  }

  /// Carries the searches of the cell's edges and of the base on to the disk's next other event, and
  /// queues the earliest.
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

  Machine& machine_;
  MachineState& state_;
  BaseInstant base_;
  DiskCells cells_;
  EventQueue queue_;
  std::vector<Prediction> predictions_;  ///< per disk
  PrefetchWindow prefetched_{EVENTS_AHEAD};
  std::vector<std::uint32_t> next_;  ///< the disks whose events are known in advance
  std::vector<std::uint32_t> near_;  ///< the disks that a search tests
};

}  // namespace

std::unique_ptr<EventLoop> makePairLoop(Machine& machine)
{
  return std::make_unique<PairLoop>(machine);
}

}  // namespace ratchet_sieve
