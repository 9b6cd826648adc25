#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{

/// A CSV file with one line per collision of a run: time,kind,i,j,normal_speed,normal_impulse,
/// tangential_impulse; j is empty for the base. Numbers are read back bit for bit.
class CollisionFile : public AtomicFile
{
public:
  /// @throws OutputError
  explicit CollisionFile(const std::string& path);

  /// The observer for Simulation::observeCollisions().
  void add(const CollisionRecord& record);
};

/// A CSV file with one line per disk that leaves: time,id,species,radius,mass,side,place; the species by its
/// name. Numbers are read back bit for bit.
class ExitFile : public AtomicFile
{
public:
  /// @throws OutputError
  explicit ExitFile(const std::string& path);

  /// The observer for Simulation::observeExits(), of a run with these species.
  void add(const ExitRecord& record, const std::vector<SpeciesDefinition>& species);
};

}  // namespace ratchet_sieve
