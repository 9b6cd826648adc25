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
  throw std::runtime_error("--bag " + path + ": bags need ROS, and this build has none");
}

BagOutput::~BagOutput() = default;

FrameSink& BagOutput::sink()
{
  return implementation_->sink;
}

void BagOutput::close() {}

}  // namespace ratchet_sieve
