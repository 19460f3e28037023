#pragma once

#include <insonate/ultrasound/Engine.h>

#include <span>
#include <string>

namespace insonate {

/// An engine that can compute images, with its measured time.
struct EngineCandidate {
  std::string name, device;
  double frame_ms = 0;
};

/// The engine that fastestOf() chose among the candidates, with the reason for the choice.
struct EngineChoice {
  std::string name, why;
};
EngineChoice fastestOf(std::span<const EngineCandidate> candidates);
/// Returns the choice for this process. The first call measures the engines.
const EngineChoice& automaticChoice();

/// Makes an engine that chooses, when first prepared, between the processor and a graphics card, by measuring the time
/// that each takes for a small frame. A software renderer is never chosen. The measurement is made once per process.
std::unique_ptr<Engine> makeAutoEngine();

}  // namespace insonate
