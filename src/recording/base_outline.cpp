#include "base_outline.h"

#include <Eigen/Geometry>

namespace ratchet_sieve
{

Eigen::Vector2d footOf(const DriveState& base)
{
  return {base.horizontal_displacement, base.displacement};
}

Eigen::Vector2d outOfBase(const DriveState& base, const Eigen::Vector2d& vector)
{
  return Eigen::Rotation2Dd(base.inclination) * vector;
}

std::vector<Eigen::Vector2d> baseOutline(const SceneDefinition& scene, const DriveState& base)
{
  const std::vector<OutlineCorner> tooth = scene.base.outline();
  std::vector<Eigen::Vector2d> corners;
  for (int k = 0; k < scene.base.teeth; ++k)
    for (std::size_t i = k > 0 ? 1 : 0; i < tooth.size(); ++i)  // a tooth begins where the last one ends
      corners.emplace_back(k * scene.base.toothWidth() + tooth[i].s, tooth[i].n);
  if (scene.boundary == Boundary::WALLED && scene.base.wall_height > 0.0)
  {
    corners.insert(corners.begin(), {corners.front().x(), scene.base.wall_height});
    corners.emplace_back(corners.back().x(), scene.base.wall_height);
  }
  for (Eigen::Vector2d& corner : corners)
    corner = footOf(base) + outOfBase(base, corner);
  return corners;
}

}  // namespace ratchet_sieve
