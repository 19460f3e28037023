#include "CasePlaces.h"

#include <algorithm>

namespace insonate::prepare {

CasePlaces placesOf(const CaseManifest& manifest) {
  return {manifest.targets, manifest.vessels, manifest.startPoses, manifest.landmarks, manifest.difficulty};
}

void putPlaces(const CasePlaces& places, CaseManifest& manifest) {
  manifest.targets = places.targets, manifest.vessels = places.vessels;
  manifest.startPoses = places.startPoses, manifest.landmarks = places.landmarks;
  manifest.difficulty = places.difficulty;
}

bool samePlaces(const CasePlaces& a, const CasePlaces& b) {
  const auto sameTarget = [](const Target& x, const Target& y) {
    return x.name == y.name && x.label == y.label && x.position_mm == y.position_mm;
  };
  const auto samePose = [](const StartPose& x, const StartPose& y) {
    return x.name == y.name && x.position_mm == y.position_mm && x.axial == y.axial && x.lateral == y.lateral;
  };
  const auto sameLandmark = [](const Landmark& x, const Landmark& y) {
    return x.code == y.code && x.name == y.name && x.position_mm == y.position_mm;
  };
  return a.difficulty == b.difficulty && a.vessels == b.vessels &&
         std::ranges::equal(a.targets, b.targets, sameTarget) &&
         std::ranges::equal(a.startPoses, b.startPoses, samePose) &&
         std::ranges::equal(a.landmarks, b.landmarks, sameLandmark);
}

}  // namespace insonate::prepare
