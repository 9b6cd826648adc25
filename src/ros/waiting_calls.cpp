#include "ratchet_sieve/ros/waiting_calls.h"

#include <utility>

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <boost/make_shared.hpp>

namespace ratchet_sieve
{
namespace
{
/// Counts as waiting during its lifetime: if the caller disconnects, a call is destroyed without being
/// executed.
class CountedCall : public ros::CallbackInterface
{
public:
  CountedCall(ros::CallbackInterfacePtr call, std::shared_ptr<std::atomic<int>> count)
      : call_(std::move(call)), count_(std::move(count))
  {
    ++*count_;
  }
  ~CountedCall() override { --*count_; }
  CountedCall(const CountedCall&) = delete;
  CountedCall& operator=(const CountedCall&) = delete;

  CallResult call() override { return call_->call(); }
  bool ready() override { return call_->ready(); }

private:
  ros::CallbackInterfacePtr call_;
  std::shared_ptr<std::atomic<int>> count_;
};
}  // namespace

void WaitingCalls::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner_id)
{
  ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<CountedCall>(callback, count_), owner_id);
}

void WaitingCalls::removeByID(std::uint64_t owner_id)
{
  ros::getGlobalCallbackQueue()->removeByID(owner_id);
}

}  // namespace ratchet_sieve
