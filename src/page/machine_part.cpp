#include "machine_part.h"

#include <utility>

#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/scene/scalars.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

Json drivePart(const BaseDefinition& base)
{
  Json harmonics = Json::array();
  for (const HarmonicDefinition& harmonic : base.harmonics)
    harmonics.push_back({{"multiple", harmonic.multiple},
                         {"amplitude", harmonic.amplitude},
                         {"phase", harmonic.phase},
                         {"horizontal_amplitude", harmonic.horizontal_amplitude},
                         {"horizontal_phase", harmonic.horizontal_phase}});
  return {{"turns_with_base", base.drive_frame == DriveFrame::BASE},
          {"amplitude", base.amplitude},
          {"horizontal_amplitude", base.horizontal_amplitude},
          {"horizontal_phase", base.horizontal_phase},
          {"harmonics", std::move(harmonics)}};
}

}  // namespace

nlohmann::ordered_json machinePart(const SceneDefinition& scene)
{
  Json tooth = Json::array();
  for (const OutlineCorner& corner : scene.base.outline())
    tooth.push_back({corner.s, corner.n});
  Json species = Json::array();
  for (const SpeciesDefinition& each : scene.species)
    species.push_back({{"name", each.name}, {"radius", each.radius}});
  return {{"tooth", std::move(tooth)},
          {"teeth", scene.base.teeth},
          {"boundary", scalarText(scene.boundary)},
          {"wall_height", scene.boundary == Boundary::WALLED ? Json(wallHeight(scene)) : Json(nullptr)},
          {"gravity", scene.gravity},
          {"duration", scene.duration},
          {"drive", drivePart(scene.base)},
          {"species", std::move(species)}};
}

}  // namespace ratchet_sieve
