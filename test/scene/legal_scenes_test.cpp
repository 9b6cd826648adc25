// Scenes at random, legal by their making: each loads, reads back, runs, and keeps its invariants.
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "draws.h"
#include "model/orbit.h"
#include "random_scene.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// A run that is watched: what must hold after each stride.
class WatchedRun
{
public:
  explicit WatchedRun(const SceneDefinition& scene) : scene_(scene), simulation_(scene)
  {
    poured_ = scene.initial.size();
    for (const SpeciesDefinition& species : scene.species)
      poured_ += static_cast<std::size_t>(species.count);
    simulation_.observeCollisions([this](const CollisionRecord& record) { take(record); });
    energy_ = simulation_.energy();
    active_ = simulation_.activeDisks();
    check();
  }

  void advanceTo(double time)
  {
    simulation_.advanceTo(time);
    check();
  }

  /// Commands the machine something within `duration` [s], at the speeds that it has, or pours. No disk
  /// jumps.
  void commandSomething(double duration)
  {
    const BaseDefinition& base = scene_.base;
    commanded_ = true;
    // Between steps, disks are observed without the contacts since the last step; a command ends the step.
    simulation_.command(Quantity::FREQUENCY, simulation_.base().frequency);
    const double turn_rate = std::min(1.0 / duration, fastest_ / (base.width() + farthest_));
    simulation_.setSlewRates({std::clamp(turn_rate, 1.5e-9, 15.0),
                              std::clamp(base.frequency / duration, 1e-5, 1e5),
                              std::clamp(base.amplitude / duration, 1e-9, 10.0)});
    const std::vector<DiskState> before = simulation_.disks();
    const std::size_t poured_before = poured_;
    switch (drawnIndex(0, 4))
    {
      case 0:
        simulation_.command(Quantity::INCLINATION, drawnOf({0.0, 0.15, -0.3}));
        break;
      case 1:
        simulation_.command(Quantity::FREQUENCY, drawnOf({0.0, 0.4, 1.0}) * base.frequency);
        break;
      case 2:
        simulation_.command(Quantity::AMPLITUDE, drawnOf({0.0, 0.5, 1.0}) * base.amplitude);
        break;
      default:
        simulation_.pour(0, 3);
        poured_ += 3;
    }
    const std::vector<DiskState> after = simulation_.disks();
    const double speed_rounding = poured_ == poured_before ? speedRounding() : 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
      checkSamePlace(before[i], after.at(i), speed_rounding);
  }

  std::uint64_t collisions() const { return collisions_; }
  int energyChecks() const { return energy_checks_; }

private:
  static constexpr double ROUNDING = 8.0 * std::numeric_limits<double>::epsilon();

  /// How finely a double tells places from each other, and where a disk is at instants that it tells from
  /// each other: neither is finer than this [m].
  double rounding() const { return ROUNDING * (farthest_ + fastest_ * epoch()); }

  /// A command that makes the drive faster may shorten the epoch. Then flights are counted from another zero,
  /// with a speed there that is rounded anew [m/s]. A pour changes no bit of it.
  double speedRounding() const { return ROUNDING * (fastest_ + scene_.gravity * epoch()); }

  /// At least [s].
  double epoch() const
  {
    constexpr double SCALES_PER_EPOCH = 128.0;
    return SCALES_PER_EPOCH * timeScale(scene_);
  }

  /// Images are treated as equal.
  void checkSamePlace(const DiskState& a, const DiskState& b, double speed_rounding) const
  {
    Eigen::Vector2d way(a.x - b.x, a.y - b.y);
    const double theta = simulation_.base().inclination;
    const Eigen::Vector2d lattice = scene_.base.width() * Eigen::Vector2d(std::cos(theta), std::sin(theta));
    if (scene_.boundary == Boundary::PERIODIC)
      way -= std::round(way.dot(lattice) / lattice.squaredNorm()) * lattice;
    RC_ASSERT(way.norm() <= rounding());
    RC_ASSERT(std::abs(a.displacement - b.displacement) <= rounding());
    RC_ASSERT(a.id == b.id && std::hypot(a.vx - b.vx, a.vy - b.vy) <= speed_rounding);
  }

