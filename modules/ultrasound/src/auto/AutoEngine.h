#pragma once

#include <insonate/ultrasound/Engine.h>

#include <span>
#include <string>

namespace insonate {

/// An engine that could compute images, and how fast it was.
struct EngineCandidate {
  std::string name, device;
  double frame_ms = 0;
};

/// The fastest of at least one, and why it was taken.
struct EngineChoice {
  std::string name, why;
};
EngineChoice fastestOf(std::span<const EngineCandidate> candidates);

/// Chooses when it is first prepared: between the processor and a graphics card, by the time that a small frame takes.
/// A software renderer is no candidate. Measured once a process.
std::unique_ptr<Engine> makeAutoEngine();

}  // namespace insonate
