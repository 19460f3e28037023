#pragma once

#include "conformance/Rig.h"

#include <insonate/ultrasound/ColorDoppler.h>

#include <string>
#include <vector>

namespace insonate::test {

/// A small frame of color Doppler in which some branch of the model counts.
struct CompactColor {
  std::string what;
  Probe probe;
  ImagingSettings settings;
  ColorSettings color;
  ScenePtr scene;
  Transform pose;
  PlaneDisplacement displacement;
  BloodFlow flow;
  Vec3 tissue_mmps{};

  ColorMotion motion() const { return {.blood = &flow, .tissue_mmps = tissue_mmps}; }
};

/// Together they go through every line of the shaders of color; each takes milliseconds.
std::vector<CompactColor> compactColors();

ColorFrame colorWith(ColorDoppler& doppler, const CompactColor& c);
/// Difference between two frames of the same box, as a share of the truth's RMS; 1 if a number is missing.
double colorErrorOf(const ColorFrame& frame, const ColorFrame& truth);

}  // namespace insonate::test
