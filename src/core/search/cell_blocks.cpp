#include "search/cell_blocks.h"

#include <algorithm>
#include <utility>

namespace ratchet_sieve
{

void CellBlocks::remove(std::size_t cell, std::uint32_t slot)
{
  if (blocks_[cell].count == 0)
    popFullBlock(cell);
  Block& first = blocks_[cell];
  const std::uint32_t last = first.slots[--first.count];
  if (last == slot)
    return;
  // The last disk takes the entry of the removed one, so that all blocks but the first stay full.
  for (Block* block = &first;; block = &full_[block->next])
  {
    const auto end = block->slots.begin() + block->count;
    const auto hole = std::find(block->slots.begin(), end, slot);
    if (hole == end)
      continue;
    *hole = last;
    return;
  }
}

/// Moves the cell's full block to the overflow list.
void CellBlocks::pushFullBlock(std::size_t cell)
{
  lock_.lock();
  std::size_t entry = full_.size();
  if (free_.empty())
    full_.emplace_back();
  else
  {
    entry = free_.back();
    free_.pop_back();
  }
  lock_.unlock();
  full_[entry] = blocks_[cell];
  blocks_[cell] = Block();
  blocks_[cell].next = static_cast<std::uint32_t>(entry);
}

/// An empty cell takes its last full block back from the overflow list.
void CellBlocks::popFullBlock(std::size_t cell)
{
  const std::uint32_t entry = blocks_[cell].next;
  blocks_[cell] = full_[entry];
  lock_.lock();
  free_.push_back(entry);
  lock_.unlock();
}

/// Copies a cell's full blocks to the end of a list, and leaves room for others after them.
std::uint32_t* CellBlocks::copyOverflow(std::uint32_t entry, std::vector<std::uint32_t>& list,
                                        std::uint32_t* to, std::size_t room) const
{
  for (; entry != NONE; entry = full_[entry].next)
  {
    const auto count = static_cast<std::size_t>(to - list.data());
    if (list.size() < count + Block::CAPACITY + room)
      list.resize(2 * (count + Block::CAPACITY + room));
    to = copy(full_[entry], list.data() + count);
  }
  return to;
}

void CellBlocks::sortOverflow()
{
  SlotArray<Block> sorted;
  sorted.reserve(full_.capacity());
  for (Block& first : blocks_)
    for (Block* block = &first; block->next != NONE; block = &sorted.back())
    {
      const std::uint32_t entry = std::exchange(block->next, static_cast<std::uint32_t>(sorted.size()));
      sorted.push_back(full_[entry]);
    }
  full_ = std::move(sorted);
  free_.clear();
}

void CellBlocks::archive(StateArchive& state)
{
  if (!state.restoring())
    sortOverflow();
  state(blocks_, full_, free_);
}

}  // namespace ratchet_sieve
