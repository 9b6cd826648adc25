#include "model/processor.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ratchet_sieve
{
int laneLimit()
{
  constexpr const char* VARIABLE = "RATCHET_SIEVE_LANES";
  const char* text = std::getenv(VARIABLE);
  if (text == nullptr)
    return 8;
  for (const int lanes : {2, 4, 8})
    if (std::to_string(lanes) == text)
      return lanes;
  throw std::invalid_argument(std::string("environment variable ") + VARIABLE + " = " + text +
                              ": must be 2, 4 or 8");
}

}  // namespace ratchet_sieve
