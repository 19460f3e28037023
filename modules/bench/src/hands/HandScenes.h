#pragma once

#include <insonate/camera/SimulatedCamera.h>
#include <insonate/core/Result.h>

#include <string>
#include <vector>

namespace insonate::bench {

/// A condition under which hands are tracked. The rendered objects may differ from the bodies that the tracker knows.
struct HandScene {
  std::string name;
  SimulatedSensor sensor;
  TagBody needle, probe;
  std::vector<SimulatedObject> objects;  ///< needle, then probe
};

/// Returns the conditions; the first one is at rest, the second one is the reference for the others.
Result<std::vector<HandScene>> handScenes();

}  // namespace insonate::bench
