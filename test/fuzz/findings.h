#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace ratchet_sieve
{

/// Aborts the fuzzer, which saves the input.
[[noreturn]] inline void finding(const char* what, const std::string& text)
{
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

/// An error message must be one printable line.
inline void requireOneLine(const std::string& error)
{
  if (error.empty())
    finding("an error that says nothing", error);
  for (const unsigned char c : error)
    if (c < ' ' || c == 0x7f)
      finding("an error of more than one line, or with a control character", error);
}

}  // namespace ratchet_sieve
