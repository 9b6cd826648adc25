#include "bag_output.h"
#include "ratchet_sieve/ros/bag.h"

extern "C" ratchet_sieve::OpenBagPlugin ratchetSieveOpenBag;

void ratchetSieveOpenBag(const std::string& path, ratchet_sieve::BagOutput& bag)
{
  const auto writer = std::make_shared<ratchet_sieve::BagWriter>(path);
  bag = {writer, [writer] { writer->close(); }};
}
