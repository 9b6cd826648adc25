#pragma once

#include <stdexcept>
#include <string>

namespace ratchet_sieve
{

/// What an action that is refused says; "done" if it is not.
template <typename Error = std::runtime_error, typename Action>
std::string errorOf(const Action& action)
{
  try
  {
    action();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "done";
}

/// Whether a text begins so.
inline bool begins(const std::string& text, const std::string& start)
{
  return text.rfind(start, 0) == 0;
}

}  // namespace ratchet_sieve
