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

/// What is said against a scene; empty if nothing is.
inline std::string refusalOf(const std::string& text)
{
  try
  {
    sceneFromText(text, "s.yaml");
    return "";
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
}

}  // namespace ratchet_sieve
