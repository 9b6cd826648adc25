#include <cmath>
#include <cstddef>

#include "ratchet_sieve/scene/entry.h"
#include "ratchet_sieve/scene/scalars.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{
OutlineCorner readCorner(const Entry& entry, const Range& range)
{
  const std::vector<Entry> numbers = entry.list();
  if (numbers.size() != 2)
    entry.refuse("must be two numbers, [s, n]");
  OutlineCorner corner;
  readScalar(numbers[0], range, corner.s);
  readScalar(numbers[1], range, corner.n);
  return corner;
}

/// Refuses the last corner of an outline if the one before does not lead to it.
void requireStep(const Entry& entry, const Range& range, const std::vector<OutlineCorner>& corners)
{
  const OutlineCorner& here = corners.back();
  const OutlineCorner& before = corners[corners.size() - 2];
  if (here.s < before.s)
    entry.refuse("s = " + scalarText(here.s) + " m is before the corner before, s = " + scalarText(before.s) +
                 " m: corners go from left to right, and a tooth must have no overhang");
  if (std::hypot(here.s - before.s, here.n - before.n) < SMALLEST_LENGTH)
    entry.refuse("must be at least " + scalarText(SMALLEST_LENGTH) + ' ' + range.unit +
                 " from the corner before");
  if (corners.size() > 2 && corners[corners.size() - 3].s == here.s &&
      (here.n > before.n) != (before.n > corners[corners.size() - 3].n))
    entry.refuse("leads back along a vertical face: a tooth must have no wall or gap without thickness");
}

void requireBegin(const Entry& entry, const OutlineCorner& corner)
{
  if (corner.s != 0.0 || corner.n != 0.0)
    entry.refuse("must be [0, 0]: a tooth begins there, at its left end");
}

void requireEnd(const std::vector<Entry>& entries, const std::vector<OutlineCorner>& corners)
{
  if (corners.back().n != 0.0)
    entries.back().refuse("n = " + scalarText(corners.back().n) +
                          " m must be 0: a tooth ends as high as it begins");
  const std::size_t last = corners.size() - 1;
  if (corners[1].s == 0.0 && corners[last - 1].s == corners[last].s &&
      (corners[1].n > 0.0) == (corners[last - 1].n > 0.0))
    entries.back().refuse(
        "leads back along the next tooth's first face: there must be no wall or gap without "
        "thickness");
  if (corners.back().s < SMALLEST_LENGTH)
    entries.back().refuse("s = " + scalarText(corners.back().s) +
                          " m, the width of a tooth, must be at least " + scalarText(SMALLEST_LENGTH) + " m");
}
}  // namespace

void readScalar(const Entry& entry, const Range& range, std::vector<OutlineCorner>& value)
{
  const std::vector<Entry> entries = entry.list();
  if (entries.size() < 2 || entries.size() > MOST_CORNERS)
    entry.refuseValue("must be a list of " + legalValues<std::vector<OutlineCorner>>(range).values + ' ' +
                      range.unit);
  std::vector<OutlineCorner> corners;
  for (const Entry& corner : entries)
  {
    corners.push_back(readCorner(corner, range));
    if (corners.size() == 1)
      requireBegin(corner, corners.front());
    else
      requireStep(corner, range, corners);
  }
  requireEnd(entries, corners);
  value = corners;
}

std::string scalarText(const OutlineCorner& value)
{
  return '[' + scalarText(value.s) + ", " + scalarText(value.n) + ']';
}

}  // namespace ratchet_sieve
