#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "events/event_loop.h"
#include "events/event_queue.h"
#include "events/look_ahead.h"
#include "model/prefetch.h"
#include "ratchet_sieve/core/resolution.h"
#include "search/cell_grid.h"
#include "search/cell_layout.h"
#include "search/pair_search.h"
#include "search/quadratic.h"
#include "state/machine.h"

namespace ratchet_sieve
{
namespace
{

/// Cells are wider than the largest diameter by this share, which leaves room for rounding.
constexpr double CELL_MARGIN = 0.005;

/// While a periodic base turns, its lattice turns against the cells: they are wider then by more
/// than it may, so that they need not be laid anew at every other collision.
constexpr double TURNING_CELL_MARGIN = MachineState::LATTICE_MARGIN + CELL_MARGIN;

/// Beyond so many laps a disk is wrapped in any case: its images within reach are looked at one by one.
constexpr double MOST_LAPS = 64.0;

/// So many events are known in advance at a time, and what they need is fetched: a few hundred lines of the
/// cache, which has room for them.
constexpr double EVENTS_AHEAD = 12.0;

/// As many disks as fit into the processor's own caches; for fewer there is nothing to fetch.
constexpr std::size_t DISKS_IN_CACHE = 30000;

/// One event a disk, its earliest: with a pair, with the base, or with a cell's edge. A predicted
/// pair whose partner has changed its flight since is found stale when it is due, and the disk
/// looks for pairs again (Lubachevsky, J. Comput. Phys. 94, 255 (1991)). Ties within a disk go to the
/// pair, then to the base's feature, then to the cell; ties between disks to the smaller slot.
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
///
/// Cells are laid for a shaken layer. Where disks fly so far and fast that most events are crossings, they
/// are laid anew at the end of an epoch, as LayoutCosts finds it cheapest for the disks as they are then.
class PairLoop : public EventLoop
{
public:
  explicit PairLoop(Machine& machine)
      : machine_(machine),
        state_(machine.state()),
        base_(state_.motion()),
        grid_(makeGrid()),
        laid_for_(state_.disks().size())
  {
    predictions_.reserve(laid_for_);
    grid_capacity_ = laid_for_;
    queue_.resize(laid_for_);
  }

  double advanceTo(double time) override
  {
    while (queue_.topTime() <= time)
    {
      if (machine_.collapseWatch().stops())
        return queue_.topTime();
      if (queue_.topTime() > ahead_.end())
        lookAhead();
      process(queue_.top());
    }
    return time;
  }

  void added(std::uint32_t slot, double time) override
  {
    predictions_.resize(slot + 1);
    if (slot + 1 > grid_capacity_)
    {
      grid_capacity_ = 2 * (slot + 1);
      queue_.resize(grid_capacity_);
      grid_.resize(grid_capacity_);
    }
    // Cells that were laid for far fewer disks would hold too many each.
    if (predictions_.size() > 2 * laid_for_)
      return motionChanged(time);
    place(slot, time);
    predict(slot, time);
  }

  void motionChanged(double time) override
  {
    base_.forget();
    layCells(time);
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
    ahead_.rebase(length);
  }

  bool outgrown(double time) override
  {
    const std::optional<double> events = fit_.epochEnded(events_, state_.activeCount());
    if (!events)
      return false;
    std::vector<BasePoint> points;
    forEachActive([&](std::uint32_t slot) { points.push_back(inGrid(slot, time)); });
    const int spare_laps = state_.scene().boundary == Boundary::PERIODIC ? laps() : 0;
    const LayoutCosts costs(points, state_.sawtooth().width(), *events / state_.epoch().length, spare_laps);
    return fit_.choose(costs, layerLayout(), leastSide());
  }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(frame_, fit_, grid_, grid_capacity_, laid_for_, queue_, predictions_);
    requireDisks(predictions_.size(), state_);
  }

private:
  enum class Edge : std::uint8_t
  {
    NONE,
    LEFT,
    RIGHT,
    LOWER,
    UPPER
  };

  /// What a disk's present flight will meet first, of each sort.
  struct Prediction
  {
    PairContact pair;
    std::uint32_t partner_flights = 0;  ///< the partner's count when this was predicted
    Edge edge = Edge::NONE;
    double cell_time = EventQueue::NEVER;  ///< when it leaves its cell; without an edge: not before
    BaseEvent base;

    void archive(StateArchive& state) { state(pair, partner_flights, edge, cell_time, base); }
  };

  /// Cells for the disks there are now, on the base as it stands.
  void layCells(double time)
  {
    grid_ = makeGrid();
    grid_.resize(grid_capacity_);
    laid_for_ = predictions_.size();
    forEachActive([&](std::uint32_t slot) { place(slot, time); });
  }

