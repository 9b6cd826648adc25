#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <unistd.h>

namespace ratchet_sieve
{

/// Replaces this process by another program, found on PATH.
/// @param self name of this program in an error line @param words the program and its arguments
/// @return an exit status, if it cannot be run
inline int becomeProgram(const char* self, std::vector<std::string> words)
{
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  execvp(argv.front(), argv.data());
  std::fprintf(stderr, "%s: %s cannot be run: %s\n", self, argv.front(), std::strerror(errno));
  return 1;
}

}  // namespace ratchet_sieve
