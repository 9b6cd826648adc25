#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

const char* version()
{
  return RATCHET_SIEVE_VERSION;
}

}  // namespace ratchet_sieve
