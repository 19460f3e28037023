#pragma once

#include <insonate/cases/PatientCase.h>

#include <string>
#include <vector>

namespace insonate::prepare {

/// What an author says about a case beside its voxels: what is punctured, what is found by name, where probes begin,
/// and how hard it is. Edited and taken back as a whole.
struct CasePlaces {
  std::vector<Target> targets;
  std::vector<StartPose> startPoses;
  std::vector<Landmark> landmarks;
  std::string difficulty;
};

CasePlaces placesOf(const CaseManifest& manifest);
void putPlaces(const CasePlaces& places, CaseManifest& manifest);
bool samePlaces(const CasePlaces& a, const CasePlaces& b);

}  // namespace insonate::prepare
