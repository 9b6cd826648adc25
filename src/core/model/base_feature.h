#pragma once

#include <cstdint>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The parts of the base that a disk can touch or pass.
enum class BaseFeatureKind : std::int32_t
{
  NONE,
  FACE,        ///< of a tooth
  CORNER,      ///< of a tooth, convex
  END_CORNER,  ///< the top of a wall, or the foot at a free end of the base
  LEFT_WALL,
  RIGHT_WALL,
  LEFT_END,  ///< not a surface: the line s = 0 of an open base or above a wall, behind which the bin is; for
             ///< a periodic base the seam, see BaseShape::seamSlack()
  RIGHT_END  ///< the line s = W
};

/// A part of the base that a disk can touch, or none. Kind and index are in one number of the same width as
/// `tooth`, because both are loaded together, and stores of unequal width would cause a store-forwarding
/// stall.
class BaseFeature
{
public:
  constexpr BaseFeature() = default;

  /// @param tooth of a face or a corner; for END_CORNER 0 or the number of teeth
  /// @param index of the face, or of the corner at its left end, in the outline of a tooth
  constexpr BaseFeature(BaseFeatureKind kind, std::int32_t tooth, std::int32_t index = 0)
      : part_(static_cast<std::int32_t>(kind) | index * (1 << KIND_BITS)), tooth_(tooth)
  {
  }

  constexpr BaseFeatureKind kind() const { return static_cast<BaseFeatureKind>(part_ & KIND_MASK); }
  constexpr std::int32_t index() const { return part_ >> KIND_BITS; }
  constexpr std::int32_t tooth() const { return tooth_; }

  explicit operator bool() const { return part_ != 0; }
  bool isEnd() const { return kind() >= BaseFeatureKind::LEFT_END; }

  void archive(StateArchive& state) { state(part_, tooth_); }

private:
  static constexpr int KIND_BITS = 3;
  static constexpr std::int32_t KIND_MASK = (1 << KIND_BITS) - 1;

  std::int32_t part_ = 0;
  std::int32_t tooth_ = 0;
};

}  // namespace ratchet_sieve
