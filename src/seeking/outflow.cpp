#include "ratchet_sieve/seeking/outflow.h"

namespace ratchet_sieve
{

void Outflow::add(const Outflow& more)
{
  species = more.species;
  duration += more.duration;
  bins.resize(more.bins.size());
  for (std::size_t k = 0; k < bins.size(); ++k)
  {
    bins[k].left += more.bins[k].left;
    bins[k].right += more.bins[k].right;
    bins[k].left_mass += more.bins[k].left_mass;
    bins[k].right_mass += more.bins[k].right_mass;
    bins[k].on_base = more.bins[k].on_base;
  }
}

}  // namespace ratchet_sieve
