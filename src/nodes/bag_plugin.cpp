#include "bag_output.h"
#include "ratchet_sieve/ros/bag.h"

namespace
{

class Bag : public ratchet_sieve::BagOutput
{
public:
  explicit Bag(const char* path) : writer_(path) {}

  void take(const ratchet_sieve::AnyFrame& frame) override { writer_.take(frame); }
  void close() override { writer_.close(); }

private:
  ratchet_sieve::BagWriter writer_;
};

}  // namespace

extern "C" ratchet_sieve::OpenBagPlugin ratchetSieveOpenBag;

ratchet_sieve::BagOutput* ratchetSieveOpenBag(const char* path)
{
  return new Bag(path);
}
