#include "ratchet_sieve/geometry/overlap_search.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "draws.h"

namespace ratchet_sieve
{
namespace
{

constexpr double DIAMETER = 0.004;

struct Placed
{
  double s;
  double n;
  double radius;
};

/// The smaller slot, the larger, and the image of the larger, in widths to the right.
using Overlap = std::tuple<std::uint32_t, std::uint32_t, int>;

Overlap ordered(std::uint32_t slot, std::uint32_t other, int shift)
{
  return slot < other ? Overlap{slot, other, shift} : Overlap{other, slot, -shift};
}

std::vector<Placed> someDisks(double width)
{
  const auto count = *rc::gen::inRange<std::size_t>(0, 80);
  const double smallest = *rc::gen::element(0.0001, 0.0005);
  const double most = *rc::gen::element(0.0002, 0.5 * DIAMETER);  // of half of them
  std::vector<Placed> disks(count);
  for (Placed& disk : disks)
    disk = {drawn(0.0, width), drawn(0.0, 0.02),
            drawn(smallest, *rc::gen::element(std::max(smallest, most), 0.5 * DIAMETER))};
  return disks;
}

template <typename Overlaps>
Overlaps searchOf(const std::vector<Placed>& disks, double width, bool periodic)
{
  Overlaps search(width, DIAMETER, periodic);
  search.begin(disks.size());
  for (std::uint32_t slot = 0; slot < disks.size(); ++slot)
    search.place(slot, disks[slot].s, disks[slot].n, disks[slot].radius);
  search.sort();
  return search;
}

/// Overlap of two disks, < 0: apart [m].
double overlapOf(const Placed& a, const Placed& b, double shift)
{
  return a.radius + b.radius - std::hypot(a.s - b.s - shift, a.n - b.n);
}

template <typename Overlaps>
void checkPairs()
{
  const double width = drawn(DIAMETER, 0.1);
  const bool periodic = *rc::gen::arbitrary<bool>();
  const std::vector<Placed> disks = someDisks(width);
  auto search = searchOf<Overlaps>(disks, width, periodic);
  std::multiset<Overlap> found;
  search.forEachPair([&](std::uint32_t slot, std::uint32_t other, int shift)
                     { found.insert(ordered(slot, other, shift)); });
  for (std::uint32_t i = 0; i < disks.size(); ++i)
    for (std::uint32_t j = i + 1; j < disks.size(); ++j)
      for (int shift = periodic ? -1 : 0; shift <= (periodic ? 1 : 0); ++shift)
      {
        const double overlap = overlapOf(disks[i], disks[j], shift * width);
        const auto times = found.count({i, j, shift});
        if (overlap > 0.0)
          RC_ASSERT(times == 1u);
        if (overlap < -1e-6)
          RC_ASSERT(times == 0u);
      }
}

template <typename Overlaps>
void checkAroundADiskThatWasMoved()
{
  const double width = drawn(3.5 * DIAMETER, 0.1);
  const bool periodic = *rc::gen::arbitrary<bool>();
  std::vector<Placed> disks = someDisks(width);
  RC_PRE(!disks.empty());
  auto search = searchOf<Overlaps>(disks, width, periodic);
  const auto moved = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(disks.size()));
  disks[moved].s = drawn(0.0, width);
  disks[moved].n = drawn(0.0, 0.02);
  search.move(moved, disks[moved].s, disks[moved].n);
  std::multiset<std::pair<std::uint32_t, int>> found;
  search.forEachAround(moved,
                       [&](std::uint32_t slot, std::uint32_t other, int shift)
                       {
                         RC_ASSERT(slot == moved);
                         found.insert({other, shift});
                       });
  for (std::uint32_t j = 0; j < disks.size(); ++j)
    for (int shift = periodic ? -1 : 0; shift <= (periodic ? 1 : 0); ++shift)
      if (j != moved && overlapOf(disks[moved], disks[j], shift * width) > 0.0)
        RC_ASSERT(found.count({j, shift}) == 1u);
}

template <typename Overlaps>
class OverlapsOf : public testing::Test
{
};
using Searches = testing::Types<OverlapSearch, OverlapLevels>;
TYPED_TEST_SUITE(OverlapsOf, Searches);

TYPED_TEST(OverlapsOf, AreEachPairThatOverlapsOnceAndNoneThatIsApart)
{
  EXPECT_TRUE(rc::check(checkPairs<TypeParam>));
}

TYPED_TEST(OverlapsOf, AreAllAroundADiskThatWasMoved)
{
  EXPECT_TRUE(rc::check(checkAroundADiskThatWasMoved<TypeParam>));
}

}  // namespace
}  // namespace ratchet_sieve
