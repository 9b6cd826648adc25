#pragma once

#include <stdexcept>

namespace ratchet_sieve
{

/// A bag that cannot be read or written. One line names the file and the error.
struct BagError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

}  // namespace ratchet_sieve
