#include <insonate/core/Words.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/tissue/TableText.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace insonate {
namespace {

using nlohmann::json;

template <class T>
struct Field {
  const char* name;
  double T::*member;
};

constexpr std::array kPhysiology{
    Field<Physiology>{"centralVenous_mmHg", &Physiology::centralVenous_mmHg},
    Field<Physiology>{"systolic_mmHg", &Physiology::systolic_mmHg},
    Field<Physiology>{"diastolic_mmHg", &Physiology::diastolic_mmHg},
    Field<Physiology>{"heartRate_perMin", &Physiology::heartRate_perMin},
    Field<Physiology>{"breathing_perMin", &Physiology::breathing_perMin},
    Field<Physiology>{"breathingSwing_mmHg", &Physiology::breathingSwing_mmHg},
    Field<Physiology>{"tilt_deg", &Physiology::tilt_deg},
    Field<Physiology>{"neckAboveHeart_mm", &Physiology::siteAboveHeart_mm},
    Field<Physiology>{"indifferenceFromHeart_mm", &Physiology::indifferenceFromHeart_mm},
};
constexpr const char* kLungSlide = "lungSlide_mm";

constexpr std::array kDeformation{
    Field<DeformationSettings>{"mesh_mm", &DeformationSettings::mesh_mm},
    Field<DeformationSettings>{"depth_mm", &DeformationSettings::depth_mm},
    Field<DeformationSettings>{"tolerance_mm", &DeformationSettings::tolerance_mm},
    Field<DeformationSettings>{"enough_mm", &DeformationSettings::movingTolerance_mm},
};

template <class T, std::size_t N>
json numbersOf(const T& from, const std::array<Field<T>, N>& fields) {
  json object = json::object();
  for (const Field<T>& field : fields) object[field.name] = from.*field.member;
  return object;
}

template <class T, std::size_t N>
void readNumbers(const json& object, const std::array<Field<T>, N>& fields, T& to) {
  for (const Field<T>& field : fields) to.*field.member = object.at(field.name);
}

json physiologyJson(const Physiology& physiology) {
  json object = numbersOf(physiology, kPhysiology);
  object[kLungSlide] = physiology.lungSlide_mm;
  return object;
}

json mechanicsJson(const TissueMechanics& mechanics) {
  json object = numbersOf(mechanics.settings, kDeformation);
  object.update({{"model", mechanics.model},
                 {"footprint_mm", mechanics.footprint_mm},
                 {"sticking", mechanics.sticking},
                 {"mostIterations", mechanics.settings.maxIterations},
                 {"tissues", json::parse(textOf(mechanics.tissues))}});
  return object;
}

Result<TissueMechanics> mechanicsFrom(const json& object) {
  TissueMechanics mechanics;
  mechanics.model = object.at("model");
  mechanics.footprint_mm = object.at("footprint_mm");
  mechanics.sticking = object.at("sticking");
  mechanics.settings.maxIterations = object.at("mostIterations");
  readNumbers(object, kDeformation, mechanics.settings);
  auto tissues = parseMechanicalTable(object.at("tissues").dump());
  if (!tissues) return tl::unexpected(tissues.error());
  mechanics.tissues = std::move(*tissues);
  if (auto ok = validate(mechanics); !ok) return tl::unexpected(ok.error());
  return mechanics;
}

/// Settings of recordings that were made before electronic noise and ringing existed.
ImagingSettings formerSettings(const Probe& probe) {
  ImagingSettings settings = settingsFor(probe);
  settings.effects.noise = settings.effects.nearField = false;
  settings.edgeEnhancement = settings.dynamicFilter = 0;
  return settings;
}

Result<ImagingSetup> setupFrom(const json& object) {
  auto probe = parseProbe(object.at("probe").dump());
  if (!probe) return tl::unexpected(probe.error());
  auto settings = settingsFromJson(object.at("picture"), formerSettings(*probe));
  if (!settings) return tl::unexpected(settings.error());
  if (auto ok = validate(*settings, *probe); !ok) return tl::unexpected(ok.error());
  auto tissues = parseAcousticTable(object.at("tissues").dump());
  if (!tissues) return tl::unexpected(tissues.error());
  auto mechanics = mechanicsFrom(object.at("mechanics"));
  if (!mechanics) return tl::unexpected(mechanics.error());
  std::optional<ColorSettings> color;
  if (const auto found = object.find("color"); found != object.end()) {
    auto read = colorFromJson(*found, colorSettingsFor(*probe, *settings));
    if (!read) return tl::unexpected(read.error());
    if (auto ok = validate(*read, *probe, *settings); !ok) return tl::unexpected(ok.error());
    color = *read;
  }
  return ImagingSetup{std::move(*probe),     *settings, std::move(*tissues), object.at("engine"),
                      std::move(*mechanics), color};
}

json jsonOf(const FlexibleRod& rod) {
  json nodes = json::array();
  for (const Vec3& node : rod.nodes_mm) nodes.insert(nodes.end(), {node.x, node.y, node.z});
  return {{"polymer", rod.material == RodMaterial::Polymer},
          {"radius_mm", rod.radius_mm},
          {"innerRadius_mm", rod.innerRadius_mm},
          {"nodes_mm", std::move(nodes)}};
}

Result<FlexibleRod> rodFrom(const json& object) {
  FlexibleRod rod;
  rod.material = object.at("polymer") ? RodMaterial::Polymer : RodMaterial::SteelCoil;
  rod.radius_mm = object.at("radius_mm"), rod.innerRadius_mm = object.at("innerRadius_mm");
  const json& nodes = object.at("nodes_mm");
  for (std::size_t i = 0; i + 2 < nodes.size(); i += 3)
    rod.nodes_mm.push_back({nodes.at(i), nodes.at(i + 1), nodes.at(i + 2)});
  if (auto ok = validate(rod); !ok) return tl::unexpected(ok.error());
  return rod;
}

json jsonOf(const SalineFlush& flush) {
  return {{"time_s", flush.time_s},
          {"isArtery", flush.wall == kArtery},
          {"from_mm", {flush.from_mm.x, flush.from_mm.y, flush.from_mm.z}}};
}

Result<SalineFlush> flushFrom(const json& object) {
  const json& from_mm = object.at("from_mm");
  const SalineFlush flush{
      object.at("time_s"), object.at("isArtery") ? kArtery : kVein, {from_mm.at(0), from_mm.at(1), from_mm.at(2)}};
  constexpr double kLongest_s = 1e6, kFarthest_mm = 1e4;
  if (!(std::abs(flush.time_s) <= kLongest_s && norm(flush.from_mm) <= kFarthest_mm))
    return fail("The flush must have a time of at most 1e6 s and a place within 10 m of the origin.");
  return flush;
}

constexpr std::array<const char*, 2> kLungs{"right_s", "left_s"};

Result<Pneumothorax> pneumothoraxFrom(const json& object) {
  Pneumothorax pneumothorax;
  constexpr double kLongest_s = 1e6;
  for (std::size_t side = 0; side < kLungs.size(); ++side) {
    if (!object.contains(kLungs[side])) continue;
    const double since_s = object.at(kLungs[side]);
    if (!(std::abs(since_s) <= kLongest_s)) return fail("A pneumothorax must begin within 1e6 s.");
    pneumothorax.since_s[side] = since_s;
  }
  return pneumothorax;
}

Result<AttemptSettings> settingsFrom(const json& object) {
  auto setup = setupFrom(object);
  if (!setup) return tl::unexpected(setup.error());
  AttemptSettings settings;
  settings.setup = std::move(*setup);
  const json& physiology = object.at("physiology");
  readNumbers(physiology, kPhysiology, settings.physiology);
  // The lung did not slide in earlier versions.
  settings.physiology.lungSlide_mm = physiology.value(kLungSlide, 0.0);
  if (auto ok = checkPhysiology(settings.physiology); !ok) return tl::unexpected(ok.error());
  settings.pulsating = object.at("pulsating");
  settings.bloodTime_s = object.at("bloodTime_s");
  const json& needle = object.at("needle");
  settings.needle = needle.at("name");
  settings.needleRadius_mm = needle.at("radius_mm"), settings.needleLength_mm = needle.at("length_mm");
  if (const auto found = object.find("flush"); found != object.end()) {
    auto flush = flushFrom(*found);
    if (!flush) return tl::unexpected(flush.error());
    settings.flush = *flush;
  }
  if (const auto found = object.find("pneumothorax"); found != object.end()) {
    auto pneumothorax = pneumothoraxFrom(*found);
    if (!pneumothorax) return tl::unexpected(pneumothorax.error());
    settings.pneumothorax = *pneumothorax;
  }
  if (!object.contains("rods")) return settings;
  const json& rods = object.at("rods");
  for (std::size_t i = 0; i < rods.size(); ++i) {
    auto rod = rodFrom(rods.at(i));
    if (!rod) return tl::unexpected(rod.error());
    settings.rods.push_back(std::move(*rod));
  }
  return settings;
}

}  // namespace

