#include "ratchet_sieve/ros/recorder.h"

namespace ratchet_sieve
{
namespace
{
/// run.bag, 2 -> run_2.bag
std::string numbered(const std::string& path, int number)
{
  const std::size_t slash = path.rfind('/');
  const std::size_t dot = path.rfind('.');
  const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash + 1);
  const std::size_t stem = has_ending ? dot : path.size();
  return path.substr(0, stem) + "_" + std::to_string(number) + path.substr(stem);
}
}  // namespace

Recorder::Recorder(const std::string& path, const std::string& topic_prefix)
    : first_path_(path), topic_prefix_(topic_prefix)
{
}

void Recorder::open()
{
  if (first_path_.empty())
    return;
  close();
  ++opened_;
  const std::string path = opened_ == 1 ? first_path_ : numbered(first_path_, opened_);
  bag_ = std::make_unique<BagWriter>(path, topic_prefix_);
}

void Recorder::close()
{
  if (bag_)
    bag_->close();
  bag_.reset();
}

}  // namespace ratchet_sieve
