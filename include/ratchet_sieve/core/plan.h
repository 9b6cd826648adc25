#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// What of the model a run works out. What a scene does not need changes no result: it would only cost time.
struct Plan
{
  bool pairs = true;  ///< disks see each other: cells, a queue, pair search
  bool steps =
      false;          ///< by steps of time, for disks that see each other; contacts are missed: Method::STEPS
  bool spin = true;   ///< tangential impulses, and the rotation they leave
  bool drive = true;  ///< a phase and a sine wherever the base is evaluated, even where it stands still
  bool orbit = false;             ///< the drive has a horizontal part or harmonics
  bool contact_times = true;      ///< when each disk touched last, which t_c asks for
  bool search_above_band = true;  ///< step by step towards the base even from where it cannot reach

  /// Many disks at a time in the lanes of the processor's registers (lane_batch.h), while the base stands at
  /// its setpoints; for single disks without contact times on a periodic base that is driven up and down by a
  /// sine. Contacts are the same but for rounding.
  bool lanes = false;
};

/// The least that gives the scene's results. A setpoint that sets a standing base going while the plan has no
/// `drive`, or turns it, is followed all the same: BaseMotion notices in each of its segments.
Plan planOf(const SceneDefinition& scene);

/// All that can be modelled without another result, to measure and test planOf() against. Whether disks see
/// each other and how the base is driven is the scene's to say; lanes are as planOf() has them.
Plan fullPlan(const SceneDefinition& scene);

/// Whether `plan` gives the results of the scene: it has what the scene needs, and lanes only where they know
/// it.
bool covers(const Plan& plan, const SceneDefinition& scene);

/// One line for a human: what is modelled, and what is not and why.
std::string planText(const Plan& plan);

}  // namespace ratchet_sieve
