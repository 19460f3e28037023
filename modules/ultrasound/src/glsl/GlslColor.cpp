#include "color/ColorRegistry.h"
#include "glsl/CardColor.h"
#include "glsl/Device.h"

namespace insonate {
namespace {

class GlslColor final : public ColorDoppler {
 public:
  explicit GlslColor(std::shared_ptr<const glsl::Device> device) : device_(std::move(device)) {}

  std::string_view name() const override { return cpu_ ? "cpu" : "glsl"; }

  void prepare(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) override {
    probe_ = probe, settings_ = settings, color_ = color;
    card_.reset();
    if (cpu_) return cpu_->prepare(probe, settings, color);
    auto card = glsl::CardColor::make(device_, probe, settings, color);
    if (card)
      card_ = std::move(*card);
    else
      fallBack();
  }

  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const ColorMotion& motion, ColorFrame& frame) override {
    if (!cpu_) {
      if (card_->render(scene.impl(), patientFromProbe, displacement, motion, frame)) return;
      fallBack();
    }
    cpu_->render(scene, patientFromProbe, displacement, motion, frame);
  }

 private:
  /// If the card is lost, the engine states the reason. A failure of color alone is not stated.
  void fallBack() {
    card_.reset();
    cpu_ = makeCpuColor();
    cpu_->prepare(probe_, settings_, color_);
  }

  std::shared_ptr<const glsl::Device> device_;
  Probe probe_;
  ImagingSettings settings_;
  ColorSettings color_;
  std::unique_ptr<glsl::CardColor> card_;
  std::unique_ptr<ColorDoppler> cpu_;  ///< created after the card has failed
};

}  // namespace

std::unique_ptr<ColorDoppler> glsl::makeColorOn(std::shared_ptr<const Device> device) {
  return std::make_unique<GlslColor>(std::move(device));
}

Result<std::unique_ptr<ColorDoppler>> makeGlslColor() {
  auto device = glsl::Device::shared();
  if (!device) return tl::unexpected(device.error());
  return glsl::makeColorOn(std::move(*device));
}

}  // namespace insonate
