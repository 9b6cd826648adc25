#include "schema.h"

#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/scene/scene_limits.h"

namespace ratchet_sieve
{
namespace
{

// The limits below, as those of scene_limits.h and of the commanded quantities, keep products of the values
// far from overflow; no machine comes near them.
constexpr double SMALLEST_LENGTH = 1e-9;  ///< [m]
constexpr double LARGEST_LENGTH = 1e3;    ///< [m]
constexpr double LARGEST_POSITION = 1e9;  ///< [m]
constexpr double SMALLEST_MASS = 1e-18;   ///< [kg]
constexpr double LARGEST_MASS = 1e6;      ///< [kg]
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

const Range ANY{};

Range upTo(double highest, const char* unit = "")
{
  return {0.0, highest, unit};
}

Range within(double magnitude, const char* unit)
{
  return {-magnitude, magnitude, unit};
}

Range legal(Quantity quantity)
{
  const CommandedQuantity& described = describe(quantity);
  return {described.legal.min, described.legal.max, described.unit};
}

/// Of an amplitude that turns its part of the drive around where it is below 0.
Range eitherWay()
{
  const CommandedQuantity& amplitude = describe(Quantity::AMPLITUDE);
  return within(amplitude.legal.max, amplitude.unit);
}

}  // namespace

Range densityRange()
{
  return upTo(LARGEST_DENSITY);
}

const Keys<SceneDefinition>& motionKeys()
{
  using S = SceneDefinition;
  static const Keys<S> KEYS = {
      {"boundary", [](S& s) -> Slot { return &s.boundary; }, ANY},
      {"gravity", [](S& s) -> Slot { return &s.gravity; }, upTo(LARGEST_GRAVITY, "m/s^2")},
  };
  return KEYS;
}

const Keys<SceneDefinition>& runKeys()
{
  using S = SceneDefinition;
  static const Keys<S> KEYS = {
      {"duration", [](S& s) -> Slot { return &s.duration; }, upTo(LONGEST_DURATION, "s")},
      {"settle", [](S& s) -> Slot { return &s.settle; }, upTo(LONGEST_DURATION, "s")},
      {"seed", [](S& s) -> Slot { return &s.seed; }, ANY},
  };
  return KEYS;
}

const Keys<BaseDefinition>& baseKeys()
{
  using B = BaseDefinition;
  static const Keys<B> KEYS = {
      {"teeth", [](B& b) -> Slot { return &b.teeth; }, {1, MOST_TEETH, ""}},
      {"tooth_width", [](B& b) -> Slot { return &b.tooth_width; }, {SMALLEST_LENGTH, LARGEST_LENGTH, "m"}},
      {"tooth_height", [](B& b) -> Slot { return &b.tooth_height; }, upTo(LARGEST_LENGTH, "m")},
      {"asymmetry", [](B& b) -> Slot { return &b.asymmetry; }, upTo(1.0)},
      {"inclination", [](B& b) -> Slot { return &b.inclination; }, legal(Quantity::INCLINATION)},
      {"amplitude", [](B& b) -> Slot { return &b.amplitude; }, legal(Quantity::AMPLITUDE)},
      {"frequency", [](B& b) -> Slot { return &b.frequency; }, legal(Quantity::FREQUENCY)},
      {"phase", [](B& b) -> Slot { return &b.phase; }, within(LARGEST_PHASE, "rad")},
      {"wall_height", [](B& b) -> Slot { return &b.wall_height; }, upTo(LARGEST_LENGTH, "m"), false, false},
      {"horizontal_amplitude", [](B& b) -> Slot { return &b.horizontal_amplitude; }, eitherWay(), false,
       false},
      {"horizontal_phase", [](B& b) -> Slot { return &b.horizontal_phase; }, within(LARGEST_PHASE, "rad"),
       false, false},
  };
  return KEYS;
}

const Keys<HarmonicDefinition>& harmonicKeys()
{
  using H = HarmonicDefinition;
  static const Keys<H> KEYS = {
      {"multiple", [](H& h) -> Slot { return &h.multiple; }, {2, HIGHEST_MULTIPLE, ""}, true},
      {"amplitude", [](H& h) -> Slot { return &h.amplitude; }, eitherWay()},
      {"phase", [](H& h) -> Slot { return &h.phase; }, within(LARGEST_PHASE, "rad")},
      {"horizontal_amplitude", [](H& h) -> Slot { return &h.horizontal_amplitude; }, eitherWay()},
      {"horizontal_phase", [](H& h) -> Slot { return &h.horizontal_phase; }, within(LARGEST_PHASE, "rad")},
  };
  return KEYS;
}

const Keys<SpeciesDefinition>& speciesKeys()
{
  using S = SpeciesDefinition;
  static const Keys<S> KEYS = {
      {"name", [](S& s) -> Slot { return &s.name; }, ANY, true},
      {"count", [](S& s) -> Slot { return &s.count; }, upTo(MOST_DISKS)},
      {"share", [](S& s) -> Slot { return &s.share; }, upTo(LARGEST_SHARE)},
      {"radius", [](S& s) -> Slot { return &s.radius; }, {SMALLEST_LENGTH, LARGEST_LENGTH, "m"}, true},
      {"mass", [](S& s) -> Slot { return &s.mass; }, {SMALLEST_MASS, LARGEST_MASS, "kg"}, true},
      {"inertia_factor", [](S& s) -> Slot { return &s.inertia_factor; }, {SMALLEST_INERTIA, 1.0, ""}},
  };
  return KEYS;
}

const Keys<ContactCoefficients>& coefficientKeys()
{
  using C = ContactCoefficients;
  static const Keys<C> KEYS = {
      {"restitution", [](C& c) -> Slot { return &c.restitution; }, upTo(1.0)},
      {"friction", [](C& c) -> Slot { return &c.friction; }, upTo(LARGEST_FRICTION)},
      {"tangential_restitution", [](C& c) -> Slot { return &c.tangential_restitution; }, within(1.0, "")},
  };
  return KEYS;
}

const Keys<ContactDefinition>& contactKeys()
{
  using C = ContactDefinition;
  static const Keys<C> KEYS = {
      {"pair_collisions", [](C& c) -> Slot { return &c.pair_collisions; }, ANY},
      {"min_rebound_speed", [](C& c) -> Slot { return &c.min_rebound_speed; }, upTo(LARGEST_SPEED, "m/s")},
      {"contact_duration", [](C& c) -> Slot { return &c.contact_duration; }, upTo(LONGEST_DURATION, "s")},
      {"on_collapse", [](C& c) -> Slot { return &c.on_collapse; }, ANY},
      {"collapse_events", [](C& c) -> Slot { return &c.collapse_events; }, {1e3, 1e9, ""}},
      {"restitution_speed", [](C& c) -> Slot { return &c.restitution_speed; }, upTo(LARGEST_SPEED, "m/s"),
       false, false},
      {"restitution_exponent", [](C& c) -> Slot { return &c.restitution_exponent; }, upTo(10.0), false,
       false},
  };
  return KEYS;
}

const Keys<PourDefinition>& pourKeys()
{
  using P = PourDefinition;
  static const Keys<P> KEYS = {
      {"drop_height", [](P& p) -> Slot { return &p.drop_height; }, upTo(LARGEST_LENGTH, "m")},
      {"speed", [](P& p) -> Slot { return &p.speed; }, upTo(LARGEST_SPEED, "m/s")},
  };
  return KEYS;
}

const Keys<FeedDefinition>& feedKeys()
{
  using F = FeedDefinition;
  static const Keys<F> KEYS = {{"rate", [](F& f) -> Slot { return &f.rate; }, upTo(LARGEST_RATE, "1/s")}};
  return KEYS;
}

const Keys<InitialDisk>& initialKeys()
{
  using I = InitialDisk;
  static const Keys<I> KEYS = {
      {"x", [](I& i) -> Slot { return &i.x; }, within(LARGEST_POSITION, "m"), true},
      {"y", [](I& i) -> Slot { return &i.y; }, within(LARGEST_POSITION, "m"), true},
      {"vx", [](I& i) -> Slot { return &i.vx; }, within(LARGEST_SPEED, "m/s")},
      {"vy", [](I& i) -> Slot { return &i.vy; }, within(LARGEST_SPEED, "m/s")},
      {"spin", [](I& i) -> Slot { return &i.spin; }, within(LARGEST_SPIN, "rad/s")},
  };
  return KEYS;
}

const Keys<AccuracyDefinition>& methodKeys()
{
  using A = AccuracyDefinition;
  static const Keys<A> KEYS = {
      {"method", [](A& a) -> Slot { return &a.method; }, ANY, false, false},
      {"step", [](A& a) -> Slot { return &a.step; }, {SHORTEST_STEP, LONGEST_STEP, "s"}, false, false},
  };
  return KEYS;
}

const Keys<AccuracyDefinition>& certaintyKeys()
{
  using A = AccuracyDefinition;
  static const Keys<A> KEYS = {
      {"mean_vx", [](A& a) -> Slot { return &a.mean_vx; }, upTo(LARGEST_SPEED, "m/s"), false, false},
      {"quality", [](A& a) -> Slot { return &a.quality; }, upTo(1.0), false, false},
      {"confidence", [](A& a) -> Slot { return &a.confidence; }, {0.5, 0.9999, ""}, false, false},
  };
  return KEYS;
}

}  // namespace ratchet_sieve
