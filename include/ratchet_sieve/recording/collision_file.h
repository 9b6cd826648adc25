#pragma once

#include <memory>
#include <string>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{

/// Every collision as a line of CSV: time,kind,i,j,normal_speed,normal_impulse,tangential_impulse;
/// j is empty for the base. Numbers read back bit for bit. The file appears at commit().
class CollisionFile
{
public:
  /// @throws OutputError
  explicit CollisionFile(const std::string& path);
  ~CollisionFile();

  /// To be handed to Simulation::observeCollisions().
  void take(const CollisionRecord& record);

  /// @throws OutputError if not all of it could be written
  void commit();

private:
  struct Buffer;
  void flush();

  AtomicFile file_;
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace ratchet_sieve
