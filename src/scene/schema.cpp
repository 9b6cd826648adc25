#include "schema.h"

#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

// These limits, LONGEST_DURATION and those of the commanded quantities keep products of the values far
// from overflow. They are far beyond any real machine.
constexpr double LARGEST_LENGTH = 1e3;    ///< [m]
constexpr double LARGEST_WIDTH = 1e9;     ///< of a base [m]
constexpr double LARGEST_POSITION = 1e9;  ///< [m]
constexpr double SMALLEST_MASS = 1e-18;   ///< [kg]
constexpr double LARGEST_MASS = 1e6;      ///< [kg]
constexpr double LIGHTEST_BALL = 1e-3;    ///< [kg/m^3]
constexpr double DENSEST_BALL = 1e7;      ///< [kg/m^3]
constexpr double LARGEST_SPEED = 1e4;     ///< [m/s]
constexpr double LARGEST_SPIN = 1e9;      ///< [rad/s]
constexpr double LARGEST_GRAVITY = 1e4;   ///< [m/s^2]
constexpr double LARGEST_PHASE = 1e6;     ///< [rad]
constexpr double LARGEST_RATE = 1e6;      ///< [1/s]
constexpr double LARGEST_SHARE = 1e9;
constexpr double LARGEST_DENSITY = 1e6;
constexpr double LARGEST_FRICTION = 1e9;
constexpr double SMALLEST_INERTIA = 1e-6;
constexpr double MOST_TEETH = 1e6;
constexpr double SHORTEST_STEP = 1e-7;  ///< [s]
constexpr double LONGEST_STEP = 0.1;    ///< [s]
constexpr double HIGHEST_MULTIPLE = 100;
constexpr double LARGEST_SPREAD = 3.0;
constexpr double LARGEST_MASS_EXPONENT = 10.0;
constexpr double MOST_PHASES = 64;

const Range ANY{};

Range between(double lowest, double highest, const char* unit = "")
{
  return {lowest, highest, unit};
}

Range upTo(double highest, const char* unit = "")
{
  return between(0.0, highest, unit);
}

Range within(double magnitude, const char* unit)
{
  return between(-magnitude, magnitude, unit);
}

Range legal(Quantity quantity)
{
  const CommandedQuantity& described = describe(quantity);
  return {described.legal.min, described.legal.max, described.unit};
}

/// Of an amplitude that may be negative, which reverses its part of the drive.
Range eitherWay()
{
  const CommandedQuantity& amplitude = describe(Quantity::AMPLITUDE);
  return within(amplitude.legal.max, amplitude.unit);
}

}  // namespace

Range massRange()
{
  return between(SMALLEST_MASS, LARGEST_MASS, "kg");
}

Range teethRange()
{
  return between(1, MOST_TEETH);
}

const std::vector<Replacement>& baseReplacements()
{
  static const std::vector<Replacement> REPLACEMENTS = {{"profile", SAWTOOTH_KEYS, "the tooth"},
                                                        {"length", {"teeth"}, "the number of teeth"}};
  return REPLACEMENTS;
}

const Keys<SceneDefinition> MOTION_KEYS = {
    {"boundary", [](auto& s) -> Slot { return &s.boundary; }, ANY,
     "What happens to a disk at an end of the base: it enters at the other end (periodic), it "
     "falls into the bin of that end (open), or it does so only if it passes over a wall "
     "(walled)."},
    {"gravity", [](auto& s) -> Slot { return &s.gravity; }, upTo(LARGEST_GRAVITY, "m/s^2"),
     "Gravitational acceleration g, downwards."},
    {"observe", [](auto& s) -> Slot { return &s.observe; }, ANY,
     "What else to observe, by species: of each bin the time in the machine (residence_times) and the mass "
     "per time (mass_flow); number density, mean velocity and temperature over the height above the base "
     "(height_profile).",
     Presence::ADDED},
};

