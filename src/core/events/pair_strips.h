#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

#include "events/event_loop.h"
#include "events/pair_events.h"
#include "events/slot_queue.h"
#include "simd/worker_pool.h"

namespace ratchet_sieve
{

/// A barrier for threads that meet every few hundred microseconds: it spins before it gives the processor
/// away.
class SpinBarrier
{
public:
  explicit SpinBarrier(std::size_t threads) : threads_(threads) {}

  /// Waits for all threads. The last one calls `complete` before any goes on.
  template <typename Complete>
  void wait(Complete&& complete)
  {
    const std::size_t round = round_.load(std::memory_order_relaxed);
    if (waiting_.fetch_add(1, std::memory_order_acq_rel) + 1 == threads_)
    {
      complete();
      waiting_.store(0, std::memory_order_relaxed);
      round_.store(round + 1, std::memory_order_release);
      return;
    }
    for (int spins = 0; round_.load(std::memory_order_acquire) == round; ++spins)
      if (spins > SPINS)
        std::this_thread::yield();
  }

private:
  /// Some ten microseconds.
  static constexpr int SPINS = 10000;

  std::size_t threads_;
  alignas(64) std::atomic<std::size_t> waiting_{0};
  alignas(64) std::atomic<std::size_t> round_{0};
};

/// Advances a layer strip by strip, on several threads, with the bits of a single queue.
///
/// The columns of cells are cut into strips. Time is cut into windows of a few events per column. In a
/// window, each strip first executes its own events in order, except those that touch columns near a cut, and
/// those that touch columns of an event so left out: these columns are *frozen*, and more of them as time
/// goes on. Then the events left out are executed around each cut. So every event sees what the events before
/// it have done, as with a single queue, and nothing of later ones.
///
/// That fails if the events around a cut lead to one that touches a column which its strip has meanwhile
/// taken further. It is seen by the time at which each column was touched last. Then everything goes back to
/// a copy of the layer taken some windows before, and the caller repeats these with a single queue. The same
/// is done if a disk collapses. With the margin of frozen columns at the cuts it is rare.
class PairStrips
{
public:
  /// Cuts where each strip has as many disks.
  /// @param layer outlives this; no grid is built while it exists
  /// @param count of strips, from 2 to mostStrips(); @param pool null: one thread
  PairStrips(PairLayer& layer, std::size_t count, const StripSettings& settings, WorkerPool* pool);

  static std::size_t mostStrips(const DiskCells& cells, const StripSettings& settings);

  /// Executes every event from `now` up to and including `time`.
  /// @return whether it did; otherwise the layer is as it was after some earlier event, and this object
  /// useless
  bool advance(double now, double time);

  /// The end of the window that failed.
  double failedBefore() const { return end_; }

  /// The length of a window with as many events as wanted [s], and their number as a share of the settings',
  /// which grows to 1 as long as no window fails.
  double windowLength() const { return length_; }
  double windowShare() const { return window_share_; }

  /// May be called before advance().
  void setWindows(double length, double share);

  /// The number of events since the last call that advance() has executed for good.
  std::uint64_t takeEvents() { return std::exchange(events_, 0); }

  /// The number of copies of the layer taken.
  std::uint64_t copies() const { return copies_; }

private:
  /// Neighbouring columns whose events one thread executes.
  struct Region
  {
    Region(PairLayer& layer, std::vector<std::uint32_t>& places, std::int32_t first_column,
           std::int32_t size);

    std::int32_t first_column;
    std::int32_t columns;
    ThreadBuffer buffer;
    SlotQueue queue;
    PairEvents<SlotQueue> events;
  };

  struct Strip : Region
  {
    using Region::Region;
    ColumnSpan free{0, 0};                 ///< not frozen, from its first column
    std::vector<std::uint32_t> left_over;  ///< slots whose events are left to the cut at its left
    std::vector<std::uint32_t> right_over;
  };

  /// Half of the strip at the left, and half of the one at the right.
  struct Cut : Region
  {
    using Region::Region;
    std::size_t left = 0;                ///< strip
    std::size_t right = 0;               ///< strip
    std::vector<std::uint32_t> changed;  ///< slots whose next event changed
    std::vector<std::uint32_t> moved;    ///< of these, those that left their strip
  };

  void cutIntoStrips(std::size_t count);
  std::uint16_t stripOf(std::uint32_t slot) const
  {
    return strip_of_[static_cast<std::size_t>(layer_.cells.grid().columnOf(slot))];
  }
  void work(std::size_t worker, std::size_t workers, SpinBarrier& barrier, double time);
  template <typename Phase>
  void guarded(Phase&& phase);
  void advance(std::size_t strip);
  void leaveOver(Strip& strip, std::uint32_t slot, const ColumnSpan& span);
  void advance(Cut& cut);
  bool execute(Region& region, std::uint32_t slot, double now, const ColumnSpan& span);
  ColumnSpan touched(const Region& region, std::uint32_t slot, double now) const;
  std::int32_t placeIn(const Region& region, std::uint32_t slot) const;
  double nextTime(std::uint32_t slot) const;
  void finishWindow(double time);
  template <typename Visit>
  void forEachRegion(Visit&& visit)
  {
    for (const auto& strip : strips_)
      visit(*strip);
    for (const auto& cut : cutting_)
      visit(*cut);
  }
  void moveDisks();
  void copyHalf(std::size_t half);
  void restore();
  void commit();
  void fail() { failed_.store(true, std::memory_order_relaxed); }

  PairLayer& layer_;
  StripSettings settings_;
  WorkerPool* pool_;
  bool ring_;                                ///< whether the last strip is next to the first
  std::vector<std::uint16_t> strip_of_;      ///< per column
  std::vector<std::uint16_t> home_;          ///< per slot: the strip whose queue has it
  std::vector<std::uint32_t> strip_places_;  ///< see SlotQueue
  std::vector<std::uint32_t> cut_places_;
  std::vector<std::unique_ptr<Strip>> strips_;
  std::vector<std::unique_ptr<Cut>> cutting_;  ///< each at the right end of the strip of the same number
  std::vector<double> touched_;                ///< per column, with two more at each end: last time [s]

  double length_ = 0.0;  ///< of a window [s]
  double window_share_ = 1.0;
  double start_ = 0.0;  ///< of the present window [s]
  double end_ = 0.0;
  bool done_ = false;
  bool copy_is_due_ = false;
  std::atomic<bool> failed_{false};
  std::exception_ptr error_;
  std::uint64_t events_to_commit_ = 0;  ///< up to the last window
  std::uint64_t events_ = 0;
  std::uint64_t copies_ = 0;

  struct Copy
  {
    SystemState::Snapshot state;
    DiskCells::Snapshot cells;
    SlotArray<DiskPrediction> predictions;
  };
  Copy copy_;
};

}  // namespace ratchet_sieve
