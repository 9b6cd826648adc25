#pragma once

#include <rapidcheck.h>

namespace ratchet_sieve
{

/// In steps of a millionth of the range.
inline double drawn(double low, double high)
{
  return low + (high - low) * (*rc::gen::inRange(0, 1000001) * 1e-6);
}

}  // namespace ratchet_sieve
