#include "EyeControls.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

struct Mode {
  views::Stereo stereo;
  const char* name;
  const char* says;
};
constexpr Mode kModes[] = {
    {views::Stereo::Off, "off", "One image for both eyes"},
    {views::Stereo::Anaglyph, "red-cyan glasses", "Red left, cyan right"},
    {views::Stereo::SideBySide, "side by side", "For 3D televisions and headsets, and for viewing with crossed eyes"},
    {views::Stereo::Interlaced, "interlaced", "For screens with polarized rows"},
    {views::Stereo::Checkerboard, "checkerboard", "For projectors that show a checkerboard"},
    {views::Stereo::LeftEye, "left eye", "Only the image of the left eye"},
    {views::Stereo::RightEye, "right eye", "Only the image of the right eye"},
    {views::Stereo::QuadBuffer, "shutter glasses", "For graphics cards with quad-buffered stereo"},
};

}  // namespace

EyeControls::EyeControls(std::shared_ptr<views::SceneView> scene, QWidget* parent)
    : QWidget(parent),
      scene_(std::move(scene)),
      stereo_(new QComboBox),
      coupled_(new QCheckBox(tr("head-coupled view"))),
      numbers_(new QWidget),
      right_(new ValueSlider(
          tr("eye offset to the right"), tr("mm"), {-600, 600, 0, 10, 0},
          tr("Distance of your eyes from the middle of this view toward the right; negative: toward the left"))),
      up_(new ValueSlider(tr("eye height above middle"), tr("mm"), {-600, 600, 0, 10, 0},
                          tr("Height of your eyes above the middle of this view; negative: below"))),
      distance_(new ValueSlider(tr("distance to screen"), tr("mm"), {100, 3000, 600, 10, 0},
                                tr("Distance from the screen to the point midway between your eyes"))),
      width_(new ValueSlider(tr("width of this view"), tr("mm"), {40, 4000, 520, 10, 0},
                             tr("Width of this view, measured with a ruler on the screen"))),
      separation_(new ValueSlider(tr("eye separation"), tr("mm"), {0, 80, 63, 1, 0},
                                  tr("Distance between your eyes; used only in stereo"))) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSmallGap);
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(tr("stereo"));
  setRole(name, "quiet");
  stereo_->setObjectName(QStringLiteral("stereo"));
  stereo_->setAccessibleName(tr("Stereo"));
  stereo_->setToolTip(tr("Shows each eye its own image"));
  stereo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  stereo_->setMinimumContentsLength(8);
  row->addWidget(name);
  row->addWidget(stereo_, 1);
  box->addLayout(row);
  coupled_->setObjectName(QStringLiteral("headCoupled"));
  coupled_->setToolTip(tr("Renders the view as seen from the position of your eyes"));
  box->addWidget(coupled_);
  box->addWidget(numbers_);
  auto* list = new QVBoxLayout(numbers_);
  list->setContentsMargins(kLargeGap, 0, 0, 0);
  list->setSpacing(kSmallGap);
  const struct {
    ValueSlider* slider;
    const char* object;
  } sliders[] = {{right_, "eyeRight"},
                 {up_, "eyeUp"},
                 {distance_, "eyeDistance"},
                 {width_, "eyeWidth"},
                 {separation_, "eyeSeparation"}};
  for (const auto& [slider, object] : sliders) {
    slider->setObjectName(QLatin1String(object));
    list->addWidget(slider);
    connect(slider, &ValueSlider::valueChanged, this, &EyeControls::apply);
  }
  connect(stereo_, qOverload<int>(&QComboBox::activated), this, &EyeControls::apply);
  connect(coupled_, &QCheckBox::clicked, this, &EyeControls::apply);
  refresh();
}

void EyeControls::refresh() {
  refreshing_ = true;
  stereo_->clear();
  for (const Mode& mode : kModes) {
    if (!scene_->supports(mode.stereo)) continue;
    stereo_->addItem(tr(mode.name), int(mode.stereo));
    stereo_->setItemData(stereo_->count() - 1, tr(mode.says), Qt::ToolTipRole);
  }
  stereo_->setCurrentIndex(stereo_->findData(int(scene_->stereo())));
  const auto& coupling = scene_->headCoupling();
  coupled_->setChecked(coupling.has_value());
  numbers_->setVisible(coupling.has_value());
  if (coupling) {
    right_->setValue(coupling->eye_mm.x);
    up_->setValue(coupling->eye_mm.y);
    distance_->setValue(coupling->eye_mm.z);
    width_->setValue(coupling->width_mm);
    separation_->setValue(coupling->eyeSeparation_mm);
  }
  separation_->setVisible(scene_->stereo() != views::Stereo::Off);
  refreshing_ = false;
}

void EyeControls::apply() {
  if (refreshing_) return;
  scene_->setStereo(views::Stereo(stereo_->currentData().toInt()));
  if (coupled_->isChecked()) {
    views::HeadCoupling coupling = scene_->headCoupling().value_or(views::HeadCoupling{});
    coupling.width_mm = width_->value();
    coupling.eye_mm = {right_->value(), up_->value(), distance_->value()};
    coupling.eyeSeparation_mm = separation_->value();
    scene_->setHeadCoupling(coupling);
  } else {
    scene_->setHeadCoupling(std::nullopt);
  }
  refresh();
  Q_EMIT changed();
}

void EyeControls::save(QSettings& settings) const {
  for (const ValueSlider* slider : {right_, up_, distance_, width_, separation_})
    settings.setValue(slider->objectName(), slider->value());
}

void EyeControls::restore(QSettings& settings) {
  refreshing_ = true;
  for (ValueSlider* slider : {right_, up_, distance_, width_, separation_})
    slider->setValue(settings.value(slider->objectName(), slider->value()).toDouble());
  refreshing_ = false;
}

}  // namespace insonate::ui