const Keys<SceneDefinition> RUN_KEYS = {
    {"duration", [](auto& s) -> Slot { return &s.duration; }, upTo(LONGEST_DURATION, "s"),
     "Simulated time of the run; an upper bound if accuracy.mean_vx or accuracy.quality is set."},
    {"settle", [](auto& s) -> Slot { return &s.settle; }, upTo(LONGEST_DURATION, "s"),
     "Initial part of the duration that is left out of every mean; at most the duration."},
    {"seed", [](auto& s) -> Slot { return &s.seed; }, ANY,
     "Seed of the random numbers: the same scene and seed give the same run, bit for bit."},
};

const Keys<double> DENSITY_KEYS = {
    {"density", [](auto& density) -> Slot { return &density; }, upTo(LARGEST_DENSITY),
     "Sum of all disks' diameters (with a size: of the expected ones) over the width of the base, in "
     "place of every species' count.",
     Presence::OPTIONAL, "-"},
};

const Keys<BaseDefinition> BASE_KEYS = {
    {"teeth", [](auto& b) -> Slot { return &b.teeth; }, teethRange(),
     "Number of teeth L; the base is L times tooth_width wide."},
    {"tooth_width", [](auto& b) -> Slot { return &b.tooth_width; },
     between(SMALLEST_LENGTH, LARGEST_LENGTH, "m"), "Width w of a tooth."},
    {"tooth_height", [](auto& b) -> Slot { return &b.tooth_height; }, upTo(LARGEST_LENGTH, "m"),
     "Height h of a tooth; 0: a flat base."},
    {"asymmetry", [](auto& b) -> Slot { return &b.asymmetry; }, upTo(1.0),
     "Asymmetry a: the left slope of a tooth spans a w, the right one (1 - a) w."},
    {"inclination", [](auto& b) -> Slot { return &b.inclination; }, legal(Quantity::INCLINATION),
     "Inclination theta of the base; above 0 the right end is raised."},
    {"amplitude", [](auto& b) -> Slot { return &b.amplitude; }, legal(Quantity::AMPLITUDE),
     "Amplitude A of the vertical drive A sin(2 pi f t + phase)."},
    {"frequency", [](auto& b) -> Slot { return &b.frequency; }, legal(Quantity::FREQUENCY),
     "Frequency f of the drive."},
    {"phase", [](auto& b) -> Slot { return &b.phase; }, within(LARGEST_PHASE, "rad"),
     "Phase of the drive at t = 0."},
    {"wall_height", [](auto& b) -> Slot { return &b.wall_height; }, upTo(LARGEST_LENGTH, "m"),
     "Height of the walls of a walled base above the feet of the teeth; 0: ten base widths above "
     "the poured disks.",
     Presence::ADDED},
    {"horizontal_amplitude", [](auto& b) -> Slot { return &b.horizontal_amplitude; }, eitherWay(),
     "Amplitude A_x of the horizontal drive A_x sin(2 pi f t + phase + horizontal_phase); below 0 "
     "it is reversed.",
     Presence::ADDED},
    {"horizontal_phase", [](auto& b) -> Slot { return &b.horizontal_phase; }, within(LARGEST_PHASE, "rad"),
     "Phase of the horizontal drive relative to the vertical one.", Presence::ADDED},
    {"drive_frame", [](auto& b) -> Slot { return &b.drive_frame; }, ANY,
     "Axes of the drive: vertical and horizontal (world), or normal to the base and along it, turning with "
     "it (base), as a vibrator bolted to the deck drives it.",
     Presence::ADDED},
    {"profile", [](auto& b) -> Slot { return &b.profile; }, within(LARGEST_LENGTH, "m"),
     "Outline of a tooth in place of tooth_width, tooth_height and asymmetry: corners from [0, 0] to "
     "[w, 0], s never decreasing (twice the same: a vertical face), n above or below 0.",
     Presence::ADDED, "-"},
};

