#pragma once

namespace ratchet_sieve
{

/// The sums of one disk that grow with every flight and contact. SIMD batches take them along in columns, and
/// the observers that they belong to load and store them (Observers::rowSums()).
struct RowSums
{
  double offset;       ///< see Trajectory
  double translation;  ///< see Trajectory
  double rotation;     ///< see Trajectory
  double angle;        ///< see Trajectory
  double impulse_x;    ///< see BaseImpulses
  double impulse_y;    ///< see BaseImpulses
};

}  // namespace ratchet_sieve
