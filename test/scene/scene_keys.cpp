#include "scene_keys.h"

namespace ratchet_sieve
{

const std::vector<SceneKey>& sceneKeys()
{
  using K = ValueKind;
  static const std::vector<SceneKey> KEYS = {
      {"", "boundary", K::WORD, 0, 0, false, {"periodic", "open", "walled"}},
      {"", "gravity", K::NUMBER, 0, 1e4},
      {"", "density", K::NUMBER, 0, 1e6},
      {"", "duration", K::NUMBER, 0, 1e9},
      {"", "settle", K::NUMBER, 0, 1e9},
      {"", "seed", K::SEED},
      {"base", "teeth", K::INTEGER, 1, 1e6},
      {"base", "tooth_width", K::NUMBER, 1e-9, 1e3},
      {"base", "tooth_height", K::NUMBER, 0, 1e3},
      {"base", "asymmetry", K::NUMBER, 0, 1},
      {"base", "inclination", K::NUMBER, -1.5, 1.5},
      {"base", "amplitude", K::NUMBER, 0, 1e3},
      {"base", "frequency", K::NUMBER, 0, 1e6},
      {"base", "phase", K::NUMBER, -1e6, 1e6},
      {"base", "wall_height", K::NUMBER, 0, 1e3},
      {"base", "horizontal_amplitude", K::NUMBER, -1e3, 1e3},
      {"base", "horizontal_phase", K::NUMBER, -1e6, 1e6},
      {"base", "drive_frame", K::WORD, 0, 0, false, {"world", "base"}},
      {"species", "name", K::NAME, 0, 0, true},
      {"species", "count", K::INTEGER, 0, 1e7},
      {"species", "share", K::NUMBER, 0, 1e9},
      {"species", "radius", K::NUMBER, 1e-9, 1e3, true},
      {"species", "mass", K::NUMBER, 1e-18, 1e6, true},
      {"species", "inertia_factor", K::NUMBER, 1e-6, 1},
      {"species", "restitution", K::NUMBER, 0, 1},
      {"species", "friction", K::NUMBER, 0, 1e9},
      {"species", "tangential_restitution", K::NUMBER, -1, 1},
      {"pairs", "species", K::TWO_SPECIES, 0, 0, true},
      {"pairs", "restitution", K::NUMBER, 0, 1},
      {"pairs", "friction", K::NUMBER, 0, 1e9},
      {"pairs", "tangential_restitution", K::NUMBER, -1, 1},
      {"contact", "pair_collisions", K::TRUTH},
      {"contact", "min_rebound_speed", K::NUMBER, 0, 1e4},
      {"contact", "contact_duration", K::NUMBER, 0, 1e9},
      {"contact", "on_collapse", K::WORD, 0, 0, false, {"stop", "rebound"}},
      {"contact", "collapse_events", K::INTEGER, 1000, 1e9},
      {"contact", "restitution_speed", K::NUMBER, 0, 1e4},
      {"contact", "restitution_exponent", K::NUMBER, 0, 10},
      {"pour", "drop_height", K::NUMBER, 0, 1e3},
      {"pour", "speed", K::NUMBER, 0, 1e4},
      {"pour", "from", K::NUMBER, 0, 1e9},
      {"pour", "to", K::NUMBER, 0, 1e9},
      {"feed", "rate", K::NUMBER, 0, 1e6},
      {"feed", "even", K::TRUTH},
      {"feed", "from", K::NUMBER, 0, 1e9},
      {"feed", "to", K::NUMBER, 0, 1e9},
      {"feed", "on_choke", K::WORD, 0, 0, false, {"run", "stop"}},
      {"height_profile", "slice", K::NUMBER, 0, 1e3},
      {"height_profile", "phases", K::INTEGER, 1, 64},
      {"initial", "species", K::SPECIES, 0, 0, true},
      {"initial", "x", K::NUMBER, -1e9, 1e9, true},
      {"initial", "y", K::NUMBER, -1e9, 1e9, true},
      {"initial", "vx", K::NUMBER, -1e4, 1e4},
      {"initial", "vy", K::NUMBER, -1e4, 1e4},
      {"initial", "spin", K::NUMBER, -1e9, 1e9},
      {"accuracy", "method", K::WORD, 0, 0, false, {"events", "steps"}},
      {"accuracy", "step", K::NUMBER, 1e-7, 0.1},
      {"accuracy", "mean_vx", K::NUMBER, 0, 1e4},
      {"accuracy", "quality", K::NUMBER, 0, 1},
      {"accuracy", "confidence", K::NUMBER, 0.5, 0.9999},
  };
  return KEYS;
}

}  // namespace ratchet_sieve