const Keys<double> LENGTH_KEYS = {
    {"length", [](auto& length) -> Slot { return &length; }, between(SMALLEST_LENGTH, LARGEST_WIDTH, "m"),
     "Length of the base in place of teeth, rounded to whole teeth.", Presence::OPTIONAL, "-"},
};

const std::set<std::string> SAWTOOTH_KEYS = {"tooth_width", "tooth_height", "asymmetry"};

const Keys<HarmonicDefinition> HARMONIC_KEYS = {
    {"multiple", [](auto& h) -> Slot { return &h.multiple; }, between(2, HIGHEST_MULTIPLE),
     "Multiple k of the drive frequency f.", Presence::REQUIRED},
    {"amplitude", [](auto& h) -> Slot { return &h.amplitude; }, eitherWay(),
     "Vertical amplitude A_k of A_k sin(k (2 pi f t + base.phase) + phase)."},
    {"phase", [](auto& h) -> Slot { return &h.phase; }, within(LARGEST_PHASE, "rad"),
     "Phase of the vertical part."},
    {"horizontal_amplitude", [](auto& h) -> Slot { return &h.horizontal_amplitude; }, eitherWay(),
     "Horizontal amplitude A_x,k, with horizontal_phase in place of phase."},
    {"horizontal_phase", [](auto& h) -> Slot { return &h.horizontal_phase; }, within(LARGEST_PHASE, "rad"),
     "Phase of the horizontal part."},
};

const Keys<SpeciesDefinition> SPECIES_KEYS = {
    {"name", [](auto& s) -> Slot { return &s.name; }, ANY,
     "Name of the species; no two species have the same.", Presence::REQUIRED},
    {"count", [](auto& s) -> Slot { return &s.count; }, upTo(MOST_DISKS),
     "Number of disks poured at the start; required unless there is a feed (then 0 is the default), or "
     "density or initial, which replace it.",
     Presence::OPTIONAL, "-"},
    {"share", [](auto& s) -> Slot { return &s.share; }, upTo(LARGEST_SHARE),
     "Weight of the species among the disks that are fed or that density pours: a share by number, unless "
     "share_by is mass."},
    {"radius", [](auto& s) -> Slot { return &s.radius; }, between(SMALLEST_LENGTH, LARGEST_LENGTH, "m"),
     "Radius r; with a size, that of a disk of mass m; a disk must fit into the base, and the smallest "
     "must not be too small for double "
     "precision.",
     Presence::REQUIRED},
    {"mass", [](auto& s) -> Slot { return &s.mass; }, massRange(), "Mass m; density may replace it.",
     Presence::REQUIRED},
    {"inertia_factor", [](auto& s) -> Slot { return &s.inertia_factor; }, between(SMALLEST_INERTIA, 1.0),
     "Moment of inertia over m r^2; 0.5: a uniform disk."},
};

const Keys<SizeShare> SHARE_KEYS = {
    {"share_by", [](auto& by) -> Slot { return &by; }, ANY,
     "Whether the shares are those of the disks or of their mass, by the mean mass of a disk of each "
     "species; "
     "the same for all species."},
};

const Keys<double> MATERIAL_KEYS = {
    {"density", [](auto& density) -> Slot { return &density; },
     between(LIGHTEST_BALL, DENSEST_BALL, "kg/m^3"),
     "Density of the material, in place of mass: m = 4/3 pi r^3 times it, as of a ball.", Presence::OPTIONAL,
     "-"},
};

const Keys<SizeDefinition> SIZE_KEYS = {
    {"distribution", [](auto& s) -> Slot { return &s.distribution; }, ANY,
     "How the radii of the poured disks are distributed, by number: from r (1 - spread) to "
     "r (1 + spread) (uniform); with mean r and standard deviation spread r, cut at 3 of them "
     "(normal); with median r and standard deviation spread of the logarithm, cut at 3 of them "
     "(lognormal); or as in the table radii, weights (table).",
     Presence::REQUIRED},
    {"mass_exponent", [](auto& s) -> Slot { return &s.mass_exponent; }, upTo(LARGEST_MASS_EXPONENT),
     "Exponent p of the mass m (r'/r)^p of a disk of radius r': 3 for balls of one material, 2 for "
     "disks of one thickness."},
};

