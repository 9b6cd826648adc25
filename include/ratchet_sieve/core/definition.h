#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/luding_law.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Most disks that a scene may have, and that may be in a machine after a later pour.
constexpr int MOST_DISKS = 10'000'000;

/// What happens at the two ends of the base.
enum class Boundary
{
  PERIODIC,  ///< What leaves one end enters at the other; displacements are counted unwrapped.
  OPEN,      ///< A disk whose centre passes an end falls into that end's bin and leaves the machine.
  WALLED  ///< Two smooth walls stand at the ends, normal to the base, and move with it. A disk that crosses
          ///< the top of a wall has left the machine and is counted in the bin behind that wall.
};

/// The axes along which the drive moves the base.
enum class DriveFrame
{
  WORLD,  ///< horizontal and vertical, whatever the inclination, as in the paper
  BASE    ///< along the base and normal to it, as a vibrator bolted to the deck does; they turn with the base
};

/// A sine of a multiple k of the drive's phase: (A_x,k sin(k phi + phi_x,k), A_k sin(k phi + phi_k)).
struct HarmonicDefinition
{
  int multiple = 2;                   ///< k
  double amplitude = 0.0;             ///< A_k [m]
  double phase = 0.0;                 ///< phi_k [rad]
  double horizontal_amplitude = 0.0;  ///< A_x,k [m]
  double horizontal_phase = 0.0;      ///< phi_x,k [rad]

  void archive(StateArchive& state)
  {
    state(multiple, amplitude, phase, horizontal_amplitude, horizontal_phase);
  }
};

/// A corner of the outline of a tooth, in coordinates of the tooth: s along the base from the tooth's left
/// end, n normal to the base.
struct OutlineCorner
{
  double s = 0.0;  ///< [m]
  double n = 0.0;  ///< [m]

  void archive(StateArchive& state) { state(s, n); }
};

/// The base and its drive. Tooth k spans s in [k w, (k+1) w] along the base; that of a sawtooth has its apex
/// at s = (k + a) w, n = h. The whole base moves by D(t) = (A_x sin(phi + phi_x), A sin(phi)) and its
/// harmonics along the axes of `drive_frame`.
struct BaseDefinition
{
  int teeth = 20;
  double tooth_width = 0.020;   ///< w [m]
  double tooth_height = 0.006;  ///< h [m]; 0 is a flat base
  double asymmetry = 0.3;       ///< a in [0, 1]; the left slope spans a w
  double inclination = 0.0;     ///< theta [rad]; > 0 raises the right end, about the foot at s = 0
  double amplitude = 0.002;     ///< A [m]
  double frequency = 23.0;      ///< f [Hz]
  double phase = 0.0;           ///< phi at t = 0 [rad]
  double wall_height = 0.0;     ///< height of the walls of a walled base above n = 0 [m]; 0: see wallHeight()

  double horizontal_amplitude = 0.0;  ///< A_x [m]; a negative value reverses the horizontal part
  double horizontal_phase = 0.0;      ///< phi_x [rad]
  std::vector<HarmonicDefinition> harmonics;
  DriveFrame drive_frame = DriveFrame::WORLD;

  /// If any: the outline of a tooth in place of tooth_width, tooth_height and asymmetry. From (0, 0) to (w,
  /// 0), at least two corners, s never decreasing (equal: a vertical face), no corner twice.
  std::vector<OutlineCorner> profile;

  /// Whether a tooth is that of tooth_width, tooth_height and asymmetry, which the SIMD kernels know.
  bool isSawtooth() const { return profile.empty(); }

  double toothWidth() const { return profile.empty() ? tooth_width : profile.back().s; }  ///< w [m]
  double width() const { return teeth * toothWidth(); }                                   ///< W = L w [m]
  double highest() const;  ///< height of the highest corner above n = 0 [m]
  double depth() const;    ///< of the lowest corner below n = 0 [m]

  /// The corners of one tooth, from left to right: all that the shape of the base follows from.
  std::vector<OutlineCorner> outline() const;

  /// a of a tooth of two slopes, however it is defined; nothing for any other tooth.
  std::optional<double> slopeAsymmetry() const;

  void archive(StateArchive& state)
  {
    state(teeth, tooth_width, tooth_height, asymmetry, inclination, amplitude, frequency, phase, wall_height,
          horizontal_amplitude, horizontal_phase, harmonics, drive_frame, profile);
  }
};

/// The coefficients of the collision law for one kind of contact.
struct ContactCoefficients
{
  double restitution = 0.6;             ///< e in [0, 1]
  double friction = 0.1;                ///< Coulomb mu >= 0
  double tangential_restitution = 0.4;  ///< beta in [-1, 1]

