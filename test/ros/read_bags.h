#pragma once

#include <string>
#include <vector>

#include "collecting_sink.h"
#include "errors.h"
#include "ratchet_sieve/ros/bag.h"

namespace ratchet_sieve
{

/// All frames of bags that are one run.
inline CollectingSink readAll(const std::vector<std::string>& paths)
{
  CollectingSink read;
  readBags(paths, read);
  return read;
}

/// What is said of bags that are refused; "done" if they are not.
inline std::string readingError(const std::vector<std::string>& paths)
{
  return errorOf<BagError>([&] { readAll(paths); });
}

}  // namespace ratchet_sieve