const Keys<SizeDefinition> SPREAD_KEYS = {
    {"spread", [](auto& s) -> Slot { return &s.spread; }, upTo(LARGEST_SPREAD),
     "Width of the distribution, relative to r; uniform: below 1; normal: below 1/3.", Presence::REQUIRED},
};

const Keys<SizeDefinition> TABLE_KEYS = {
    {"radii", [](auto& s) -> Slot { return &s.radii; }, between(SMALLEST_LENGTH, LARGEST_LENGTH, "m"),
     "Radii of a table, each larger than the one before; r is within them.", Presence::REQUIRED},
    {"weights", [](auto& s) -> Slot { return &s.weights; }, upTo(LARGEST_SHARE),
     "Shares of the disks between each radius and the one before, where the cumulative share grows "
     "in proportion to the radius; the first: of the disks that have the first radius.",
     Presence::REQUIRED},
    {"by", [](auto& s) -> Slot { return &s.by; }, ANY, "What the weights are shares of."},
};

const Keys<ContactCoefficients> COEFFICIENT_KEYS = {
    {"restitution", [](auto& c) -> Slot { return &c.restitution; }, upTo(1.0),
     "Normal coefficient of restitution e."},
    {"friction", [](auto& c) -> Slot { return &c.friction; }, upTo(LARGEST_FRICTION),
     "Coulomb friction coefficient mu."},
    {"tangential_restitution", [](auto& c) -> Slot { return &c.tangential_restitution; }, within(1.0, ""),
     "Tangential coefficient of restitution beta of contacts that stick: 1 reverses the "
     "tangential velocity of the contact point, -1 leaves it as it is."},
};

const Keys<ContactDefinition> CONTACT_KEYS = {
    {"pair_collisions", [](auto& c) -> Slot { return &c.pair_collisions; }, ANY,
     "Whether disks collide with each other; false: an ensemble of independent single disks."},
    {"min_rebound_speed", [](auto& c) -> Slot { return &c.min_rebound_speed; }, upTo(LARGEST_SPEED, "m/s"),
     "Least normal speed v_min after a contact; 0: none."},
    {"contact_duration", [](auto& c) -> Slot { return &c.contact_duration; }, upTo(LONGEST_DURATION, "s"),
     "Contact duration t_c of the TC model: a contact within t_c of the disk's last one loses no "
     "energy; 0: not used."},
    {"on_collapse", [](auto& c) -> Slot { return &c.on_collapse; }, ANY,
     "What happens at an inelastic collapse: the run ends with an error (stop), or the disk's "
     "slow contacts lose no energy for a while and the run counts it (rebound)."},
    {"collapse_events", [](auto& c) -> Slot { return &c.collapse_events; }, between(1e3, 1e9),
     "Number of events of one disk within a drive period (or the time of a fall over a tooth, if "
     "shorter) above which it is in a collapse."},
    {"restitution_speed", [](auto& c) -> Slot { return &c.restitution_speed; }, upTo(LARGEST_SPEED, "m/s"),
     "Speed v_0 below which contacts lose less energy: e(v) = 1 - (1 - e) (v / v_0)^q; 0: e at "
     "every speed.",
     Presence::ADDED},
    {"restitution_exponent", [](auto& c) -> Slot { return &c.restitution_exponent; }, upTo(10.0),
     "Exponent q of e(v).", Presence::ADDED},
};

