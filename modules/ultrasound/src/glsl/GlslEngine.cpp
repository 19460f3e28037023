#include "glsl/GlslEngine.h"

#include "cpu/CpuEngine.h"
#include "glsl/CardFrame.h"
#include "glsl/Device.h"

namespace insonate {
namespace {

using namespace glsl;

class GlslEngine final : public Engine {
 public:
  explicit GlslEngine(std::shared_ptr<const Device> device) : device_(std::move(device)) {
    const auto& card = device_->context().device();
    note_ = card.software ? card.renderer + ", a software renderer" : card.renderer;
  }

  std::string_view name() const override { return cpu_ ? "cpu" : "glsl"; }

  std::string_view note() const override { return note_; }

  void prepare(const Probe& probe, const ImagingSettings& settings) override {
    probe_ = probe, settings_ = settings;
    frame_.reset();
    if (cpu_) return cpu_->prepare(probe, settings);
    auto frame = CardFrame::make(device_, probe, settings);
    if (!frame) return fallBack(frame.error().message);
    frame_ = std::move(*frame);
  }

  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Instruments& instruments, EnvelopeFrame& envelope) override {
    if (!cpu_) {
      const auto done = frame_->render(scene.impl(), patientFromProbe, displacement, instruments, envelope);
      if (done) return;
      fallBack(done.error().message);
    }
    cpu_->render(scene, patientFromProbe, displacement, instruments, envelope);
  }

  const std::vector<Stage>& stages() const override { return cpu_ ? cpu_->stages() : frame_->stages(); }

 private:
  void fallBack(const std::string& why) {
    note_ = "The cpu engine replaces glsl. " + why;
    frame_.reset();
    cpu_ = makeCpuEngine();
    cpu_->prepare(probe_, settings_);
  }

  std::shared_ptr<const Device> device_;
  Probe probe_;
  ImagingSettings settings_;
  std::unique_ptr<CardFrame> frame_;
  std::unique_ptr<Engine> cpu_;  ///< created after the card has failed
  std::string note_;
};

}  // namespace

std::unique_ptr<Engine> glsl::makeEngineOn(std::shared_ptr<const Device> device) {
  return std::make_unique<GlslEngine>(std::move(device));
}

Result<std::unique_ptr<Engine>> makeGlslEngine() {
  auto device = Device::shared();
  if (!device) return tl::unexpected(device.error());
  return glsl::makeEngineOn(std::move(*device));
}

}  // namespace insonate
