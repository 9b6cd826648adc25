#include "ratchet_sieve/scene/key_list.h"

#include <utility>

#include "schema.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* REQUIRED = "required";
constexpr const char* OF_BOTH = "mean of both";

template <typename Part>
KeyText textOf(const Key<Part>& key, const std::string& group)
{
  Part plain{};
  const LegalValues legal =
      std::visit([&key](const auto* value) { return legalValues(key.range, *value); }, key.slot(plain));
  std::string default_text = key.default_text != nullptr ? key.default_text : valueText(key, plain);
  if (key.presence == Presence::REQUIRED)
    default_text = REQUIRED;
  return {group + key.name, legal.type, key.range.unit, legal.values, default_text, key.meaning};
}

/// Collects the keys of one part.
class GroupBuilder
{
public:
  GroupBuilder(std::string name, std::string meaning) : group_{std::move(name), std::move(meaning), {}} {}

  template <typename Part>
  GroupBuilder& add(const Keys<Part>& keys)
  {
    for (const Key<Part>& key : keys)
      group_.keys.push_back(textOf(key, group_.name.empty() ? "" : group_.name + "."));
    return *this;
  }

  /// A key that names one species or more.
  GroupBuilder& addSpecies(const char* type, const char* values, const char* meaning)
  {
    group_.keys.push_back({group_.name + ".species", type, "", values, REQUIRED, meaning});
    return *this;
  }

  /// Of coefficients whose default is not the table's.
  GroupBuilder& defaultTo(const char* default_text)
  {
    for (KeyText& key : group_.keys)
      if (key.default_text != REQUIRED)
        key.default_text = default_text;
    return *this;
  }

  operator KeyGroup() const { return group_; }

private:
  KeyGroup group_;
};

}  // namespace

std::vector<KeyGroup> sceneKeyGroups()
{
  using Group = GroupBuilder;
  return {
      Group("", "the scene as a whole").add(motionKeys()).add(densityKeys()).add(runKeys()),
      Group("base", "the base, a sawtooth or a profile, and its drive").add(baseKeys()),
      Group("base.harmonics.N", "a list of sines of multiples of the drive frequency, added to the drive")
          .add(harmonicKeys()),
      Group("species.N", "a list of one or more kinds of disks")
          .add(speciesKeys())
          .add(materialKeys())
          .add(coefficientKeys()),
      Group("species.N.size", "the sizes of a species' disks, where they are not all equal")
          .add(sizeKeys())
          .add(spreadKeys())
          .add(tableKeys()),
      Group("pairs.N", "a list of coefficients for contacts between two species")
          .addSpecies("list", "two names of species", "The two different species.")
          .add(coefficientKeys())
          .defaultTo(OF_BOTH),
      Group("contact", "the collision law, for all contacts").add(contactKeys()),
      Group("pour", "how the disks start: spread evenly along the base, without overlap").add(pourKeys()),
      Group("feed", "disks that are poured while the machine runs").add(feedKeys()),
      Group("initial.N", "a list of disks that are placed one by one, in place of the pour")
          .addSpecies("name", "name of a species", "Species of the disk.")
          .add(initialKeys()),
      Group("height_profile", "what the observable of that name (see observe) divides into")
          .add(heightProfileKeys()),
      Group("accuracy", "the method of simulation, and when a run may end early")
          .add(methodKeys())
          .add(certaintyKeys()),
  };
}

}  // namespace ratchet_sieve
