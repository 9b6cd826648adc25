#pragma once

#include <cstddef>
#include <cstdint>

#include "model/drive.h"
#include "model/rotation.h"
#include "ratchet_sieve/core/luding_law.h"

/// Single disks over a base that stands at its setpoints, many at a time: one disk to a lane of the
/// processor's registers. The same source is compiled for each width of register (lane_kernel.inc), and
/// gives the same bits in each. Plain arrays, without any function: what is built for a wide register must
/// not be taken by the linker for a machine that has none.
namespace ratchet_sieve
{

/// The feature that a lane's flight comes to.
enum LaneFeature : std::int32_t
{
  LANE_NOTHING = 0,  ///< free until then
  LANE_RIGHT_SLOPE,  ///< the descending one, on a valley's left
  LANE_LEFT_SLOPE,   ///< the ascending one, on a valley's right
  LANE_APEX          ///< on a valley's right
};

/// The face of a tooth, seen from the valley, whose foot is at u = 0.
struct LaneFlank
{
  double apex_u;    ///< [m]
  double normal_s;  ///< unit normal, out of the base
  double normal_n;
};

/// For bounds, which need not be fine: the same in single precision.
struct LaneBounds
{
  float gravity;        ///< g
  float fall;           ///< how gravity pulls towards the base: g cos(theta), or 0
  float amplitude;      ///< A
  float highest;        ///< A |cos(theta)|
  float speed;          ///< A w
  float third_of_jerk;  ///< A w^3 / 3
  float acceleration;   ///< g + A w^2
  float longest_trial;  ///< the longest step with the acceleration as it is now [s]
  float longest;        ///< the longest step [s]
};

/// What all disks of a machine share while its base stands at its setpoints.
struct LaneScene
{
  double gravity;    ///< [m/s^2]
  double gravity_s;  ///< g sin(theta): gravity pulls against s
  double gravity_n;  ///< g cos(theta)
  Rotation base;     ///< by the inclination
  Drive drive;
  double resolution;       ///< the finest step in time [s]
  double longest_search;   ///< [s]
  double tooth_width;      ///< [m]
  double per_tooth_width;  ///< [1/m]
  double width;            ///< [m]
  double per_width;        ///< [1/m]
  double valley_start;     ///< share of a tooth that lies left of a valley's foot: 1 - a
  double height;           ///< of the apices [m]
  CollisionLaw law;
  LaneBounds bounds;
  LaneFlank left;   ///< of the valley: the right slope of the tooth before
  LaneFlank right;  ///< of the valley: its tooth's left slope
};

/// Rows of disks, one to a lane.
struct LaneBatch
{
  static constexpr std::size_t ROWS = 128;

  /// Some longer than the rows: at powers of two apart, a row's numbers would drive each other out of the
  /// cache.
  using Column = double[ROWS + 8];

  alignas(64) Column x, y, vx, vy, spin, angle;
  alignas(64) Column time;  ///< of the state [s]

  // Of the species.
  alignas(64) Column radius, restitution, friction;
  alignas(64) Column normal_mass;        ///< m_n [kg]
  alignas(64) Column sticking_mass;      ///< (1 + beta) m_t [kg]
  alignas(64) Column per_mass;           ///< [1/kg]
  alignas(64) Column radius_by_inertia;  ///< r / I

  // Running sums: see Passages and BaseImpulses.
  alignas(64) Column translation, rotation, impulse_x, impulse_y, offset;

  // The next event.
  alignas(64) Column event_time;  ///< [s]
  alignas(64) Column valley;      ///< whose foot is at s = valley w
  alignas(64) Column feature;     ///< a LaneFeature

  // The flight, in the base's frame as it stands at Y = 0, at `time`.
  alignas(64) Column s, n, vs, vn;

  // What came of the last contact; see ContactOutcome. Impulses and velocity are 0 where none was made.
  alignas(64) Column overlap;             ///< [m]
  alignas(64) Column normal_x, normal_y;  ///< unit normal on the disk, in the world
  alignas(64) Column normal_velocity;     ///< v_n, 0 where the contact opened [m/s]
  alignas(64) Column normal_impulse;      ///< [N s]
  alignas(64) Column tangential_impulse;  ///< [N s]
};

/// The code for one width of register.
struct LaneKernel
{
  int lanes;

  /// Executes the events that the first `rows` disks have next, and sets their new flights.
  void (*collide)(const LaneScene& scene, LaneBatch& batch, std::size_t rows);

  /// Finds the next event of the first `rows` flights from `event_time` on, and puts it there.
  /// @return how many points of flights were evaluated
  std::uint64_t (*search)(const LaneScene& scene, LaneBatch& batch, std::size_t rows);

  /// For flights that were not set by `collide`: from the disks' states.
  void (*launch)(const LaneScene& scene, LaneBatch& batch, std::size_t rows);
};

/// The kernel with as many lanes (1, 2, 4, 8), or nullptr where this processor cannot run it.
const LaneKernel* laneKernel(int lanes);

/// The widest kernel that this processor runs, or that useLanes() asked for.
const LaneKernel& presentLaneKernel();

/// Has all simulations from now on use so many lanes; 0: the widest. For tests and benchmarks: results do not
/// depend on it. @return false, with nothing changed, where this processor cannot
bool useLanes(int lanes);

}  // namespace ratchet_sieve
