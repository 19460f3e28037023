#pragma once

#include "conformance/Rig.h"

#include <string>
#include <vector>

namespace insonate::test {

/// A small frame in which some branch of the model counts.
struct CompactCase {
  std::string what;
  Probe probe;
  ImagingSettings settings;
  ScenePtr scene;
  Transform pose;
  PlaneDisplacement displacement;
  std::optional<Needle> needle = {};
};

/// Together they go through every line of the shaders; each takes milliseconds.
std::vector<CompactCase> compactCases();

}  // namespace insonate::test
