#pragma once

#include <stdexcept>
#include <string>

#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// A legal scene, to be spoiled line by line.
inline const char* const GOOD_SCENE =
    "base: {teeth: 20, tooth_width: 0.02}\n"                  // line 1
    "boundary: periodic\n"                                    // 2
    "species:\n"                                              // 3
    "  - {name: A, count: 10, radius: 0.001, mass: 0.001}\n"  // 4
    "  - {name: B, count: 10, radius: 0.002, mass: 0.002}\n"  // 5
    "pairs: []\n"                                             // 6
    "contact: {pair_collisions: true}\n"                      // 7
    "feed: {rate: 0.0}\n"                                     // 8
    "duration: 10.0\n"                                        // 9
    "settle: 0.0\n"                                           // 10
    "seed: 1\n";                                              // 11

/// The good scene with one piece of its text replaced.
inline std::string goodSceneWith(const std::string& from, const std::string& to)
{
  std::string text = GOOD_SCENE;
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    throw std::logic_error("the good scene does not hold: " + from);
  return text.replace(at, from.size(), to);
}

/// A scene with every key of its parts that is not at its default, as it is written.
inline const char* const EVERY_KEY =
    "base: {teeth: 3, tooth_width: 0.01, tooth_height: 0.002, asymmetry: 0.7, inclination: -0.2, amplitude: "
    "0.001, frequency: 30, phase: 1.5, wall_height: 0.3, horizontal_amplitude: -0.002, horizontal_phase: "
    "0.5, drive_frame: base, harmonics: [{multiple: 2, amplitude: -0.0001, phase: 1, horizontal_amplitude: "
    "0, horizontal_phase: 0}, {multiple: 5, amplitude: 0, phase: 0, horizontal_amplitude: 0.0002, "
    "horizontal_phase: -1}]}\n"
    "boundary: walled\n"
    "gravity: 1.62\n"
    "observe: [residence_times, mass_flow]\n"
    "species:\n"
    "  - {name: \"A\", count: 0, share: 2, radius: 0.0005, mass: 0.003, inertia_factor: 0.4, restitution: "
    "0.9, friction: 0.3, tangential_restitution: -0.5, size: {distribution: table, mass_exponent: 2, radii: "
    "[0.0005, 0.001], weights: [0, 2.5], by: mass}}\n"
    "  - {name: \"B\", count: 0, share: 1, radius: 0.002, mass: 0.01, inertia_factor: 0.5, restitution: "
    "0.6, friction: 0.1, tangential_restitution: 0.4, size: {distribution: normal, mass_exponent: 3, spread: "
    "0.1}}\n"
    "pairs:\n"
    "  - {species: [\"B\", \"A\"], restitution: 0.1, friction: 0.2, tangential_restitution: 0.3}\n"
    "contact: {pair_collisions: false, min_rebound_speed: 0.01, contact_duration: 0.0001, on_collapse: "
    "rebound, collapse_events: 5000, restitution_speed: 0.25, restitution_exponent: 0.7}\n"
    "pour: {drop_height: 0.05, speed: 0.5, from: 0.001, to: 0.002}\n"
    "feed: {rate: 3.5, even: true, from: 0.01, to: 0.03, on_choke: stop}\n"
    "initial:\n"
    "  - {species: \"B\", x: 0.01, y: 0.1, vx: 0, vy: -1, spin: 3}\n"
    "height_profile: {slice: 0.0005, phases: 4}\n"
    "duration: 7\n"
    "settle: 2\n"
    "seed: 18446744073709551615\n"
    "accuracy: {method: steps, step: 0.001, mean_vx: 0.01, quality: 0.02, confidence: 0.9}\n";

/// What a call is refused with; empty if it is not refused.
template <typename Call>
std::string refusalBy(const Call& call)
{
  try
  {
    call();
    return "";
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
}

/// What is said against a scene; empty if nothing is.
inline std::string refusalOf(const std::string& text)
{
  return refusalBy([&] { sceneFromText(text, "s.yaml"); });
}

}  // namespace ratchet_sieve
