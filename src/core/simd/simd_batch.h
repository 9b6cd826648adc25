#pragma once

#include <cstddef>
#include <cstdint>

#include "model/motion.h"
#include "ratchet_sieve/core/luding_law.h"

/// SIMD for independent disks over a base at its setpoints: one disk per lane of the processor's registers.
/// The same source is compiled for each register width (batch_kernel.inc) and gives the same bits for each.
/// Plain arrays without functions: otherwise the linker could use a function compiled for wide registers on a
/// machine without them.
namespace ratchet_sieve
{

/// The feature of the next event of a lane's flight.
enum BatchFeature : std::int32_t
{
  BATCH_NOTHING = 0,  ///< no contact until then
  BATCH_RIGHT_SLOPE,  ///< the descending slope, on the left of a valley
  BATCH_LEFT_SLOPE,   ///< the ascending slope, on the right of a valley
  BATCH_APEX          ///< on the right of a valley
};

/// The face of a tooth, in coordinates of the valley with its foot at u = 0.
struct BatchFlank
{
  double apex_u;    ///< [m]
  double normal_s;  ///< unit normal, pointing out of the base
  double normal_n;
};

/// Constants in single precision for computing bounds, which need not be accurate.
struct BatchBounds
{
  float gravity;        ///< g
  float fall;           ///< acceleration of gravity towards the base: g cos(theta), or 0
  float amplitude;      ///< A
  float highest;        ///< A |cos(theta)|
  float speed;          ///< A w
  float third_of_jerk;  ///< A w^3 / 3
  float acceleration;   ///< g + A w^2
  float longest_trial;  ///< longest step with the present acceleration [s]
  float longest;        ///< the longest step [s]
};

/// Constants of all disks of a machine while its base is at its setpoints.
struct BatchScene
{
  double gravity;    ///< [m/s^2]
  double gravity_s;  ///< g sin(theta): acceleration of gravity against s
  double gravity_n;  ///< g cos(theta)
  Rotation base;     ///< by the inclination
  Drive drive;
  double resolution;       ///< time resolution [s]
  double longest_search;   ///< [s]
  double tooth_width;      ///< [m]
  double per_tooth_width;  ///< [1/m]
  double width;            ///< [m]
  double per_width;        ///< [1/m]
  double valley_start;     ///< fraction of a tooth on the left of a valley's foot: 1 - a
  double height;           ///< of the apices [m]
  CollisionLaw law;
  BatchBounds bounds;
  BatchFlank left;   ///< of the valley: the right slope of the tooth before
  BatchFlank right;  ///< of the valley: its tooth's left slope
};

/// Rows of disks, one disk per row.
struct SimdBatch
{
  static constexpr std::size_t ROWS = 128;

  /// Padded: with a stride of a power of two, the columns of a row would evict each other from the cache.
  using Column = double[ROWS + 8];

  alignas(64) Column x, y, vx, vy, spin, lost_x, lost_y;  ///< see Disk

  // Of the disk and its species.
  alignas(64) Column radius, restitution, friction;
  alignas(64) Column normal_mass;        ///< m_n [kg]
  alignas(64) Column sticking_mass;      ///< (1 + beta) m_t [kg]
  alignas(64) Column per_mass;           ///< [1/kg]
  alignas(64) Column radius_by_inertia;  ///< r / I

  // Running sums: see DiskRecord.
  alignas(64) Column translation, rotation, angle, impulse_x, impulse_y, offset;

  // The next event.
  alignas(64) Column event_time;  ///< [s]
  alignas(64) Column valley;      ///< whose foot is at s = valley w
  alignas(64) Column feature;     ///< a BatchFeature

  // The flight as of time 0, in the base's frame at Y = 0.
  alignas(64) Column s, n, vs, vn;

  // Outcome of the last contact; see ContactOutcome. Impulses and velocity are 0 if there was none.
  alignas(64) Column time;                ///< [s]
  alignas(64) Column overlap;             ///< [m]
  alignas(64) Column normal_x, normal_y;  ///< unit normal on the disk, world frame
  alignas(64) Column normal_velocity;     ///< v_n; 0 if the contact was separating [m/s]
  alignas(64) Column normal_impulse;      ///< [N s]
  alignas(64) Column tangential_impulse;  ///< [N s]
};

/// The functions for one register width.
struct BatchKernel
{
  int lanes;

  /// Executes the next events of the first `rows` disks, and sets their new flights.
  void (*collide)(const BatchScene& scene, SimdBatch& batch, std::size_t rows);

  /// Finds the next event of the first `rows` flights after `event_time`, and stores it there.
  void (*search)(const BatchScene& scene, SimdBatch& batch, std::size_t rows);
};

/// The available kernels, each compiled for its own register width, together with the physics.
extern const BatchKernel KERNEL_OF_TWO_LANES;
#if defined(__x86_64__)
extern const BatchKernel KERNEL_OF_FOUR_LANES;
extern const BatchKernel KERNEL_OF_EIGHT_LANES;
#endif

/// Largest number of 64-bit values per register: the environment variable RATCHET_SIEVE_LANES (2, 4 or 8),
/// or 8 if it is not set. For tests and bug reports: results do not depend on it.
/// @throws std::invalid_argument if the variable has another value
int laneLimit();

/// The kernel with the most lanes, up to a limit, that this processor can run. Results do not depend on it.
const BatchKernel& widestKernel(int most_lanes);

}  // namespace ratchet_sieve
