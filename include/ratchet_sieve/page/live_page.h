#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// A scene that a live page offers.
struct OfferedScene
{
  std::string name;      ///< in links
  std::string title;     ///< in a few words
  std::string sentence;  ///< what one sees; may be empty
  Scene scene;
};

/// Writes one HTML file that needs nothing else: the engine itself, which runs in the browser, and scenes to
/// choose from. @param engine the module of WebAssembly that is built from src/web @throws OutputError
void writeLivePage(const std::string& path, const std::vector<OfferedScene>& scenes,
                   const std::string& engine);

}  // namespace ratchet_sieve
