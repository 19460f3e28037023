#include "CasePlaces.h"

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
  return a.difficulty == b.difficulty && a.vessels == b.vessels && a.targets == b.targets &&
         a.startPoses == b.startPoses && a.landmarks == b.landmarks;
}

}  // namespace insonate::prepare
