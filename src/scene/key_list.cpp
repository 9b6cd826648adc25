#include "ratchet_sieve/scene/key_list.h"

#include <type_traits>

#include "schema.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* REQUIRED = "required";

template <typename Part>
KeyText textOf(const Key<Part>& key, const std::string& group)
{
  Part plain{};
  const LegalValues legal = std::visit(
      [&key](auto* value) { return legalValues<std::remove_pointer_t<decltype(value)>>(key.range); },
      key.slot(plain));
  std::string default_text = key.default_text != nullptr ? key.default_text : valueText(key, plain);
  if (key.presence == Presence::REQUIRED)
    default_text = REQUIRED;
  return {group + key.name, legal.type, key.range.unit, legal.values, default_text, key.meaning};
}

template <typename... Parts>
KeyGroup groupOf(const std::string& name, const std::string& meaning, const Keys<Parts>&... tables)
{
  KeyGroup group{name, meaning, {}};
  const auto add = [&group, prefix = name.empty() ? "" : name + "."](const auto& keys)
  {
    for (const auto& key : keys)
      group.keys.push_back(textOf(key, prefix));
  };
  (add(tables), ...);
  return group;
}

/// With a first key that names one species or more.
KeyGroup withSpecies(KeyGroup group, const char* type, const char* values, const char* meaning)
{
  group.keys.insert(group.keys.begin(), {group.name + ".species", type, "", values, REQUIRED, meaning});
  return group;
}

/// Of pairs, whose coefficients have another default than the table's.
KeyGroup pairGroup()
{
  KeyGroup group =
      groupOf("pairs.N", "a list of coefficients for contacts between two species", COEFFICIENT_KEYS);
  for (KeyText& key : group.keys)
    key.default_text = "mean of both";
  return withSpecies(group, "list", "two names of species", "The two different species.");
}

}  // namespace

std::vector<KeyGroup> sceneKeyGroups()
{
  return {
      groupOf("", "the scene as a whole", MOTION_KEYS, DENSITY_KEYS, RUN_KEYS),
      groupOf("base", "the base, a sawtooth or a profile, and its drive", BASE_KEYS, LENGTH_KEYS),
      groupOf("base.harmonics.N", "a list of sines of multiples of the drive frequency, added to the drive",
              HARMONIC_KEYS),
      groupOf("species.N", "a list of one or more species", SPECIES_KEYS, SHARE_KEYS, MATERIAL_KEYS,
              COEFFICIENT_KEYS),
      groupOf("species.N.size", "the sizes of a species' disks, where they are not all equal", SIZE_KEYS,
              SPREAD_KEYS, TABLE_KEYS),
      pairGroup(),
      groupOf("contact", "the collision law, for all contacts", CONTACT_KEYS),
      groupOf("pour", "how the disks start: spread evenly along the base, without overlap", POUR_KEYS),
      groupOf("feed", "disks that are poured while the machine runs", FEED_KEYS, FEED_FILE_KEYS),
      withSpecies(
          groupOf("feed.disks.N", "a list of disks that are fed, in place of a rate; as feed.file gives it",
                  FED_KEYS),
          "name", "name of a species", "Species of the disk."),
      withSpecies(groupOf("initial.N", "a list of disks that are placed one by one, in place of the pour",
                          INITIAL_KEYS),
                  "name", "name of a species", "Species of the disk."),
      groupOf("height_profile", "what the observable of that name (see observe) divides into",
              HEIGHT_PROFILE_KEYS),
      groupOf("accuracy", "the method of simulation, and when a run may end early", METHOD_KEYS,
              CERTAINTY_KEYS),
  };
}

}  // namespace ratchet_sieve