  CellGrid makeGrid()
  {
    const SceneDefinition& scene = state_.scene();
    frame_ = state_.motion().at(state_.motion().segmentStart());
    const bool periodic = scene.boundary == Boundary::PERIODIC;
    const CellLayout layout = fit_.layout().value_or(layerLayout());
    const std::size_t count = std::max<std::size_t>(1, state_.activeCount());
    return CellGrid(scene.base.width(), layout.height, std::max(layout.smallest_side, leastSide()), count,
                    periodic, fit_.layout() ? laps() : 0);
  }

  /// The smallest side that cells may have [m].
  double leastSide() const
  {
    const bool lattice_turns = state_.scene().boundary == Boundary::PERIODIC && state_.motion().turning();
    return state_.largestDiameter() * (1.0 + (lattice_turns ? TURNING_CELL_MARGIN : CELL_MARGIN));
  }

  /// Cells for a shaken layer.
  CellLayout layerLayout() const
  {
    const SceneDefinition& scene = state_.scene();
    const double count = std::max<double>(1.0, static_cast<double>(state_.activeCount()));
    const double diameter = state_.largestDiameter();
    const double layers = count * diameter * diameter / scene.base.width();
    // As high as the shaken layer: what is poured from above it, or thrown out of it, is in the topmost row.
    const double height = scene.base.tooth_height + layers +
                          std::min(state_.motion().throwHeight(scene.gravity), scene.base.width());
    return {height, leastSide()};
  }

  /// By how many laps a disk may be away from home where it need not be wrapped: places there are still fine
  /// enough for the smallest disk. On a base that turns images do not move as the disk does: none.
  std::int32_t laps() const
  {
    if (state_.motion().turning())
      return 0;
    const double farthest = farthestPlace(state_.smallestRadius()) / state_.sawtooth().width();
    return static_cast<std::int32_t>(std::clamp(std::floor(farthest) - 1.0, 0.0, MOST_LAPS));
  }

  template <typename Visit>
  void forEachActive(Visit&& visit) const
  {
    for (std::uint32_t slot = 0; slot < predictions_.size(); ++slot)
      if (state_.active(slot))
        visit(slot);
  }

  /// A disk in the frame of the cells, which stands still.
  BasePoint inGrid(std::uint32_t slot, double time) const
  {
    const Course now = courseAt(state_.disk(slot), time, state_.scene().gravity);
    return {frame_.into(vectorOf(now.place)), frame_.into(vectorOf(now.velocity))};
  }

  /// Puts a disk into its cell, once it is within the ring: cells that were laid anew may have left
  /// it outside.
  void place(std::uint32_t slot, double time)
  {
    state_.bringHome(slot, inGrid(slot, time).s(), time);
    grid_.add(slot, cellNow(slot, time));
  }

  CellGrid::Cell cellNow(std::uint32_t slot, double time) const
  {
    const BasePoint p = inGrid(slot, time);
    return grid_.cellAt(p.s(), p.n());
  }

  /// Fetches what the next events need, all at once, where each event by itself would wait for one thing
  /// after another: its prediction, its partner, the cells, the disks in them.
  void lookAhead()
  {
    ahead_.begin(queue_.topTime(), events_);
    if (predictions_.size() < DISKS_IN_CACHE)
      return;
    queue_.upTo(ahead_.end(), next_);
    for (const std::uint32_t slot : next_)
      prefetchEvent(slot);
    for (const std::uint32_t slot : next_)
    {
      const PairContact& pair = predictions_[slot].pair;
      if (pair.time <= ahead_.end())
        prefetchEvent(pair.partner);
      grid_.prefetchAround(grid_.cellOf(slot));
    }
    for (const std::uint32_t slot : next_)
      grid_.visit(grid_.cellOf(slot), {}, near_,
                  [this](const std::uint32_t* others, std::size_t count, int)
                  {
                    for (std::size_t i = 0; i < count; ++i)
                      prefetch(state_.disk(others[i]));
                  });
  }

  void prefetchEvent(std::uint32_t slot) const
  {
    prefetch(predictions_[slot]);
    grid_.prefetchCellOf(slot);
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
    grid_.remove(slot);
    predictions_[slot] = Prediction();
    queue_.update(slot, EventQueue::NEVER);
  }

  void crossEdge(std::uint32_t slot, double now)
  {
    fit_.crossed();
    CellGrid::Cell cell = grid_.cellOf(slot);
    const Edge edge = predictions_[slot].edge;
    grid_.remove(slot);
    cell.column += edge == Edge::RIGHT ? 1 : edge == Edge::LEFT ? -1 : 0;
    cell.row += edge == Edge::UPPER ? 1 : edge == Edge::LOWER ? -1 : 0;
    const int laps = cell.column < 0 ? -1 : cell.column >= grid_.columns() ? 1 : 0;
    if (laps != 0)
    {
      if (grid_.laps() > 0)
        state_.bringHome(slot, inGrid(slot, now).s(), now);
      else
        state_.wrap(slot, -laps, now);
      cell.column -= laps * grid_.columns();
      cell.row = cellNow(slot, now).row;
      grid_.add(slot, cell);
      predict(slot, now);
      return;
    }
    grid_.add(slot, cell);
    searchNewPairs(slot, edge, now);
    predictions_[slot].edge = Edge::NONE;
    predictions_[slot].cell_time = now;
    refresh(slot);
  }

