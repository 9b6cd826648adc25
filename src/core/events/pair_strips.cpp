#include "events/pair_strips.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace ratchet_sieve
{
namespace
{
/// A copy of the layer is taken after this number of events per disk: it then costs about a hundredth of the
/// time.
constexpr double EVENTS_PER_COPY = 16.0;

/// By this factor windows grow from copy to copy: a window that fails costs no more than the events since
/// one.
constexpr double FASTER = 1.2;

/// Shortest window [time scales].
constexpr double SHORTEST_WINDOW = 1e-6;

/// The number of further columns that an event may touch.
constexpr std::int32_t REACH = 2;

/// See copyHalf(): of about the same size.
constexpr std::size_t COPY_HALVES = 2;

constexpr double LONG_AGO = -std::numeric_limits<double>::infinity();
}  // namespace

PairStrips::Region::Region(PairLayer& layer, std::vector<std::uint32_t>& places, std::int32_t first_column,
                           std::int32_t size)
    : first_column(first_column),
      columns(size),
      buffer(layer.state.log().buffer()),
      queue(places),
      events(layer, queue, &buffer)
{
}

std::size_t PairStrips::mostStrips(const DiskCells& cells, const StripSettings& settings)
{
  const std::int32_t most = cells.grid().columns() / settings.columns_per_strip;
  return cells.seesNextColumnOnly() ? static_cast<std::size_t>(std::max(most, 1)) : 1;
}

PairStrips::PairStrips(PairLayer& layer, std::size_t count, const StripSettings& settings, WorkerPool* pool)
    : layer_(layer),
      settings_(settings),
      pool_(pool),
      ring_(layer.state.scene().boundary == Boundary::PERIODIC),
      home_(layer.predictions.size()),
      strip_places_(layer.predictions.size(), SlotQueue::NONE),
      cut_places_(layer.predictions.size(), SlotQueue::NONE)
{
  cutIntoStrips(count);
  const std::size_t cuts = ring_ ? count : count - 1;
  for (std::size_t s = 0; s < cuts; ++s)
  {
    const std::size_t next = (s + 1) % count;
    const std::int32_t middle = strips_[s]->first_column + strips_[s]->columns / 2;
    const std::int32_t length = strips_[s]->columns - strips_[s]->columns / 2 + strips_[next]->columns / 2;
    cutting_.push_back(std::make_unique<Cut>(layer_, cut_places_, middle, length));
    cutting_.back()->left = s;
    cutting_.back()->right = next;
  }
  touched_.assign(strip_of_.size() + 2 * REACH, LONG_AGO);
  for (const std::uint32_t slot : layer_.state.slots(true))
  {
    home_[slot] = stripOf(slot);
    strips_[home_[slot]]->queue.update(slot, nextTime(slot));
  }
  layer_.cells.shareAmongThreads();
}

/// With about as many disks and columns in each, none narrower than mostStrips() allows.
void PairStrips::cutIntoStrips(std::size_t count)
{
  const std::int32_t columns = layer_.cells.grid().columns();
  std::vector<std::size_t> disks(static_cast<std::size_t>(columns), 1);
  for (const std::uint32_t slot : layer_.state.slots(true))
    ++disks[static_cast<std::size_t>(layer_.cells.grid().columnOf(slot))];
  const std::size_t all = std::accumulate(disks.begin(), disks.end(), std::size_t{0});
  const std::int32_t least = columns / static_cast<std::int32_t>(mostStrips(layer_.cells, settings_));
  std::int32_t first = 0;
  std::size_t sum = 0;
  for (std::size_t s = 0; s < count; ++s)
  {
    const auto rest = static_cast<std::int32_t>(count - 1 - s);
    std::int32_t last = first;
    while (last < columns && (last - first < least || sum * count < (s + 1) * all) &&
           columns - last > rest * least)
      sum += disks[static_cast<std::size_t>(last++)];
    if (rest == 0)
      last = columns;
    strips_.push_back(std::make_unique<Strip>(layer_, strip_places_, first, last - first));
    strip_of_.resize(static_cast<std::size_t>(last), static_cast<std::uint16_t>(s));
    first = last;
  }
}

/// Not so short, in a collapse, that time stands still.
void PairStrips::setWindows(double length, double share)
{
  length_ = std::max(length, SHORTEST_WINDOW * layer_.state.timeScale());
  window_share_ = share;
}

double PairStrips::nextTime(std::uint32_t slot) const
{
  return layer_.state.active(slot) ? layer_.predictions[slot].earliest() : EventQueue::NEVER;
}

bool PairStrips::advance(double now, double time)
{
  copy_is_due_ = true;
  done_ = false;
  start_ = now;
  end_ = std::min(time, now + length_);
  const std::size_t workers = pool_ != nullptr ? std::min(pool_->workers(), strips_.size()) : 1;
  SpinBarrier barrier(workers);
  if (workers == 1)
    work(0, 1, barrier, time);
  else
    pool_->run(
        [&](std::size_t worker)
        {
          if (worker < workers)
            work(worker, workers, barrier, time);
        });
  if (error_)
    std::rethrow_exception(error_);
  if (!failed_)
    commit();
  else
    restore();
  // By the caller's thread.
  layer_.state.log().deliver();
  return !failed_;
}

void PairStrips::work(std::size_t worker, std::size_t workers, SpinBarrier& barrier, double time)
{
  const auto share = [&](std::size_t count, auto&& each)
  {
    for (std::size_t k = worker * count / workers; k < (worker + 1) * count / workers; ++k)
      each(k);
  };
  while (!done_)
  {
    if (copy_is_due_)
    {
      guarded([&] { share(COPY_HALVES, [&](std::size_t half) { copyHalf(half); }); });
      barrier.wait([&] { copy_is_due_ = false; });
    }
    guarded([&] { share(strips_.size(), [&](std::size_t s) { advance(s); }); });
    barrier.wait([] {});
    if (!failed_)
      guarded([&] { share(cutting_.size(), [&](std::size_t c) { advance(*cutting_[c]); }); });
    barrier.wait(
        [&]
        {
          if (!failed_)
            guarded([&] { finishWindow(time); });
          done_ = done_ || failed_;
        });
  }
}

/// An exception must not keep a thread from the barrier.
template <typename Phase>
void PairStrips::guarded(Phase&& phase)
{
  try
  {
    phase();
  }
  catch (...)
  {
    if (!failed_.exchange(true))
      error_ = std::current_exception();
  }
}

std::int32_t PairStrips::placeIn(const Region& region, std::uint32_t slot) const
{
  const std::int32_t place = layer_.cells.grid().columnOf(slot) - region.first_column;
  return place < 0 && ring_ ? place + layer_.cells.grid().columns() : place;
}

/// From the region's first column.
ColumnSpan PairStrips::touched(const Region& region, std::uint32_t slot, double now) const
{
  const std::int32_t offset = placeIn(region, slot) - layer_.cells.grid().columnOf(slot);
  const ColumnSpan span = region.events.touched(slot, now);
  return {span.first + offset, span.last + offset};
}

bool PairStrips::execute(Region& region, std::uint32_t slot, double now, const ColumnSpan& span)
{
  if (!layer_.state.collapseWatch().countOrdinary(slot, now))
    return false;
  region.buffer.beginEvent(slot);
  region.events.process(slot, now);
  if (!layer_.state.active(slot))
    return true;
  // It was searched for pairs in the columns next to it.
  const std::int32_t place = placeIn(region, slot);
  return place - 1 >= span.first && place + 1 <= span.last;
}

void PairStrips::advance(std::size_t s)
{
  Strip& strip = *strips_[s];
  const bool cut_left = ring_ || s > 0;
  const bool cut_right = ring_ || s + 1 < strips_.size();
  const auto update_from = [&](const Cut& cut)
  {
    for (const std::uint32_t slot : cut.changed)
      if (home_[slot] == s)
        strip.queue.update(slot, nextTime(slot));
  };
  if (cut_left)
    update_from(*cutting_[(s + strips_.size() - 1) % strips_.size()]);
  if (cut_right)
    update_from(*cutting_[s]);
  strip.free = {cut_left ? settings_.margin : -REACH,
                strip.columns - 1 + (cut_right ? -settings_.margin : REACH)};
  while (strip.queue.topTime() <= end_ && !failed_.load(std::memory_order_relaxed))
  {
    const double now = strip.queue.topTime();
    const std::uint32_t slot = strip.queue.top();
    const ColumnSpan span = touched(strip, slot, now);
    if (span.first < strip.free.first || span.last > strip.free.last)
    {
      leaveOver(strip, slot, span);
      continue;
    }
    if (!execute(strip, slot, now, span))
      return fail();
    double* const touched = &touched_[static_cast<std::size_t>(strip.first_column) + REACH];
    std::fill(touched + span.first, touched + span.last + 1, now);
  }
}

void PairStrips::leaveOver(Strip& strip, std::uint32_t slot, const ColumnSpan& span)
{
  const std::int32_t middle = strip.columns / 2;
  const bool left = span.first < strip.free.first;
  if (left ? span.last >= middle : span.first < middle)
    return fail();
  strip.queue.update(slot, EventQueue::NEVER);
  if (left)
    strip.free.first = std::max(strip.free.first, span.last + 1 + settings_.margin);
  else
    strip.free.last = std::min(strip.free.last, span.first - 1 - settings_.margin);
  (left ? strip.left_over : strip.right_over).push_back(slot);
}

void PairStrips::advance(Cut& cut)
{
  const auto queue_all = [&](std::vector<std::uint32_t>& slots)
  {
    for (const std::uint32_t slot : slots)
      cut.queue.update(slot, nextTime(slot));
    slots.clear();
  };
  queue_all(strips_[cut.left]->right_over);
  queue_all(strips_[cut.right]->left_over);
  const std::int32_t columns = layer_.cells.grid().columns();
  const auto is_free = [&](const ColumnSpan& span, double now)
  {
    if (span.first < 0 || span.last >= cut.columns)
      return false;
    for (std::int32_t k = span.first; k <= span.last; ++k)
      if (touched_[static_cast<std::size_t>((cut.first_column + k) % columns) + REACH] >= now)
        return false;
    return true;
  };
  while (cut.queue.topTime() <= end_)
  {
    const double now = cut.queue.topTime();
    const std::uint32_t slot = cut.queue.top();
    const ColumnSpan span = touched(cut, slot, now);
    if (!is_free(span, now) || !execute(cut, slot, now, span))
      return fail();
  }
  cut.changed.clear();
  cut.moved.clear();
  cut.queue.takeAll(
      [&](std::uint32_t slot)
      {
        cut.changed.push_back(slot);
        if (stripOf(slot) != home_[slot])
          cut.moved.push_back(slot);
      });
}

/// By one thread, between windows.
void PairStrips::finishWindow(double time)
{
  moveDisks();
  std::uint64_t all = 0;
  forEachRegion([&](const Region& region) { all += region.events.events(); });
  const auto found = static_cast<double>(all - std::exchange(events_to_commit_, all));
  const double wanted = window_share_ * settings_.events_per_column * layer_.cells.grid().columns();
  // Not from a window that ends early.
  if (const double whole = (end_ - start_) / length_; whole > 0.5)
    setWindows(length_ * std::clamp(whole * wanted / std::max(found, 1.0), 0.5, 2.0), window_share_);
  if (end_ >= time)
  {
    done_ = true;
    return;
  }
  if (static_cast<double>(events_to_commit_) >
      EVENTS_PER_COPY * static_cast<double>(layer_.state.activeCount()))
  {
    commit();
    copy_is_due_ = true;
  }
  start_ = end_;
  end_ = std::min(time, end_ + length_);
}

void PairStrips::moveDisks()
{
  for (const auto& cut : cutting_)
    for (const std::uint32_t slot : cut->moved)
    {
      strips_[home_[slot]]->queue.erase(slot);
      home_[slot] = stripOf(slot);
      strips_[home_[slot]]->queue.update(slot, nextTime(slot));
    }
}

/// Each half by one thread.
void PairStrips::copyHalf(std::size_t half)
{
  if (half == 0)
  {
    ++copies_;
    return layer_.state.copyTo(copy_.state);
  }
  layer_.cells.copyTo(copy_.cells);
  copy_.predictions = layer_.predictions;
}

void PairStrips::restore()
{
  layer_.state.restore(copy_.state);
  layer_.cells.restore(copy_.cells);
  layer_.predictions = copy_.predictions;
}

/// Hands over what the regions have counted and observed.
void PairStrips::commit()
{
  forEachRegion(
      [&](Region& region)
      {
        events_ += region.events.takeEvents();
        layer_.cells.countCrossings(region.events.takeCrossings());
        layer_.state.merge(std::exchange(region.buffer, layer_.state.log().buffer()));
      });
  events_to_commit_ = 0;
  window_share_ = std::min(FASTER * window_share_, 1.0);
}

}  // namespace ratchet_sieve
