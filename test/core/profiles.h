#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <rapidcheck.h>

#include "draws.h"
#include "ratchet_sieve/core/definition.h"

/// Outlines of teeth for tests.
namespace ratchet_sieve::test
{

/// A sawtooth as a profile.
inline std::vector<OutlineCorner> asProfile(const BaseDefinition& base)
{
  return {{0.0, 0.0}, {base.asymmetry * base.tooth_width, base.tooth_height}, {base.tooth_width, 0.0}};
}

/// Two apices of different height, plateaus at two heights, a groove, vertical faces up and down.
inline std::vector<OutlineCorner> castle()
{
  return {{0.0, 0.0},     {0.003, 0.006}, {0.005, 0.002}, {0.007, 0.002},  {0.007, 0.004}, {0.010, 0.004},
          {0.012, 0.008}, {0.012, 0.0},   {0.015, 0.0},   {0.017, -0.003}, {0.020, 0.0}};
}

/// A row of arcs: bumps, or grooves if the height is negative.
inline std::vector<OutlineCorner> arc(double width, double height, int faces)
{
  std::vector<OutlineCorner> corners;
  for (int i = 0; i <= faces; ++i)
  {
    const double share = static_cast<double>(i) / faces;
    corners.push_back({share * width, 4.0 * height * share * (1.0 - share)});
  }
  return corners;
}

/// Whether a corner can follow these: not at the same place, and not back along a vertical face.
inline bool canFollow(const std::vector<OutlineCorner>& corners, const OutlineCorner& next, double closest)
{
  const OutlineCorner& last = corners.back();
  if (std::hypot(next.s - last.s, next.n - last.n) <= closest)
    return false;
  if (corners.size() < 2 || next.s > last.s || last.s > corners[corners.size() - 2].s)
    return true;
  return (next.n > last.n) == (last.n > corners[corners.size() - 2].n);
}

/// Any outline: up to `most` corners in between, vertical faces, level faces and tiny ones; no two corners as
/// close as `closest` [m].
inline std::vector<OutlineCorner> drawnProfile(double width, double relief, int most, double closest = 0.0)
{
  std::vector<double> places;
  for (int count = *rc::gen::inRange(0, most + 1); count > 0; --count)
    places.push_back(*rc::gen::element(0.0, 0.25, 0.5, 0.500001, 1.0, drawn(0.0, 1.0), drawn(0.0, 1.0)) *
                     width);
  std::sort(places.begin(), places.end());
  const OutlineCorner end{width, 0.0};
  std::vector<OutlineCorner> corners = {{0.0, 0.0}};
  for (const double s : places)
  {
    const double n = *rc::gen::element(-0.5, 0.0, 0.5, 1.0, drawn(-1.0, 1.0), drawn(-1.0, 1.0)) * relief;
    if (!canFollow(corners, {s, n}, closest))
      continue;
    corners.push_back({s, n});
    // Two vertical faces where two teeth meet must not be a wall or a gap without thickness.
    const bool leads_back = s == width && corners[1].s == 0.0 && (corners[1].n > 0.0) == (n > 0.0);
    if (leads_back || !canFollow(corners, end, closest))
      corners.pop_back();
  }
  corners.push_back(end);
  return corners;
}

}  // namespace ratchet_sieve::test
