#include "bag_plugin.h"

#include "ratchet_sieve/ros/bag_writer.h"

namespace ratchet_sieve
{
namespace
{

class Bag : public BagPlugin
{
public:
  explicit Bag(const char* path) : writer_(path) {}

  FrameSink& sink() override { return writer_; }
  void close() override { writer_.close(); }

private:
  BagWriter writer_;
};

}  // namespace
}  // namespace ratchet_sieve

extern "C" ratchet_sieve::OpenBagPlugin ratchetSieveOpenBag;

ratchet_sieve::BagPlugin* ratchetSieveOpenBag(const char* path)
{
  return new ratchet_sieve::Bag(path);
}
