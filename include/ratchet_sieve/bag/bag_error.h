#pragma once

#include <stdexcept>

namespace ratchet_sieve
{

/// A bag that cannot be read or written: one line that names the file and what is wrong with it.
struct BagError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

}  // namespace ratchet_sieve
