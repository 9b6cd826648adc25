#include "simd/batch_rows.h"

#include <algorithm>
#include <cmath>

#include "model/collision_law.h"
#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{
namespace
{
/// In radians of the drive: for shorter times, the present acceleration with the bound on its change is
/// tighter than the bound on the acceleration.
constexpr double LONGEST_TRIAL = 1.5;

struct BatchContact
{
  BatchFeature feature;
  std::int32_t valley;
};

// Of a sawtooth, whose faces are 0 and 1, with the apex at the left end of face 1.
BatchContact batchContact(const BaseFeature& feature)
{
  if (feature.kind() == BaseFeatureKind::FACE && feature.index() == 0)
    return {BATCH_LEFT_SLOPE, feature.tooth()};
  if (feature.kind() == BaseFeatureKind::FACE)
    return {BATCH_RIGHT_SLOPE, feature.tooth() + 1};
  return {feature ? BATCH_APEX : BATCH_NOTHING, feature.tooth()};
}

BaseFeature baseFeature(BatchFeature feature, std::int32_t valley)
{
  switch (feature)
  {
    case BATCH_LEFT_SLOPE:
      return {BaseFeatureKind::FACE, valley, 0};
    case BATCH_RIGHT_SLOPE:
      return {BaseFeatureKind::FACE, valley - 1, 1};
    case BATCH_APEX:
      return {BaseFeatureKind::CORNER, valley, 1};
    default:
      return {};
  }
}

/// @pre the shape is a sawtooth
void setTeeth(const BaseDefinition& base, const BaseShape& shape, BatchScene& scene)
{
  const BaseShape::Face& left_slope = shape.faces().front();
  const BaseShape::Face& right_slope = shape.faces().back();
  const double w = shape.toothWidth();
  const double a = base.outline()[1].s;
  scene.tooth_width = w;
  scene.per_tooth_width = 1.0 / w;
  scene.width = shape.width();
  scene.per_width = 1.0 / scene.width;
  scene.valley_start = (w - a) / w;
  scene.height = shape.height();
  scene.left = {a - w, right_slope.normal.x(), right_slope.normal.y()};
  scene.right = {a, left_slope.normal.x(), left_slope.normal.y()};
}
}  // namespace

std::optional<BatchScene> batchScene(const SystemState& system)
{
  const SceneDefinition& definition = system.scene();
  const BaseMotion& motion = system.motion();
  if (!system.plan().simd || motion.nextChange())
    return std::nullopt;
  BatchScene scene{};
  scene.gravity = definition.gravity;
  scene.base = motion.rotation();
  const auto gravity = verticalIntoBase(scene.base, definition.gravity);
  scene.gravity_s = gravity.first;
  scene.gravity_n = gravity.second;
  scene.drive = motion.drive();
  scene.longest_search = system.epoch().length;
  scene.resolution = timeResolution(system.epoch().length);
  scene.law = definition.contact;
  setTeeth(definition.base, system.shape(), scene);
  const double w = angularFrequency(scene.drive.frequency);
  BatchBounds& bounds = scene.bounds;
  bounds.gravity = static_cast<float>(scene.gravity);
  bounds.fall = static_cast<float>(std::max(0.0, scene.gravity_n));
  bounds.amplitude = static_cast<float>(scene.drive.amplitude);
  bounds.highest = static_cast<float>(scene.drive.amplitude * std::abs(scene.base.cosine));
  bounds.speed = static_cast<float>(scene.drive.speed);
  bounds.third_of_jerk = static_cast<float>(scene.drive.acceleration * w / 3.0);
  bounds.acceleration = static_cast<float>(definition.gravity + scene.drive.acceleration);
  bounds.longest = static_cast<float>(scene.longest_search);
  bounds.longest_trial = w > 0.0 ? static_cast<float>(LONGEST_TRIAL / w) : bounds.longest;
  return scene;
}

BaseEvent rowEvent(const SimdBatch& batch, std::size_t row)
{
  return {batch.event_time[row],
          baseFeature(static_cast<BatchFeature>(static_cast<std::int32_t>(batch.feature[row])),
                      static_cast<std::int32_t>(batch.valley[row]))};
}

void loadRow(const SystemState& system, std::uint32_t slot, const BaseEvent& next, SimdBatch& batch,
             std::size_t row)
{
  const Disk& disk = system.disk(slot);
  batch.x[row] = disk.position.x();
  batch.y[row] = disk.position.y();
  batch.vx[row] = disk.velocity.x();
  batch.vy[row] = disk.velocity.y();
  batch.spin[row] = disk.spin;
  batch.lost_x[row] = disk.lost[0];
  batch.lost_y[row] = disk.lost[1];
  const SpeciesDefinition& species = system.scene().species[disk.species];
  const DiskRecord& record = system.record(slot);
  const ContactMasses masses = contactMasses({record.properties.mass, leverOf(species)});
  batch.radius[row] = disk.radius;
  batch.restitution[row] = species.contact.restitution;
  batch.friction[row] = species.contact.friction;
  batch.normal_mass[row] = masses.normal;
  batch.sticking_mass[row] = (1.0 + species.contact.tangential_restitution) * masses.tangential;
  batch.per_mass[row] = 1.0 / record.properties.mass;
  batch.radius_by_inertia[row] = record.properties.spin_response;
  batch.offset[row] = record.offset;
  batch.translation[row] = record.translation;
  batch.rotation[row] = record.rotation;
  batch.angle[row] = record.angle;
  batch.impulse_x[row] = record.base_impulse.x();
  batch.impulse_y[row] = record.base_impulse.y();
  const BatchContact contact = batchContact(next.feature);
  batch.event_time[row] = next.time;
  batch.feature[row] = contact.feature;
  batch.valley[row] = contact.valley;
}

void readState(const SimdBatch& batch, std::size_t row, Disk& disk)
{
  disk.position.x() = batch.x[row];
  disk.position.y() = batch.y[row];
  disk.velocity.x() = batch.vx[row];
  disk.velocity.y() = batch.vy[row];
  disk.spin = batch.spin[row];
  disk.lost = {static_cast<float>(batch.lost_x[row]), static_cast<float>(batch.lost_y[row])};
}

void storeRow(const SimdBatch& batch, std::size_t row, SystemState& system, std::uint32_t slot,
              BaseEvent& next)
{
  readState(batch, row, system.changeable(slot));
  DiskRecord& record = system.record(slot);
  record.offset = batch.offset[row];
  record.translation = batch.translation[row];
  record.rotation = batch.rotation[row];
  record.angle = batch.angle[row];
  record.base_impulse = {batch.impulse_x[row], batch.impulse_y[row]};
  next = rowEvent(batch, row);
}

void copyRow(SimdBatch& batch, std::size_t from, std::size_t to)
{
  for (double* column : {batch.x,           batch.y,
                         batch.vx,          batch.vy,
                         batch.spin,        batch.lost_x,
                         batch.lost_y,      batch.radius,
                         batch.restitution, batch.friction,
                         batch.normal_mass, batch.sticking_mass,
                         batch.per_mass,    batch.radius_by_inertia,
                         batch.translation, batch.rotation,
                         batch.angle,       batch.impulse_x,
                         batch.impulse_y,   batch.offset,
                         batch.event_time,  batch.valley,
                         batch.feature})
    column[to] = column[from];
}

}  // namespace ratchet_sieve
