#include "bag_output.h"

#include "ratchet_sieve/ros/bag_writer.h"

namespace ratchet_sieve
{

struct BagOutput::Implementation
{
  BagWriter writer;
};

BagOutput::BagOutput(const std::string& path) : implementation_(new Implementation{BagWriter(path)}) {}

BagOutput::~BagOutput() = default;

FrameSink& BagOutput::sink()
{
  return implementation_->writer;
}

void BagOutput::close()
{
  implementation_->writer.close();
}

}  // namespace ratchet_sieve
