#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "model/processor.h"
#include "model/slot_array.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The disks of each cell, contiguous in memory, so that a search reads them without following pointers. When
/// a cell's block is full, it is moved to the overflow list and an empty one begins.
///
/// Several threads may change different cells at the same time, after reserveOverflow().
class CellBlocks
{
public:
  explicit CellBlocks(std::size_t cells = 0) : blocks_(cells) {}

  void add(std::size_t cell, std::uint32_t slot)
  {
    if (blocks_[cell].count == Block::CAPACITY)
      pushFullBlock(cell);
    Block& block = blocks_[cell];
    block.slots[block.count++] = slot;
  }

  /// @pre the disk is in this cell
  void remove(std::size_t cell, std::uint32_t slot);

  /// Number of cells.
  std::size_t size() const { return blocks_.size(); }

  /// Appends the disks of `rows` times `columns` cells to the first `count` of the list: row by row, each
  /// from the cell `first` on, `stride` cells after the one before. @return the new count
  std::size_t collect(std::size_t first, std::size_t columns, std::size_t rows, std::size_t stride,
                      std::vector<std::uint32_t>& list, std::size_t count) const
  {
    const std::size_t room = rows * columns * Block::CAPACITY;
    if (list.size() < count + room)
      list.resize(2 * (count + room));
    std::uint32_t* to = list.data() + count;
    const Block* row = &blocks_[first];
    for (std::size_t r = 0; r < rows; ++r, row += stride)
      for (const Block* block = row; block != row + columns; ++block)
      {
        to = copy(*block, to);
        if (__builtin_expect(block->next != NONE, 0) != 0)
          to = copyOverflow(block->next, list, to, room);
      }
    return static_cast<std::size_t>(to - list.data());
  }

  /// Allocates the overflow list for this number of disks in all cells.
  void reserveOverflow(std::size_t disks) { full_.reserve(disks / Block::CAPACITY + 1); }

  void prefetchCell(std::size_t cell) const { prefetch(blocks_[cell]); }

  /// The overflow list is saved in the order of the cells: its own depends on the threads.
  void archive(StateArchive& state);

private:
  static constexpr std::uint32_t NONE = 0xffffffff;

  struct Block
  {
    static constexpr std::size_t CAPACITY = 6;
    std::array<std::uint32_t, CAPACITY> slots{};
    std::uint32_t count = 0;
    std::uint32_t next = NONE;  ///< the previous full block in the overflow list

    void archive(StateArchive& state) { state(slots, count, next); }
  };

  /// For the overflow list. A copy is free.
  class Lock
  {
  public:
    Lock() = default;
    Lock(const Lock& /*other*/) {}
    Lock& operator=(const Lock& /*other*/) { return *this; }
    void lock()
    {
      while (taken_.exchange(true, std::memory_order_acquire))
        ;
    }
    void unlock() { taken_.store(false, std::memory_order_release); }

  private:
    std::atomic<bool> taken_{false};
  };

  /// Copies the whole block regardless of its count: this needs no branch. @return the end of its disks
  static std::uint32_t* copy(const Block& block, std::uint32_t* to)
  {
    std::memcpy(to, block.slots.data(), sizeof block.slots);
    return to + block.count;
  }
  std::uint32_t* copyOverflow(std::uint32_t entry, std::vector<std::uint32_t>& list, std::uint32_t* to,
                              std::size_t room) const;
  void sortOverflow();
  void pushFullBlock(std::size_t cell);
  void popFullBlock(std::size_t cell);

  SlotArray<Block> blocks_;          ///< per cell
  SlotArray<Block> full_;            ///< overflow: full blocks of cells
  std::vector<std::uint32_t> free_;  ///< unused entries of full_
  Lock lock_;                        ///< of the sizes of full_ and free_
};

}  // namespace ratchet_sieve
