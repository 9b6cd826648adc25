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

/// Any outline: up to `most` corners in between, vertical faces, level faces and tiny ones.
inline std::vector<OutlineCorner> drawnProfile(double width, double relief, int most)
{
  std::vector<double> places;
  for (int count = *rc::gen::inRange(0, most + 1); count > 0; --count)
    places.push_back(*rc::gen::element(0.0, 0.25, 0.5, 0.500001, 1.0, drawn(0.0, 1.0), drawn(0.0, 1.0)) *
                     width);
  std::sort(places.begin(), places.end());
  std::vector<OutlineCorner> corners = {{0.0, 0.0}};
  bool vertical = false;
  for (const double s : places)
  {
    const double n = *rc::gen::element(-0.5, 0.0, 0.5, 1.0, drawn(-1.0, 1.0), drawn(-1.0, 1.0)) * relief;
    const bool again = s == corners.back().s;
    // A third corner at the same place could lead back,
    // and a face at each end would be a wall without thickness between two teeth.
    const bool both_ends = s == width && corners.size() > 1 && corners[1].s == 0.0;
    if ((again && (vertical || n == corners.back().n || s == width)) || (s == width && n == 0.0) || both_ends)
      continue;
    vertical = again;
    corners.push_back({s, n});
  }
  corners.push_back({width, 0.0});
  return corners;
}

}  // namespace ratchet_sieve::test