const Keys<PourDefinition> POUR_KEYS = {
    {"drop_height", [](auto& p) -> Slot { return &p.drop_height; }, upTo(LARGEST_LENGTH, "m"),
     "Height of the undersides of the lowest disks above the highest point that the base reaches."},
    {"speed", [](auto& p) -> Slot { return &p.speed; }, upTo(LARGEST_SPEED, "m/s"),
     "Initial downward speed of the disks."},
    {"from", [](auto& p) -> Slot { return &p.stretch.from; }, upTo(LARGEST_WIDTH, "m"),
     "Left end, along the base, of the stretch onto which the centres of the disks are poured; also of "
     "disks that are poured on command.",
     Presence::ADDED},
    {"to", [](auto& p) -> Slot { return &p.stretch.to; }, upTo(LARGEST_WIDTH, "m"),
     "Right end of that stretch, at least pour.from; without it, the right end of the base.", Presence::ADDED,
     "-"},
};

const Keys<FeedDefinition> FEED_KEYS = {
    {"rate", [](auto& f) -> Slot { return &f.rate; }, upTo(LARGEST_RATE, "1/s"),
     "Mean number of disks per second that are poured while the machine runs, at random times (a Poisson "
     "process); species drawn by their shares; 0: none."},
    {"even", [](auto& f) -> Slot { return &f.even; }, ANY,
     "Disks are fed at intervals of 1 / rate, which lock to the drive if its frequency is a multiple of "
     "the "
     "rate.",
     Presence::ADDED},
    {"from", [](auto& f) -> Slot { return &f.stretch.from; }, upTo(LARGEST_WIDTH, "m"),
     "Left end, along the base, of the stretch onto which the centres of the disks are fed, as from a "
     "chute.",
     Presence::ADDED},
    {"to", [](auto& f) -> Slot { return &f.stretch.to; }, upTo(LARGEST_WIDTH, "m"),
     "Right end of that stretch, at least feed.from; without it, the right end of the base.", Presence::ADDED,
     "-"},
    {"on_choke", [](auto& f) -> Slot { return &f.on_choke; }, ANY,
     "What happens when the disks only pile up on the base: the run goes on (run) or ends early (stop), "
     "with a warning.",
     Presence::ADDED},
};

const Keys<FeedFile> FEED_FILE_KEYS = {
    {"file", [](auto& f) -> Slot { return &f.path; }, ANY,
     "Disks that are fed in place of a rate, each at its time: a CSV file with the columns time, species, "
     "radius and mass, as sieve_run --exits writes it; relative to the scene's file.",
     Presence::OPTIONAL, "-"},
    {"side", [](auto& f) -> Slot { return &f.side; }, ANY,
     "Only the rows of feed.file with this in the column side; without it all.", Presence::OPTIONAL, "-"},
};

const Keys<FedDisk> FED_KEYS = {
    {"time", [](auto& d) -> Slot { return &d.time; }, upTo(LONGEST_DURATION, "s"),
     "Time at which the disk is fed, since the start.", Presence::REQUIRED},
    {"radius", [](auto& d) -> Slot { return &d.radius; }, between(SMALLEST_LENGTH, LARGEST_LENGTH, "m"),
     "Radius of the disk.", Presence::REQUIRED},
    {"mass", [](auto& d) -> Slot { return &d.mass; }, massRange(), "Mass of the disk.", Presence::REQUIRED},
};

const Keys<HeightProfileDefinition> HEIGHT_PROFILE_KEYS = {
    {"slice", [](auto& h) -> Slot { return &h.slice; }, upTo(LARGEST_LENGTH, "m"),
     "Height of each of its slices, along the base's normal; 0: the smallest radius.", Presence::ADDED},
    {"phases", [](auto& h) -> Slot { return &h.phases; }, between(1, MOST_PHASES),
     "Equal parts of the drive's period, from phase 0 on, of which each has its own profile; 1: means over "
     "the whole period.",
     Presence::ADDED},
};

