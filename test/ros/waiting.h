#pragma once

#include <chrono>
#include <functional>

#include <ros/callback_queue.h>
#include <ros/ros.h>

namespace ratchet_sieve
{

/// Serves callbacks until `holds`. @return false after a timeout [s]
inline bool waitFor(const std::function<bool()>& holds, double patience = 30.0)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (!holds())
  {
    if (std::chrono::steady_clock::now() > end || !ros::ok())
      return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  }
  return true;
}

}  // namespace ratchet_sieve
