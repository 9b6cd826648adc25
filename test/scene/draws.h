#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include <rapidcheck.h>

namespace ratchet_sieve
{

/// One of low, low + 1, ... high - 1, each as likely at any size of the case; shrinks to the low ones.
template <typename T>
T drawnIndex(T low, T high)
{
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(low, high));
}

/// True in so many of a hundred cases; shrinks to false.
inline bool drawnChance(int percent)
{
  return drawnIndex(0, 100) >= 100 - percent;
}

/// In [0, 1].
inline double drawnFraction()
{
  constexpr std::uint32_t STEPS = 1u << 30;
  return static_cast<double>(drawnIndex<std::uint32_t>(0, STEPS + 1)) / STEPS;
}

/// Between two positive bounds, every order of magnitude as likely as the others; now and then a bound
/// itself.
inline double drawnMagnitude(double low, double high)
{
  if (!(high > low))
    return low;
  if (drawnChance(10))
    return drawnChance(50) ? low : high;
  return std::clamp(low * std::pow(high / low, drawnFraction()), low, high);
}

/// Between two bounds of which the lower is 0 or less: an end, zero, or any magnitude of either sign.
inline double drawnSigned(double low, double high)
{
  /// How many times smaller than the bound the smallest are.
  constexpr double SPAN = 1e15;
  const int choice = drawnIndex(0, 10);
  if (choice == 0)
    return 0.0;
  if (choice == 1)
    return high;
  if (choice == 2)
    return low;
  if (choice < 6)
    return std::clamp(low + drawnFraction() * (high - low), low, high);
  if (low < 0.0 && drawnChance(50))
    return -drawnMagnitude(-low / SPAN, -low);
  return drawnMagnitude(high / SPAN, high);
}

/// Over the whole of a range, its ends often among them.
inline double drawnNumber(double low, double high)
{
  return low > 0.0 ? drawnMagnitude(low, high) : drawnSigned(low, high);
}

inline int drawnCount(int low, int high)
{
  return std::clamp(static_cast<int>(std::lround(drawnNumber(low, high))), low, high);
}

template <typename T>
T drawnOf(std::initializer_list<T> values)
{
  return *(values.begin() + drawnIndex<std::size_t>(0, values.size()));
}

}  // namespace ratchet_sieve
