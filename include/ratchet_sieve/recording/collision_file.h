#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{

/// A CSV file with one line per event of a run. Numbers are read back bit for bit. The file appears at
/// commit().
class EventFile
{
public:
  /// @throws OutputError if the file could not be written completely
  void commit();

protected:
  /// @throws OutputError
  EventFile(const std::string& path, const std::string& header);

  template <typename... Values>
  void addLine(const char* format, const Values&... values);

private:
  void flush();

  AtomicFile file_;
  std::string lines_;  ///< not yet written
};

/// time,kind,i,j,normal_speed,normal_impulse,tangential_impulse; j is empty for the base.
class CollisionFile : public EventFile
{
public:
  /// @throws OutputError
  explicit CollisionFile(const std::string& path);

  /// The observer for Simulation::observeCollisions().
  void add(const CollisionRecord& record);
};

/// time,id,species,radius,mass,side,place; the species by its name.
class ExitFile : public EventFile
{
public:
  /// @throws OutputError
  explicit ExitFile(const std::string& path);

  /// The observer for Simulation::observeExits(), of a run with these species.
  void add(const ExitRecord& record, const std::vector<SpeciesDefinition>& species);
};

}  // namespace ratchet_sieve