std::string textOf(const AttemptSettings& settings) {
  const ImagingSetup& setup = settings.setup;
  json object{
      {"probe", json::parse(textOf(setup.probe))},
      {"picture", jsonOf(setup.settings)},
      {"tissues", json::parse(textOf(setup.tissues))},
      {"engine", setup.engine},
      {"mechanics", mechanicsJson(setup.mechanics)},
      {"physiology", physiologyJson(settings.physiology)},
      {"pulsating", settings.pulsating},
      {"bloodTime_s", settings.bloodTime_s},
      {"needle",
       {{"name", settings.needle}, {"radius_mm", settings.needleRadius_mm}, {"length_mm", settings.needleLength_mm}}}};
  if (setup.color) object["color"] = jsonOf(*setup.color);
  if (settings.flush) object["flush"] = jsonOf(*settings.flush);
  for (std::size_t side = 0; side < kLungs.size(); ++side)
    if (const auto& since_s = settings.pneumothorax.since_s[side]) object["pneumothorax"][kLungs[side]] = *since_s;
  for (const FlexibleRod& rod : settings.rods) object["rods"].push_back(jsonOf(rod));
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<AttemptSettings> parseAttemptSettings(std::string_view text) {
  try {
    auto settings = settingsFrom(json::parse(text));
    if (!settings) return fail("The settings of the attempt cannot be used: " + settings.error().message);
    return settings;
  } catch (const json::exception& error) {
    return fail("The settings of the attempt cannot be read: " + readableJsonError(error.what()) + ".");
  }
}

}  // namespace insonate
