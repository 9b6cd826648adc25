#pragma once

#include <string>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{

/// A CSV file with one line per collision: time,kind,i,j,normal_speed,normal_impulse,tangential_impulse; j is
/// empty for the base. Numbers are read back bit for bit. The file appears at commit().
class CollisionFile
{
public:
  /// @throws OutputError
  explicit CollisionFile(const std::string& path);

  /// The observer for Simulation::observeCollisions().
  void add(const CollisionRecord& record);

  /// @throws OutputError if the file could not be written completely
  void commit();

private:
  void flush();

  AtomicFile file_;
  std::string lines_;  ///< not yet written
};

}  // namespace ratchet_sieve
