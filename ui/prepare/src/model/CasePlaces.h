#pragma once

#include <insonate/cases/PatientCase.h>

#include <string>
#include <vector>

namespace insonate::prepare {

/// The author's data about a case besides its voxels: targets, names of vessels, landmarks, start poses and grade. All
/// these data are edited and undone together.
struct CasePlaces {
  std::vector<Target> targets;
  std::vector<NamedVessel> vessels;
  std::vector<StartPose> startPoses;
  std::vector<Landmark> landmarks;
  std::string difficulty;
};

CasePlaces placesOf(const CaseManifest& manifest);
void putPlaces(const CasePlaces& places, CaseManifest& manifest);
bool samePlaces(const CasePlaces& a, const CasePlaces& b);

}  // namespace insonate::prepare
