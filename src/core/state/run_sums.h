#pragma once

#include "state/averages.h"
#include "state/contact_sums.h"
#include "state/energy_watch.h"

namespace ratchet_sieve
{

/// What every run adds up, besides the records of its disks.
struct RunSums
{
  ContactSums contacts;
  Averages averages;
  EnergyWatch energies;

  void archive(StateArchive& state) { state(contacts, averages, energies); }
};

}  // namespace ratchet_sieve
