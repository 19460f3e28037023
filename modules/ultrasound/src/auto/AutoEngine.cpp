#include "auto/AutoEngine.h"

#include "cpu/CpuEngine.h"
#include "glsl/GlslEngine.h"

#include <insonate/gpu/Context.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

namespace insonate {
namespace {

/// A block of fat over muscle with a vessel, which uses every stage.
Result<std::shared_ptr<const AcousticScene>> trialScene(const AcousticTable& table) {
  VolumeGeometry grid;
  grid.size = {50, 16, 56}, grid.spacing_mm = {1, 1, 1}, grid.origin_mm = {-24.5, -7.5, -5.5};
  CtVolume ct(grid);
  LabelMap labels(grid);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const double x = i - 24.5, z = k - 5.5;
        labels.at(i, j, k) = z < 0 ? kBackground : z < 6 ? kFat : std::hypot(x, z - 18) < 6 ? kVein : kMuscle;
      }
  return AcousticScene::make(ct, labels, table, {{-40, -20, -20}, {40, 20, 60}});
}

/// Minimum time of a frame of the default linear probe, ms. A card that was idle has a low clock, and needs the time of
/// several frames to raise it.
double timeOf(Engine& engine, const Probe& probe, const AcousticScene& scene) {
  constexpr int kFrames = 5;
  constexpr double kLeast_ms = 100;
  engine.prepare(probe, settingsFor(probe));
  EnvelopeFrame frame;
  double min_ms = HUGE_VAL, spent_ms = 0;
  for (int i = 0; i < kFrames || spent_ms < kLeast_ms; ++i) {
    const auto start = std::chrono::steady_clock::now();
    engine.render(scene, {}, frame);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    min_ms = std::min(min_ms, time.count()), spent_ms += time.count();
  }
  return min_ms;
}

std::string tenths(double ms) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", ms);
  return text;
}

EngineChoice choose() {
  const auto onProcessor = [](const std::string& why) { return EngineChoice{"cpu", why}; };
  if (const auto card = gpu::Context::make({.hardware = true}); !card) return onProcessor(card.error().message);
  auto glsl = makeGlslEngine();
  if (!glsl) return onProcessor(glsl.error().message);
  const auto probe = loadProbe("linear");
  const auto table = loadAcousticTable("neck");
  if (!probe || !table) return onProcessor((probe ? table.error() : probe.error()).message);
  const auto scene = trialScene(*table);
  if (!scene) return onProcessor(scene.error().message);
  const auto cpu = makeCpuEngine();
  const std::string device((*glsl)->note());
  const std::vector<EngineCandidate> candidates{{"cpu", "the processor", timeOf(*cpu, *probe, **scene)},
                                                {"glsl", device, timeOf(**glsl, *probe, **scene)}};
  if ((*glsl)->name() != "glsl") return onProcessor(std::string((*glsl)->note()));
  return fastestOf(candidates);
}

class AutoEngine final : public Engine {
 public:
  std::string_view name() const override { return engine_ ? engine_->name() : "auto"; }
  /// The engine's own note if it has switched to another engine than the chosen one.
  std::string_view note() const override { return engine_ && engine_->name() != chosen_ ? engine_->note() : why_; }

  void prepare(const Probe& probe, const ImagingSettings& settings) override {
    if (!engine_) take();
    engine_->prepare(probe, settings);
  }
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Instruments& instruments, EnvelopeFrame& envelope) override {
    engine_->render(scene, patientFromProbe, displacement, instruments, envelope);
  }
  const std::vector<Stage>& stages() const override { return engine_->stages(); }

 private:
  void take() {
    chosen_ = automaticChoice().name, why_ = automaticChoice().why;
    auto engine = makeEngine(chosen_);
    if (engine) {
      engine_ = std::move(*engine);
    } else {
      engine_ = makeCpuEngine();
      chosen_ = "cpu", why_ = engine.error().message;
    }
  }

  std::unique_ptr<Engine> engine_;
  std::string chosen_, why_;
};

}  // namespace

EngineChoice fastestOf(std::span<const EngineCandidate> candidates) {
  const auto best = std::ranges::min_element(candidates, {}, &EngineCandidate::frame_ms);
  std::string why = "A frame takes " + tenths(best->frame_ms) + " ms on " + best->device;
  for (const EngineCandidate& other : candidates)
    if (&other != &*best) why += ", " + tenths(other.frame_ms) + " ms on " + other.device;
  return {best->name, why + "."};
}

const EngineChoice& automaticChoice() {
  static const EngineChoice choice = choose();
  return choice;
}

std::unique_ptr<Engine> makeAutoEngine() {
  return std::make_unique<AutoEngine>();
}

}  // namespace insonate