  void archive(StateArchive& state) { state(restitution, friction, tangential_restitution); }
};

/// How the radii of a species' disks are distributed about its radius r.
enum class SizeDistribution
{
  UNIFORM,    ///< from r (1 - s) to r (1 + s)
  NORMAL,     ///< mean r, standard deviation s r, cut at 3 of them
  LOGNORMAL,  ///< median r, standard deviation s of the logarithm, cut at 3 of them
  TABLE       ///< as a sieve analysis gives it
};

/// What the weights of a table of sizes are shares of.
enum class SizeShare
{
  NUMBER,
  MASS
};

/// The sizes of a species' disks. By default all are equal.
struct SizeDefinition
{
  SizeDistribution distribution = SizeDistribution::UNIFORM;
  double spread = 0.0;         ///< s; not of a table
  double mass_exponent = 3.0;  ///< p of m (r'/r)^p: 3 for balls of one material, 2 for disks of one thickness
  std::vector<double> radii;   ///< of a table, increasing [m]
  std::vector<double> weights;  ///< of a table: between each radius and the one before; the first: at the
                                ///< first radius
  SizeShare by = SizeShare::NUMBER;

  bool vary() const { return distribution == SizeDistribution::TABLE || spread > 0.0; }

  void archive(StateArchive& state) { state(distribution, spread, mass_exponent, radii, weights, by); }
};

/// One kind of disk.
struct SpeciesDefinition
{
  std::string name = "A";
  int count = 0;                ///< number of disks poured at the start
  double share = 1.0;           ///< by number, when a density or a feed is split among the species
  double radius = 0.001;        ///< [m]
  double mass = 0.001;          ///< [kg]
  ContactCoefficients contact;  ///< with the base, and with disks of the same species
  double inertia_factor = 0.5;  ///< alpha = I / (m r^2); 1/2 for a uniform disk
  SizeDefinition size;

  /// The mass of a disk of this radius [m]: m (r'/r)^p [kg].
  double massOf(double disk_radius) const;

  /// I of a disk of this mass [kg] and radius [m]: alpha m r^2 [kg m^2].
  double inertiaOf(double disk_mass, double disk_radius) const
  {
    return inertia_factor * disk_mass * disk_radius * disk_radius;
  }
  double inertia() const { return inertiaOf(mass, radius); }  ///< [kg m^2]

  void archive(StateArchive& state)
  {
    state(name, count, share, radius, mass, contact, inertia_factor, size);
  }
};

/// Coefficients of a pair of different species, if they are not the mean of the two species' own.
struct PairDefinition
{
  std::size_t first = 0;   ///< index into SceneDefinition::species
  std::size_t second = 0;  ///< index into SceneDefinition::species
  ContactCoefficients contact;

  void archive(StateArchive& state) { state(first, second, contact); }
};

/// What a run does when a disk undergoes an inelastic collapse: more and more contacts in less and less time.
enum class CollapseAction
{
  STOP,    ///< The run ends with an error, at the instant of the first collapse.
  REBOUND  ///< The disk's contacts are elastic for a while, and the run counts the collapse; see
           ///< CollapseWatch.
};

/// Which contacts are modelled, by which law, and how the inelastic collapse is avoided.
struct ContactDefinition : CollisionLaw
{
  bool pair_collisions = true;    ///< false: an ensemble of independent disks, without disk-disk collisions
  double contact_duration = 0.0;  ///< t_c [s], Luding & McNamara, Granular Matter 1, 113 (1998); 0: none
  CollapseAction on_collapse = CollapseAction::STOP;
  int collapse_events = 1000000;  ///< more events of one disk within timeScale() are a collapse

  void archive(StateArchive& state)
  {
    state(min_rebound_speed, restitution_speed, restitution_exponent, pair_collisions, contact_duration,
          on_collapse, collapse_events);
  }
};

/// The part of the base onto which disks are poured, by the positions of their centres. The positions are
/// uniform on it; a disk stays free of walls and open ends.
struct Stretch
{
  double from = 0.0;                                    ///< s [m]
  double to = std::numeric_limits<double>::infinity();  ///< s [m]; infinity: the right end of the base

  double length(double width) const { return std::min(to, width) - from; }  ///< on a base of this width [m]

  void archive(StateArchive& state) { state(from, to); }
};

