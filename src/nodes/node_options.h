#pragma once

#include <cstdio>
#include <cstring>

#include "process_start.h"
#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

/// Flushes standard output after each log line, also into a pipe or a file. To be called before any output.
inline void writeLogByLines()
{
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

/// Starts the process (startProcess()) and answers --help and --version. To be called before the node looks
/// for a master, which may be missing. @return whether one of them was given
inline bool answerOptions(int argc, char** argv, const char* program, const char* help)
{
  startProcess();
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
