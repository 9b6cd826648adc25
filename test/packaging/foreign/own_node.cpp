// Speaks this package's messages and uses its ROS layer.
#include <ratchet_sieve/BinCounts.h>
#include <ratchet_sieve/live/pacer.h>
#include <iostream>

int main()
{
  ratchet_sieve::BinCounts counts;
  counts.left.push_back(1);
  std::cout << counts << '\n';
}