const Keys<InitialDisk> INITIAL_KEYS = {
    {"x", [](auto& i) -> Slot { return &i.x; }, within(LARGEST_POSITION, "m"),
     "Horizontal position of the centre, in the world frame.", Presence::REQUIRED},
    {"y", [](auto& i) -> Slot { return &i.y; }, within(LARGEST_POSITION, "m"),
     "Vertical position of the centre, in the world frame.", Presence::REQUIRED},
    {"vx", [](auto& i) -> Slot { return &i.vx; }, within(LARGEST_SPEED, "m/s"),
     "Horizontal velocity, in the world frame."},
    {"vy", [](auto& i) -> Slot { return &i.vy; }, within(LARGEST_SPEED, "m/s"),
     "Vertical velocity, in the world frame."},
    {"spin", [](auto& i) -> Slot { return &i.spin; }, within(LARGEST_SPIN, "rad/s"),
     "Angular velocity, counter-clockwise."},
};

const Keys<AccuracyDefinition> METHOD_KEYS = {
    {"method", [](auto& a) -> Slot { return &a.method; }, ANY,
     "How disks that collide with each other are advanced: exactly, from contact to contact "
     "(events), or approximately, by time steps (steps).",
     Presence::ADDED},
    {"step", [](auto& a) -> Slot { return &a.step; }, between(SHORTEST_STEP, LONGEST_STEP, "s"),
     "Time step of method steps; a contact that begins and ends within a step is missed.", Presence::ADDED},
};

const Keys<AccuracyDefinition> CERTAINTY_KEYS = {
    {"mean_vx", [](auto& a) -> Slot { return &a.mean_vx; }, upTo(LARGEST_SPEED, "m/s"),
     "Half-width of the confidence interval of each species' mean V_x at which the run may end "
     "before its duration; 0: not required.",
     Presence::ADDED},
    {"quality", [](auto& a) -> Slot { return &a.quality; }, upTo(1.0),
     "Half-width of the confidence interval of the separation quality Q at which the run may end "
     "before its duration; 0: not required.",
     Presence::ADDED},
    {"confidence", [](auto& a) -> Slot { return &a.confidence; }, between(0.5, 0.9999),
     "Confidence level of these intervals.", Presence::ADDED},
};

void forEachNumber(SceneDefinition& scene, const VisitNumber& visit)
{
  const auto visit_part = [&visit](const char* name, const auto& keys, auto& part)
  {
    for (const auto& key : keys)
    {
      const Slot slot = key.slot(part);
      if (double* const* number = std::get_if<double*>(&slot))
        visit(name, key.range.unit, **number);
      if (std::vector<double>* const* numbers = std::get_if<std::vector<double>*>(&slot))
        for (double& number : **numbers)
          visit(name, key.range.unit, number);
      if (std::vector<OutlineCorner>* const* corners = std::get_if<std::vector<OutlineCorner>*>(&slot))
        for (OutlineCorner& corner : **corners)
          for (double* number : {&corner.s, &corner.n})
            visit(name, key.range.unit, *number);
    }
  };
  visit_part("", MOTION_KEYS, scene);
  visit_part("", RUN_KEYS, scene);
  visit_part("base", BASE_KEYS, scene.base);
  for (HarmonicDefinition& harmonic : scene.base.harmonics)
    visit_part("base", HARMONIC_KEYS, harmonic);
  for (SpeciesDefinition& species : scene.species)
  {
    visit_part("species", SPECIES_KEYS, species);
    visit_part("species", TABLE_KEYS, species.size);
  }
  visit_part("contact", CONTACT_KEYS, scene.contact);
  visit_part("pour", POUR_KEYS, scene.pour);
  visit_part("feed", FEED_KEYS, scene.feed);
  for (FedDisk& disk : scene.feed.disks)
    visit_part("feed", FED_KEYS, disk);
  for (InitialDisk& disk : scene.initial)
    visit_part("initial", INITIAL_KEYS, disk);
  visit_part("height_profile", HEIGHT_PROFILE_KEYS, scene.height_profile);
  visit_part("accuracy", METHOD_KEYS, scene.accuracy);
  visit_part("accuracy", CERTAINTY_KEYS, scene.accuracy);
}

}  // namespace ratchet_sieve
