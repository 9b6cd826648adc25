#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "model/random.h"
#include "ratchet_sieve/core/definition.h"
#include "search/room_search.h"
#include "search/standing_disks.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Finds positions for new disks: each at a random place on a stretch of the base, as low as the drop height
/// and the existing disks allow.
class Pour
{
public:
  /// @param base with its present amplitude, which determines its highest position
  /// @param stretch where the disks' centres may be
  /// @param see_each_other false if disks do not collide: they may then overlap
  Pour(const BaseDefinition& base, Boundary boundary, const Stretch& stretch, double drop_height,
       double largest_diameter, bool see_each_other);

  /// Adds an existing disk.
  void occupy(const PlacedDisk& disk)
  {
    if (see_each_other_)
      standing_.add(disk);
  }

  /// Places one more disk, and adds it.
  PlacedDisk place(double radius, Random& random);

private:
  RoomSearch& searchFor(double radius);

  Stretch stretch_;
  double width_;
  double lowest_underside_;
  bool periodic_;
  bool see_each_other_;
  /// For what finds room: many small pieces, given back as a few large ones. Freed one by one they would stay
  /// with the heap, which has no use for them while a run goes on.
  std::pmr::monotonic_buffer_resource blocks_;
  std::pmr::unsynchronized_pool_resource memory_{&blocks_};
  StandingDisks standing_;
  std::vector<RoomSearch> searches_;  ///< one per radius, or class of radii
};

/// The order in which a scene's disks are poured: `count` of each species, shuffled.
std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random);

/// A random species, with probabilities proportional to the shares. @pre at least one share is positive
std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random);

/// Pours disks onto a stretch of the base at `time` (local to the epoch), one of each species in the list,
/// beside and above the existing disks.
/// @param observer see Simulation
/// @param own radius and mass of these disks; null: of the sizes of their species
void pourDisks(SystemState& system, const std::vector<std::uint32_t>& species, const Stretch& stretch,
               double time, Random& random, const PourObserver& observer = {}, const FedDisk* own = nullptr);

/// Adds the disks of the scene's `initial` to an empty machine.
/// @throws std::invalid_argument if they overlap each other or the base, or are outside; the message names
/// them
void placeInitialDisks(SystemState& system, double time);

/// The result of a check of all disks at one time.
struct Audit
{
  double largest_overlap = 0.0;    ///< between two disks, or a disk and the base [m]
  std::size_t behind_surface = 0;  ///< disks with their centre below the base's surface: must be 0
};

/// Measures the distances of every disk to the base and to its neighbours, independently of the engine's
/// predictions. @param time local to the epoch
Audit audit(const SystemState& system, double time);

}  // namespace ratchet_sieve
