#include <insonate/core/Words.h>
#include <insonate/embedded/machines.h>
#include <insonate/ultrasound/Machine.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace insonate {
namespace {

using Json = nlohmann::json;

/// The presets come with the program; a test reads all of them.
const Json& presetOf(std::string_view machine) {
  static const Json all = [] {
    Json object = Json::object();
    for (const auto& file : embedded::machines::files()) object[std::string(file.name)] = Json::parse(file.text);
    return object;
  }();
  static const Json none;
  const auto found = all.find(machine);
  return found == all.end() ? none : *found;
}

/// Values of settings that have sources.
void addValues(const Json& sourced, Json& overrides) {
  for (const auto& [key, entry] : sourced.items()) overrides[key] = entry.at("value");
}

}  // namespace

const std::vector<Machine>& machines() {
  static const std::vector<Machine> all = [] {
    std::vector<Machine> list;
    for (const auto& file : embedded::machines::files()) {
      const Json& json = presetOf(file.name);
      list.push_back({json.at("name"), json.at("title"), json.at("about")});
    }
    return list;
  }();
  return all;
}

Result<ImagingSettings> settingsOf(std::string_view machine, const Probe& probe, ImagingSettings base) {
  const Json& json = presetOf(machine);
  if (json.is_null()) {
    std::vector<std::string_view> names;
    for (const Machine& known : machines()) names.push_back(known.name);
    return fail("there is no machine named '" + std::string(machine) + "'; machines are " + joinedWords(names) + ".");
  }
  Json overrides = Json::object();
  addValues(json.at("settings"), overrides);
  if (const auto own = json.find(nameOf(probe.shape)); own != json.end()) addValues(*own, overrides);
  auto settings = settingsFromJson(overrides, base);
  if (!settings) return fail("machine " + std::string(machine) + ": " + settings.error().message);
  settings->frequency_MHz = std::clamp(settings->frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  return settings;
}

const Machine* machineOf(const ImagingSettings& settings, const Probe& probe) {
  const auto found = std::ranges::find_if(machines(), [&](const Machine& machine) {
    const auto own = settingsOf(machine.name, probe, settings);
    return own && jsonOf(*own) == jsonOf(settings);
  });
  return found == machines().end() ? nullptr : &*found;
}

}  // namespace insonate
