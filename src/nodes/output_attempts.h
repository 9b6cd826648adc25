#pragma once

#include <cstdio>
#include <exception>
#include <string>

namespace ratchet_sieve
{

/// Writes the outputs of a program one after the other. One that fails is reported on standard error, and the
/// others are written all the same.
class OutputAttempts
{
public:
  /// @param program its name in error lines
  explicit OutputAttempts(const char* program) : program_(program) {}

  template <typename Write>
  void attempt(const Write& write)
  {
    try
    {
      write();
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "%s: %s\n", program_, error.what());
      complete_ = false;
    }
  }

  /// Whether none has failed.
  bool complete() const { return complete_; }

private:
  const char* program_;
  bool complete_ = true;
};

}  // namespace ratchet_sieve