/// How the disks start: spatially uniform along their stretch, without overlap.
struct PourDefinition
{
  double drop_height = 0.02;  ///< of the lowest disks' undersides above the base's highest position [m]
  double speed = 0.0;         ///< downwards [m/s]
  Stretch stretch;

  void archive(StateArchive& state) { state(drop_height, speed, stretch); }
};

/// What a run does when its fed base is choked: see chokeOf().
enum class ChokeAction
{
  RUN,  ///< It goes on, with a warning.
  STOP  ///< It ends early, with a warning.
};

/// A disk that is fed at a time of its own, such as one that has left another machine.
struct FedDisk
{
  double time = 0.0;        ///< since the start [s]
  std::size_t species = 0;  ///< index into SceneDefinition::species
  double radius = 0.001;    ///< [m]
  double mass = 0.001;      ///< [kg]

  void archive(StateArchive& state) { state(time, species, radius, mass); }
};

/// Disks that are added during the run, as a Poisson process: fixed intervals lock to the drive wherever its
/// frequency is a multiple of the rate. Or those of a list, each at its time.
struct FeedDefinition
{
  double rate = 0.0;  ///< mean [1/s]; species are drawn by their shares; 0: no such feed
  bool even = false;  ///< at intervals of 1 / rate
  Stretch stretch;
  ChokeAction on_choke = ChokeAction::RUN;
  std::vector<FedDisk> disks;  ///< in place of the rate, in the order of time

  bool any() const { return rate > 0.0 || !disks.empty(); }

  void archive(StateArchive& state) { state(rate, even, stretch, on_choke, disks); }
};

/// A disk placed by hand instead of poured; world frame at t = 0.
struct InitialDisk  // scalars, because each is a key of the scene
{
  std::size_t species = 0;  ///< index into SceneDefinition::species
  double x = 0.0;           ///< [m]
  double y = 0.0;           ///< [m]
  double vx = 0.0;          ///< [m/s]
  double vy = 0.0;          ///< [m/s]
  double spin = 0.0;        ///< counter-clockwise [rad/s]

  void archive(StateArchive& state) { state(species, x, y, vx, vy, spin); }
};

/// How the disks are advanced.
enum class Method
{
  EVENTS,  ///< event-driven: from contact to contact, exactly
  STEPS    ///< fixed integration steps, contacts found by overlap: faster for dense scenes, less accurate
};

/// How accurately the model is solved, and the statistical error at which the run may end early.
struct AccuracyDefinition
{
  Method method = Method::EVENTS;
  double step = 0.0005;  ///< of Method::STEPS [s]

  double mean_vx = 0.0;      ///< the run may end when each ⟨V_x⟩ has this half-width [m/s]; 0: not used
  double quality = 0.0;      ///< the run may end when Q has this half-width; 0: not used
  double confidence = 0.95;  ///< confidence level of these half-widths

  /// Whether the run may end before its duration.
  bool endsEarly() const { return mean_vx > 0.0 || quality > 0.0; }

  void archive(StateArchive& state) { state(method, step, mean_vx, quality, confidence); }
};

/// How the observable height_profile divides what it sees.
struct HeightProfileDefinition
{
  double slice = 0.0;  ///< height of a slice [m]; 0: the smallest radius
  int phases = 1;      ///< equal parts of the drive's period, from phase 0 on; 1: means over the whole

  void archive(StateArchive& state) { state(slice, phases); }
};

/// The complete definition of a run. A plain struct: the scene layer reads and validates it. Its bytes
/// (archive()) are for the engine in a browser, which reads no YAML.
struct SceneDefinition
{
  BaseDefinition base;
  Boundary boundary = Boundary::PERIODIC;
  double gravity = 9.81;  ///< downwards [m/s^2]
  std::vector<SpeciesDefinition> species;
  std::vector<PairDefinition> pairs;
  ContactDefinition contact;
  PourDefinition pour;
  FeedDefinition feed;
  std::vector<InitialDisk> initial;
  AccuracyDefinition accuracy;
  double duration = 100.0;           ///< [s]
  std::vector<std::string> observe;  ///< names of observableNames()
  HeightProfileDefinition height_profile;
  double settle = 0.0;  ///< initial part of the duration that the means leave out [s]
  std::uint64_t seed = 1;

  void archive(StateArchive& state)
  {
    state(base, boundary, gravity, species, pairs, contact, pour, feed, initial, accuracy, duration, observe,
          height_profile, settle, seed);
  }
};

/// Contact coefficients between two species: the pair's own, or else the mean of the two species'.
ContactCoefficients contactBetween(const SceneDefinition& scene, std::size_t first, std::size_t second);

}  // namespace ratchet_sieve
