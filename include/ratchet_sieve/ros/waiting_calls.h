#pragma once

#include <atomic>
#include <memory>

#include <ros/callback_queue_interface.h>

namespace ratchet_sieve
{

/// Forwards callbacks to ROS's global queue and counts those that wait. So a long callback in the same thread
/// can end early when another call arrives. Outlives the services advertised through it.
class WaitingCalls : public ros::CallbackQueueInterface
{
public:
  /// Whether a callback waits or is being executed.
  bool any() const { return *count_ > 0; }

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner_id) override;
  void removeByID(std::uint64_t owner_id) override;

private:
  std::shared_ptr<std::atomic<int>> count_ = std::make_shared<std::atomic<int>>(0);
};

}  // namespace ratchet_sieve