  void take(const CollisionRecord& record)
  {
    RC_ASSERT(record.time >= last_collision_);
    RC_ASSERT(record.normal_speed > 0.0);
    RC_ASSERT(record.normal_impulse > 0.0);
    last_collision_ = record.time;
    ++collisions_;
    fastest_ = std::max(fastest_, record.normal_speed);
  }

  void check()
  {
    const std::size_t behind = simulation_.auditOverlaps();
    checkDisks();
    // By steps, disks may overlap until the end of a step.
    const bool exact = !simulation_.plan().steps;
    RC_ASSERT(!exact || behind == 0u);
    RC_ASSERT(!exact || simulation_.maxOverlap() <= 1e-9 * smallestRadius(scene_) + rounding());
    checkCounts();
    checkEnergy();
    checkMeans();
  }

  void checkDisks()
  {
    const DriveBounds drive = driveBounds(scene_.base);
    farthest_ = std::max(farthest_, scene_.base.width() + drive.displacement +
                                        std::max(scene_.base.highest(), scene_.base.depth()));
    for (const DiskState& disk : simulation_.disks())
    {
      for (const double value : {disk.x, disk.y, disk.vx, disk.vy, disk.angle, disk.spin, disk.displacement})
        RC_ASSERT(std::isfinite(value));
      farthest_ = std::max({farthest_, std::abs(disk.x), std::abs(disk.y), std::abs(disk.displacement)});
      fastest_ = std::max({fastest_, std::hypot(disk.vx, disk.vy), drive.speed});
    }
  }

  void checkCounts()
  {
    std::uint64_t there = 0;
    std::uint64_t on_base = 0;
    for (const SpeciesBins& bins : simulation_.bins())
    {
      on_base += bins.on_base;
      there += bins.on_base + bins.left + bins.right;
    }
    RC_ASSERT(on_base == simulation_.activeDisks());
    // The number of a Poisson process is within 8 of its standard deviations and a few, however often it is
    // drawn.
    const double fed = scene_.feed.rate * simulation_.time();
    const double scatter = scene_.feed.even ? 0.001 : 8.0 * std::sqrt(fed) + 12.0;
    RC_ASSERT(static_cast<double>(there) >= static_cast<double>(poured_) + fed - 1.0 - scatter);
    RC_ASSERT(static_cast<double>(there) <= static_cast<double>(poured_) + fed + scatter);
    RC_ASSERT(scene_.boundary != Boundary::PERIODIC || on_base == there);
    const CollisionCounts& counts = simulation_.collisions();
    RC_ASSERT(counts.disk_disk + counts.left_slope + counts.right_slope + counts.apex + counts.wall +
                  counts.level ==
              collisions_);
    if (!scene_.base.profile.empty())
    {
      const FaceContacts& parts = simulation_.faceContacts();
      const auto sum = [](const auto& list) { return std::accumulate(list.begin(), list.end(), 0ull); };
      RC_ASSERT(sum(parts.face_contacts) == counts.left_slope + counts.right_slope + counts.level);
      RC_ASSERT(sum(parts.corner_contacts) == counts.apex);
    }
    RC_ASSERT(simulation_.observed().size() == scene_.observe.size());
    RC_ASSERT(last_collision_ <= simulation_.time());
  }

  /// A base at rest gives no energy, and no contact makes any: unless a rebound has a floor, also that of a
  /// collapse, disks come or go or are pushed out of the base, or a wrap takes a disk to another height.
  void checkEnergy()
  {
    const double before = energy_;
    energy_ = simulation_.energy();
    RC_ASSERT(std::isfinite(energy_));
    const bool same_disks = active_ == simulation_.activeDisks() && scene_.feed.rate == 0.0;
    active_ = simulation_.activeDisks();
    const bool at_rest = driveBounds(scene_.base).speed == 0.0;
    const bool level =
        scene_.boundary != Boundary::PERIODIC || scene_.gravity * scene_.base.inclination == 0.0;
    const bool floor = scene_.contact.min_rebound_speed > 0.0 || simulation_.collapses().count > 0 ||
                       simulation_.pushedOut() > 0;
    if (!same_disks || !at_rest || !level || floor || commanded_)
      return;
    ++energy_checks_;
    double terms = 0.0;
    for (const DiskState& disk : simulation_.disks())
    {
      const double mass = scene_.species[disk.species].massOf(disk.radius);
      terms += std::abs(before) + mass * scene_.gravity * farthest_ + mass * fastest_ * fastest_;
    }
    RC_ASSERT(energy_ <= before + 1e-12 * terms);
  }

