#include "Checks.h"

#include <insonate/cases/Landmarks.h>
#include <insonate/cases/VesselName.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

namespace insonate::check {
namespace {

std::string nameOf(const Landmark& landmark) {
  if (!landmark.name.empty()) return landmark.name;
  const LandmarkKind* kind = landmarkKind(landmark.code);
  return kind ? std::string(kind->name) : landmark.code;
}

/// A place within this distance of the skin's outside counts as on the skin.
bool isOnSkin(const LabelMap& labels, Vec3 place_mm) {
  constexpr double kNear_mm = 5, kStep_mm = 1;
  const Transform index = labels.geometry.indexFromPatient();
  bool body = false, air = false;
  const int n = int(kNear_mm / kStep_mm);
  for (int k = -n; k <= n; ++k)
    for (int j = -n; j <= n; ++j)
      for (int i = -n; i <= n; ++i) {
        const Vec3 offset = kStep_mm * Vec3{double(i), double(j), double(k)};
        if (norm(offset) > kNear_mm) continue;
        (sampleNearest(labels, index * (place_mm + offset)) == kBackground ? air : body) = true;
      }
  return body && air;
}

/// Landmarks to which the procedures for the case's targets refer, by the beginnings of their codes.
std::vector<std::pair<std::string_view, std::string_view>> neededLandmarks(const std::vector<Target>& targets) {
  const auto isFor = [&](std::initializer_list<KnownVessel> vessels) {
    return std::ranges::any_of(targets, [&](const Target& target) {
      const auto vessel = parsedVesselName(target.name).vessel;
      return vessel && std::ranges::find(vessels, *vessel) != vessels.end();
    });
  };
  if (isFor({KnownVessel::Femoral, KnownVessel::Iliac}))
    return {{"puncture_site", "puncture site"}, {"pubic_tubercle", "pubic tubercle"}};
  if (isFor({KnownVessel::Basilic, KnownVessel::Brachial, KnownVessel::Cephalic, KnownVessel::Saphenous}))
    return {{"puncture_site", "puncture site"}};
  return {{"puncture_site", "puncture site"}, {"cricoid", "cricoid cartilage"}, {"clavicle", "clavicle"}};
}

void checkMissing(const CaseManifest& manifest, Findings& findings) {
  const std::vector<Landmark>& landmarks = manifest.landmarks;
  const auto has = [&](std::string_view code) {
    return std::ranges::any_of(landmarks, [&](const Landmark& l) { return l.code.starts_with(code); });
  };
  std::string missing;
  for (const auto& [code, name] : neededLandmarks(manifest.targets))
    if (!has(code)) missing += (missing.empty() ? "" : ", ") + std::string(name);
  if (!missing.empty())
    findings.push_back({FindingSeverity::kInfo, "landmarks_missing",
                        "These landmarks are not marked: " + missing +
                            ". Mark those that the scan shows, so that instructions can refer to them."});
}

}  // namespace

void checkLandmarks(const CaseView& patient, Findings& findings) {
  const std::vector<Landmark>& landmarks = patient.manifest.landmarks;
  checkMissing(patient.manifest, findings);
  for (const Landmark& landmark : landmarks) {
    const std::string what = "The landmark \"" + nameOf(landmark) + "\" at " + placeText(landmark.position_mm);
    const LandmarkKind* kind = landmarkKind(landmark.code);
    if (!inVolume(patient.labels.geometry, landmark.position_mm))
      findings.push_back({FindingSeverity::kWarning, "landmark_outside",
                          what + " lies outside the volume. Mark it again.", landmark.position_mm});
    else if (kind && kind->onSkin && !isOnSkin(patient.labels, landmark.position_mm))
      findings.push_back({FindingSeverity::kWarning, "landmark_off_skin", what + " is not on the skin. Mark it again.",
                          landmark.position_mm, kSkin});
  }
}

}  // namespace insonate::check
