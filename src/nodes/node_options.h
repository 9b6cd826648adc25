#pragma once

#include <cstdio>
#include <cstring>

#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

/// Answers --help and --version, before a node asks for a master that may not be there.
/// @return whether one of them was given
inline bool answerOptions(int argc, char** argv, const char* program, const char* help)
{
  for (int k = 1; k < argc; ++k)
  {
    if (std::strcmp(argv[k], "--help") == 0 || std::strcmp(argv[k], "-h") == 0)
    {
      std::fputs(help, stdout);
      return true;
    }
    if (std::strcmp(argv[k], "--version") == 0)
    {
      std::printf("%s %s\n", program, version());
      return true;
    }
  }
  return false;
}

}  // namespace ratchet_sieve
