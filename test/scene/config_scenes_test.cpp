#include <filesystem>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

Scene configScene(const std::string& name)
{
  return loadSceneFile(std::string(CONFIG_DIRECTORY) + "/" + name);
}

TEST(ConfigScenes, AllLoadWithoutAWarning)
{
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CONFIG_DIRECTORY))
  {
    const std::string name = entry.path().filename();
    if (entry.is_directory() || name.find("_schedule") != std::string::npos || name == "materials.yaml")
      continue;
    SCOPED_TRACE(entry.path().filename());
    const Scene scene = loadSceneFile(entry.path().string());
    EXPECT_TRUE(scene.warnings.empty());
    ++count;
  }
  EXPECT_GE(count, 10u);
}

/// Their other key is the density, which gives the mass of a ball.
TEST(ConfigScenes, MaterialsAreCoefficientsOfASpecies)
{
  const YAML::Node materials = YAML::LoadFile(std::string(CONFIG_DIRECTORY) + "/materials.yaml");
  ASSERT_GE(materials.size(), 4u);
  for (const auto& material : materials)
  {
    SCOPED_TRACE(material.first.as<std::string>());
    std::vector<std::string> overrides;
    for (const char* key : {"restitution", "friction", "tangential_restitution"})
      overrides.push_back(std::string("species.0.") + key + "=" + material.second[key].as<std::string>());
    EXPECT_EQ(material.second.size(), overrides.size() + 1);
    constexpr double CUBIC_MILLIMETRE = 1e-9;
    const double mass = material.second["density"].as<double>() * CUBIC_MILLIMETRE * 4.0 / 3.0 * 3.14159265;
    overrides.push_back("species.0.mass=" + std::to_string(mass));
    const Scene scene = loadSceneFile(std::string(CONFIG_DIRECTORY) + "/demo.yaml", overrides);
    EXPECT_TRUE(scene.warnings.empty());
    const ContactCoefficients& contact = scene.definition.species[0].contact;
    EXPECT_EQ(contact.restitution, material.second["restitution"].as<double>());
    EXPECT_EQ(contact.friction, material.second["friction"].as<double>());
    EXPECT_EQ(contact.tangential_restitution, material.second["tangential_restitution"].as<double>());
  }
}

TEST(ConfigScenes, OfSingleParticlesAreEnsembles)
{
  for (const char* name : {"paper_fig3.yaml", "paper_fig4.yaml", "paper_fig5.yaml", "paper_fig7.yaml"})
    EXPECT_FALSE(configScene(name).definition.contact.pair_collisions) << name;
}

TEST(ConfigScenes, Figure4IsFigure3Tilted)
{
  SceneDefinition scene = configScene("paper_fig3.yaml").definition;
  scene.base.inclination = 0.209;
  EXPECT_EQ(sceneHash(scene), sceneHash(configScene("paper_fig4.yaml").definition));
}

TEST(ConfigScenes, Figure8HasItsDensity)
{
  const SceneDefinition scene = configScene("paper_fig8.yaml").definition;
  double diameters = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    diameters += species.count * 2.0 * species.radius;
  EXPECT_NEAR(diameters / scene.base.width(), 3.93, 0.01);
  EXPECT_EQ(scene.species[0].count, scene.species[1].count);
}

TEST(ConfigScenes, TheDemoIsFigure9OnAShortBaseAtItsStart)
{
  const SceneDefinition figure = configScene("paper_fig9.yaml").definition;
  SceneDefinition demo = configScene("demo.yaml").definition;
  EXPECT_EQ(demo.base.inclination, 0.0);
  EXPECT_LT(demo.base.teeth, figure.base.teeth);
  demo.base.inclination = figure.base.inclination;
  demo.base.teeth = figure.base.teeth;
  for (std::size_t i = 0; i < figure.species.size(); ++i)
    demo.species[i].count = figure.species[i].count;
  EXPECT_EQ(sceneHash(demo), sceneHash(figure));
}

}  // namespace
}  // namespace ratchet_sieve