  /// A mean velocity is the way its disks went, by the time: seen where all were counted from the start.
  void checkMeans()
  {
    const std::vector<SpeciesMeans> means = simulation_.means();
    for (std::size_t s = 0; s < means.size(); ++s)
    {
      if (means[s].mean_vx)
        RC_ASSERT(std::isfinite(*means[s].mean_vx));
      if (means[s].mean_vx_stderr)
        RC_ASSERT(std::isfinite(*means[s].mean_vx_stderr));
      if (means[s].kinetic_translational)
        RC_ASSERT(std::isfinite(*means[s].kinetic_translational) &&
                  std::isfinite(*means[s].kinetic_rotational));
      const SpeciesBins bins = simulation_.bins()[s];
      if (!means[s].mean_vx || scene_.settle > 0.0 || scene_.feed.rate > 0.0 || bins.left + bins.right > 0 ||
          commanded_)
        continue;
      double way = 0.0;
      for (const DiskState& disk : simulation_.disks())
        if (disk.species == s)
          way += disk.displacement;
      const double disks = static_cast<double>(bins.on_base);
      const double tolerance = 1e-12 * disks * (farthest_ + fastest_ * simulation_.time());
      RC_ASSERT(std::abs(*means[s].mean_vx * simulation_.time() * disks - way) <= tolerance);
    }
  }

  SceneDefinition scene_;
  std::size_t poured_ = 0;
  double last_collision_ = 0.0;
  double farthest_ = 0.0;  ///< from the origin, any disk so far, or the end of the base [m]
  double fastest_ = 0.0;   ///< any disk so far, at a stride's end or along a normal [m/s]
  double energy_ = 0.0;
  std::size_t active_ = 0;
  bool commanded_ = false;
  std::uint64_t collisions_ = 0;
  int energy_checks_ = 0;
  Simulation simulation_;
};

/// rc::check over `times` as many cases as rapidcheck is told to make (100, if it is told nothing).
template <typename Testable>
bool checkManyTimes(double times, const std::string& description, Testable&& testable)
{
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = std::max(1, static_cast<int>(params.maxSuccess * times));
  rc::detail::TestMetadata metadata;
  metadata.id = description;
  metadata.description = description;
  const auto result = rc::detail::checkTestable(std::forward<Testable>(testable), metadata, params);
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << std::endl;
  return result.template is<rc::detail::SuccessResult>();
}

TEST(LegalScenes, KeepTheirInvariantsAsTheyRun)
{
  int runs = 0;
  int stalls = 0;
  int with_collisions = 0;
  int with_energy = 0;
  EXPECT_TRUE(checkManyTimes(20, "runnable scenes",
                             [&]
                             {
                               ++runs;
                               const SceneDefinition random = *rc::gen::exec(drawnRunnableScene);
                               const std::string text = canonicalYaml(random);
                               RC_LOG() << text;
                               const Scene scene = sceneFromText(text, "legal.yaml");
                               RC_ASSERT(canonicalYaml(scene.definition) == text);
                               RC_ASSERT(scene.warnings == implausibilities(random));
                               try
                               {
                                 WatchedRun run(scene.definition);
                                 for (int k = 1; k <= 8; ++k)
                                   run.advanceTo(scene.definition.duration * k / 8.0);
                                 with_collisions += run.collisions() > 0 ? 1 : 0;
                                 with_energy += run.energyChecks() > 0 ? 1 : 0;
                                 const double stride = scene.definition.duration / 8.0;
                                 for (int k = 9; stride > 0.0 && k <= 12; ++k)
                                 {
                                   run.commandSomething(stride);
                                   run.advanceTo(stride * k);
                                 }
                               }
                               catch (const StallError&)
                               {
                                 ++stalls;
                               }
                             }));
  EXPECT_LE(stalls, 3 + runs / 50) << "of " << runs << " runs";
  // Of three thousand, 56 and 10 of a hundred did, with any seed.
  EXPECT_GE(with_collisions, runs * 45 / 100 - 3) << "of " << runs << " runs";
  EXPECT_GE(with_energy, runs * 6 / 100 - 3) << "of " << runs << " runs";
}

}  // namespace
}  // namespace ratchet_sieve
