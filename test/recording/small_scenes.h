#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Two species on a base with open ends; some disks fall into the bins within a second or two.
inline SceneDefinition smallMixture()
{
  SceneDefinition scene;
  scene.base.teeth = 4;
  scene.base.asymmetry = 0.1;
  scene.boundary = Boundary::OPEN;
  scene.species.resize(2);
  scene.species[0].name = "A";
  scene.species[0].count = 6;
  scene.species[0].mass = 0.010;
  scene.species[1].name = "B";
  scene.species[1].count = 6;
  scene.species[1].radius = 0.003;
  scene.duration = 2.0;
  return scene;
}

/// Four disks on a ring.
inline SceneDefinition smallRing()
{
  SceneDefinition scene = smallMixture();
  scene.boundary = Boundary::PERIODIC;
  scene.species[0].count = 2;
  scene.species[1].count = 2;
  scene.duration = 1.0;
  return scene;
}

/// An empty directory for one test, removed at its end.
class ScratchDirectory
{
public:
  ScratchDirectory()
  {
    std::string path = (std::filesystem::temp_directory_path() / "ratchet_sieve_XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr)
      throw std::runtime_error("no scratch directory");
    path_ = path;
  }
  ~ScratchDirectory() { std::filesystem::remove_all(path_); }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  bool empty() const { return std::filesystem::is_empty(path_); }

private:
  std::filesystem::path path_;
};

inline std::string contents(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A tooth to either side of the chute, 0.9 g: nothing leaves before the heap has reached the ends.
inline SceneDefinition chokedFeeder()
{
  SceneDefinition scene = smallMixture();
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
  scene.base.frequency = 10.6;
  scene.feed.rate = 60.0;
  scene.feed.stretch = {0.035, 0.045};
  scene.duration = 30.0;
  return scene;
}

}  // namespace ratchet_sieve
