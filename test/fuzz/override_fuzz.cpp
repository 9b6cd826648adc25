#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "findings.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* SCENE = R"(
base: {teeth: 4, inclination: 0.1}
species:
  - {name: A, count: 1, radius: 0.001, mass: 0.010}
  - {name: B, count: 1, radius: 0.002, mass: 0.001}
pairs: [{species: [A, B], restitution: 0.5}]
duration: 1.0
)";

void applyAll(const std::string& assignments)
{
  YAML::Node root = YAML::Load(SCENE);
  std::istringstream lines(assignments);
  try
  {
    for (std::string line; std::getline(lines, line, '\0');)
      applyOverride(root, line);
    sceneFromYaml(root, "scene.yaml");
  }
  catch (const SceneError& error)
  {
    requireOneLine(error.what());
  }
}

}  // namespace
}  // namespace ratchet_sieve

/// Arguments of `--set`, separated by zero bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  ratchet_sieve::applyAll(std::string(bytes, bytes + size));
  return 0;
}