  /// A new flight: everything is predicted anew.
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

  /// After an edge was crossed: only the three cells that have come near.
  void searchNewPairs(std::uint32_t slot, Edge edge, double now)
  {
    CellGrid::Surroundings around;
    switch (edge)
    {
      case Edge::LEFT:
        around.last_column = -1;
        break;
      case Edge::RIGHT:
        around.first_column = 1;
        break;
      case Edge::LOWER:
        around.last_row = -1;
        break;
      case Edge::UPPER:
        around.first_row = 1;
        break;
      case Edge::NONE:
        return;
    }
    searchPairsIn(slot, around, now);
  }

  void searchPairsIn(std::uint32_t slot, const CellGrid::Surroundings& around, double now)
  {
    Prediction& p = predictions_[slot];
    const PairSearch search(state_.pairScene(), slot, now);
    grid_.visit(grid_.cellOf(slot), around, near_,
                [&](const std::uint32_t* others, std::size_t count, int shift)
                {
                  const PairContact found = grid_.laps() > 0
                                                ? search.firstOnRing(others, count, 2 * grid_.laps() + 2)
                                                : search.firstAmong(others, count, shift);
                  if (!found.isBefore(p.pair))
                    return;
                  p.pair = found;
                  p.partner_flights = state_.disk(found.partner).flights;
                });
  }

  /// When the disk leaves its cell after p.cell_time, and by which edge, if it does so before `until`.
  void searchEdge(std::uint32_t slot, Prediction& p, double until) const
  {
    const double now = p.cell_time;
    const CellGrid::Cell cell = grid_.cellOf(slot);
    const BasePoint at = inGrid(slot, now);
    const auto fall = verticalIntoBase(frame_.rotation, -state_.scene().gravity);
    p.cell_time = until;
    const auto leave = [&](Edge edge, double gap, double rate, double accel)
    {
      // Most edges are not met, which takes no root to see: open at both ends, a gap that bends inwards
      // is open in between.
      const double span = p.cell_time - now;
      if (gap > 0.0 && accel <= 0.0 && gap + (rate + 0.5 * accel * span) * span > 0.0)
        return;
      const auto wait = firstClosingTime(gap, rate, accel);
      if (!wait || now + *wait >= p.cell_time)
        return;
      p.cell_time = now + *wait;
      p.edge = edge;
    };
    if (grid_.periodic() || cell.column > 0)
      leave(Edge::LEFT, at.s() - grid_.leftEdge(cell.column), at.velocity.x(), fall.first);
    if (grid_.periodic() || cell.column + 1 < grid_.columns())
      leave(Edge::RIGHT, grid_.rightEdge(cell.column) - at.s(), -at.velocity.x(), -fall.first);
    if (cell.row > 0)
      leave(Edge::LOWER, at.n() - grid_.rowStart(cell.row), at.velocity.y(), fall.second);
    if (cell.row + 1 < grid_.rows())
      leave(Edge::UPPER, grid_.rowStart(cell.row + 1) - at.n(), -at.velocity.y(), -fall.second);
  }

  /// Carries the searches of the cell's edges and of the base on to the disk's next other event, and
  /// queues the earliest.
  void refresh(std::uint32_t slot)
  {
    Prediction& p = predictions_[slot];
    if (p.edge == Edge::NONE && p.cell_time < p.pair.time)
      searchEdge(slot, p, p.pair.time);
    const double others = std::min(p.pair.time, p.cell_time);
    if (!p.base.feature && p.base.time < others)
      p.base = state_.nextBaseEvent(slot, p.base.time, others, base_);
    queue_.update(slot, std::min(others, p.base.time));
  }

  Machine& machine_;
  MachineState& state_;
  BaseInstant base_;
  FrameOfBase frame_;  ///< of the cells: the base's when the grid was laid
  CellFit fit_;
  CellGrid grid_;
  std::size_t grid_capacity_ = 0;
  std::size_t laid_for_ = 0;  ///< disks that had entered when the cells were laid
  EventQueue queue_;
  std::vector<Prediction> predictions_;  ///< per disk
  LookAhead ahead_{EVENTS_AHEAD};
  std::vector<std::uint32_t> next_;  ///< the disks whose events are known in advance
  std::vector<std::uint32_t> near_;  ///< the disks that a search looks at
};

}  // namespace

std::unique_ptr<EventLoop> makePairLoop(Machine& machine)
{
  return std::make_unique<PairLoop>(machine);
}

}  // namespace ratchet_sieve
