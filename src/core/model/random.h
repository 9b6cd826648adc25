#pragma once

#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Random numbers that are the same with every compiler and library: the standard specifies mt19937_64 bit by
/// bit, but not its distributions.
class Random
{
public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// In [0, 1), 53 bits.
  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1.0p-53; }

  /// Exponentially distributed with mean 1, by comparisons of uniform numbers alone, since the C library's
  /// logarithm differs between machines. J. von Neumann, Natl. Bur. Stand. Appl. Math. Ser. 12, 36 (1951).
  double exponential()
  {
    for (double whole = 0.0;; ++whole)
    {
      const double first = uniform();
      double last = first;
      bool odd = true;
      for (double next = uniform(); next < last; next = uniform())
      {
        last = next;
        odd = !odd;
      }
      if (odd)
        return whole + first;
    }
  }

  /// In [0, count), count > 0; biased by less than count / 2^64.
  std::uint64_t below(std::uint64_t count) { return generator_() % count; }

  void archive(StateArchive& state)
  {
    // The standard specifies this text, as it does the bits.
    std::ostringstream out;
    out << generator_;
    std::string text = out.str();
    state(text);
    if (!state.restoring())
      return;
    std::istringstream in(text);
    if (!(in >> generator_))
      throw StateError("the state of its random numbers is invalid");
  }

private:
  std::mt19937_64 generator_;
};

}  // namespace ratchet_sieve
