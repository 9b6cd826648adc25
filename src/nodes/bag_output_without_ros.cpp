#include <stdexcept>

#include "bag_output.h"

namespace ratchet_sieve
{

struct BagOutput::Implementation
{
  FrameSink& sink;
};

BagOutput::BagOutput(const std::string& path)
{
  throw std::runtime_error("--bag " + path + ": this build has no ROS, which bags need");
}

BagOutput::~BagOutput() = default;

FrameSink& BagOutput::sink()
{
  return implementation_->sink;
}

void BagOutput::close() {}

}  // namespace ratchet_sieve
