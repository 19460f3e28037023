#include "record/HeaderText.h"

#include <nlohmann/json.hpp>

namespace insonate::record {
namespace {

/// Raised when an older program could not read new recordings. Format 1 has neither settings nor tenting, format 2 does
/// not state which vein was punctured, format 3 has no chain, format 4 has no instruments of the line.
constexpr int kFormat = 5;
constexpr int kChainedSince = 4;
/// Value of "hands"; the hands of a header without "hands" are a person's.
constexpr const char* kScript = "script";

RecordedFor recordedForFrom(const nlohmann::json& json) {
  if (!json.contains("recordedFor")) return {};
  const auto& whose = json.at("recordedFor");
  return {whose.at("attempt"),           whose.at("person"), whose.at("curriculum"),
          whose.at("curriculumVersion"), whose.at("level"),  whose.at("nonce")};
}

HandKinds handKindsFrom(const nlohmann::json& json) {
  if (!json.contains("movedBy")) return {};
  return {json.at("movedBy").at("probe"), json.at("movedBy").at("needle")};
}

}  // namespace

std::string textOf(const AttemptHeader& header) {
  const ImageField& picture = header.picture;
  nlohmann::json json{{"format", kFormat},
                      {"software", header.software},
                      {"begun", header.begun},
                      {"procedure", header.procedure},
                      {"procedureVersion", header.procedureVersion},
                      {"caseName", header.caseName},
                      {"caseHash", header.caseHash},
                      {"settingsHash", header.settingsHash},
                      {"engine", header.engine},
                      {"settings", header.settings},
                      {"vessels", header.vessels},
                      {"picture",
                       {{"width_mm", picture.width_mm},
                        {"fanAngle_deg", picture.fanAngle_deg},
                        {"faceRadius_mm", picture.faceRadius_mm},
                        {"sliceHalf_mm", picture.sliceHalf_mm},
                        {"elevationFocus_mm", picture.elevationFocus_mm},
                        {"elevationDivergence", picture.elevationDivergence},
                        {"elevationDivergenceBehind", picture.elevationDivergenceBehind}}}};
  if (header.isScripted) json["hands"] = kScript;
  if (const RecordedFor& whose = header.recordedFor; whose != RecordedFor{})
    json["recordedFor"] = {{"attempt", whose.attempt},       {"person", whose.person},
                           {"curriculum", whose.curriculum}, {"curriculumVersion", whose.curriculumVersion},
                           {"level", whose.level},           {"nonce", whose.nonce}};
  if (header.hands != HandKinds{}) json["movedBy"] = {{"probe", header.hands.probe}, {"needle", header.hands.needle}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<HeaderRead> headerFrom(std::string_view text) {
  try {
    const auto json = nlohmann::json::parse(text);
    const int format = json.at("format");
    if (format < 1 || format > kFormat)
      return fail("it has format " + std::to_string(format) + " and this program reads up to " +
                  std::to_string(kFormat) + "; open it with the program that wrote it, " +
                  json.value("software", "a newer one") + ".");
    const auto& picture = json.at("picture");
    // Before November 2026 the slice thickness increased equally on both sides of the focus.
    const double divergence = picture.value("elevationDivergence", 0.0);
    return HeaderRead{
        {json.at("software"),
         json.at("begun"),
         json.at("procedure"),
         json.at("procedureVersion"),
         json.at("caseName"),
         json.at("caseHash"),
         json.at("settingsHash"),
         json.at("engine"),
         {picture.at("width_mm"), picture.at("fanAngle_deg"), picture.at("faceRadius_mm"), picture.at("sliceHalf_mm"),
          picture.value("elevationFocus_mm", 0.0), divergence, picture.value("elevationDivergenceBehind", divergence)},
         json.value("vessels", std::vector<std::string>{}),
         json.value("settings", ""),
         json.value("hands", "") == kScript,
         recordedForFrom(json),
         handKindsFrom(json)},
        format >= kChainedSince};
  } catch (const nlohmann::json::exception&) {
    return fail("its header is not one of a recording.");
  }
}

}  // namespace insonate::record
