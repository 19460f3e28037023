#include "ColorControls.h"

#include "../feature/CommandWords.h"
#include "../model/ImagingModel.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ultrasound/PointSpread.h>

#include <QCheckBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr double kMmpsPerCmps = 10;

/// PRF at which velocities alias above `velocity_mmps`.
double prfFor_Hz(double velocity_mmps, const ColorSettings& color) {
  return velocity_mmps * 4 * color.frequency_MHz / kSoundSpeed_mmPerUs;
}

}  // namespace

ColorControls::ColorControls(ImagingModel& imaging, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent), imaging_(imaging) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(ui::heading(tr("Color Doppler")));
  on_ = box("color", tr("color"),
            tr("Shows the velocity of blood as colors over the image (%1). Drag the border of the box to move it, a "
               "corner to resize it")
                .arg(keysOf(commands, "train.doppler.color")));
  scale_ = slider("colorScale", tr("scale"), tr("cm/s"), tr("velocity above which colors alias"));
  gain_ = slider("colorGain", tr("color gain"), tr("dB"), tr("a higher gain shows weaker flow, and noise"));
  steering_ = slider("colorSteering", tr("color steering"), QStringLiteral("°"),
                     tr("tilts the color box of a linear probe; flow at a right angle to the beam has no color"));
  wallFilter_ = slider("wallFilter", tr("wall filter"), tr("Hz"), tr("suppresses slow flow and moving tissue"));
  invert_ = box("colorInvert", tr("invert"), tr("Exchanges red and blue"));
  power_ = box("colorPower", tr("power"), tr("Shows the power of the moving echoes instead of their velocity"));
  for (QWidget* widget : std::initializer_list<QWidget*>{on_, scale_, gain_, steering_, wallFilter_, invert_, power_})
    column->addWidget(widget);
  connect(&imaging_, &ImagingModel::setupChanged, this, [this] { refresh(); });
  refresh();
}

QCheckBox* ColorControls::box(const char* object, const QString& text, const QString& toolTip) {
  auto* box = new QCheckBox(text, this);
  box->setObjectName(QLatin1String(object));
  box->setToolTip(toolTip);
  connect(box, &QCheckBox::clicked, this, [this] { apply(); });
  return box;
}

ui::ValueSlider* ColorControls::slider(const char* object, const QString& name, const QString& unit,
                                       const QString& hint) {
  auto* slider = new ui::ValueSlider(name, unit, {}, hint, this);
  slider->setObjectName(QLatin1String(object));
  connect(slider, &ui::ValueSlider::valueChanged, this, [this] { apply(); });
  return slider;
}

void ColorControls::apply() {
  if (refreshing_) return;
  ColorSettings color = imaging_.color();
  // The sliders round; a value that the user did not change keeps its exact number.
  if (scale_->value() != shownScale_cmps_) color.prf_Hz = prfFor_Hz(scale_->value() * kMmpsPerCmps, color);
  if (wallFilter_->value() != shownFilter_Hz_) color.wallFilter_Hz = wallFilter_->value();
  color.gain_dB = gain_->value(), color.steering_deg = steering_->value();
  color.invert = invert_->isChecked();
  color.mode = power_->isChecked() ? ColorMode::Power : ColorMode::Velocity;
  imaging_.setColor(on_->isChecked(), color);
}

void ColorControls::refresh() {
  refreshing_ = true;
  const ColorSettings color = fitted(imaging_.color(), imaging_.probe(), imaging_.settings());
  const ColorSettings usual = colorSettingsFor(imaging_.probe(), imaging_.settings());
  ColorSettings fastest = color;
  fastest.prf_Hz = 20000;
  fastest = fitted(fastest, imaging_.probe(), imaging_.settings());
  const double highest_cmps = std::floor(nyquistVelocity_mmps(fastest) / kMmpsPerCmps);
  const bool linear = imaging_.probe().shape == ProbeShape::Linear;
  scale_->setRange(
      {3, highest_cmps, std::clamp(std::round(nyquistVelocity_mmps(usual) / kMmpsPerCmps), 3.0, highest_cmps), 1, 0});
  gain_->setRange({-30, 30, 0, 1, 0});
  steering_->setRange({-20, 20, 0, 1, 0});
  wallFilter_->setRange(
      {0, std::floor(color.prf_Hz / 2), std::min(usual.wallFilter_Hz, std::floor(color.prf_Hz / 2)), 10, 0});
  scale_->setValue(nyquistVelocity_mmps(color) / kMmpsPerCmps);
  gain_->setValue(color.gain_dB), steering_->setValue(color.steering_deg), wallFilter_->setValue(color.wallFilter_Hz);
  shownScale_cmps_ = scale_->value(), shownFilter_Hz_ = wallFilter_->value();
  on_->setChecked(imaging_.isColorOn());
  invert_->setChecked(color.invert), power_->setChecked(color.mode == ColorMode::Power);
  for (QWidget* widget : std::initializer_list<QWidget*>{scale_, gain_, wallFilter_, invert_, power_})
    widget->setVisible(imaging_.isColorOn());
  steering_->setVisible(imaging_.isColorOn() && linear);
  refreshing_ = false;
}

}  // namespace insonate::train
