#include "FourSlices.h"

#include <insonate/simulator/Imager.h>
#include <insonate/ui/ViewWidget.h>

#include <QGridLayout>

namespace insonate::train {
namespace {

struct Kind {
  views::SliceKind kind;
  const char* name;
};
/// By rows.
constexpr Kind kKinds[FourSlices::kCount] = {{views::SliceKind::Oblique, "CT in the image plane"},
                                             {views::SliceKind::Axial, "Axial CT slice"},
                                             {views::SliceKind::Coronal, "Coronal CT slice"},
                                             {views::SliceKind::Sagittal, "Sagittal CT slice"}};

}  // namespace

FourSlices::FourSlices(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("fourSlices"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(0);
  for (std::size_t n = 0; n < kCount; ++n) {
    slices_[n] = std::make_shared<views::MprView>(kKinds[n].kind);
    slices_[n]->setLabelOpacity(0);
    slices_[n]->setCrosshairMoved([this](Vec3 position_mm) { setCrosshair(position_mm); });
    widgets_[n] = new ui::ViewWidget(slices_[n], tr(kKinds[n].name), this);
    grid->addWidget(widgets_[n], int(n) / 2, int(n) % 2);
  }
}

FourSlices::~FourSlices() = default;

void FourSlices::setCase(const std::shared_ptr<views::VtkCase>& patient) {
  shape_ = nullptr;
  pose_.reset();
  for (std::size_t n = 0; n < kCount; ++n) {
    slices_[n]->setCase(patient);
    slices_[n]->setFan(std::nullopt);
    widgets_[n]->forget();
  }
}

void FourSlices::setCrosshair(Vec3 position_mm) {
  for (const auto& slice : slices_) slice->setCrosshair(position_mm);
}

void FourSlices::follow(const std::shared_ptr<const ImagingSetup>& setup, const Transform& patientFromProbe) {
  if (setup != shape_) {
    shape_ = setup;
    slices_[0]->setFan(setup->probe, setup->settings);
  }
  if (pose_ == patientFromProbe) return;
  pose_ = patientFromProbe;
  slices_[0]->setProbePose(patientFromProbe);
  setCrosshair(patientFromProbe * Vec3{0, 0, setup->settings.depth_mm / 2});
}

void FourSlices::setPaths(const std::vector<views::ScenePath>& paths) {
  for (const auto& slice : slices_) slice->setToolMarks({.points_mm = {}, .line_mm = {}, .brush = {}, .paths = paths});
}

void FourSlices::setWindowLevel(views::WindowLevel value) {
  for (const auto& slice : slices_) slice->setWindowLevel(value);
}

void FourSlices::setWindowChanged(const std::function<void(views::WindowLevel)>& listener) {
  for (const auto& slice : slices_) slice->setWindowLevelChanged(listener);
}

void FourSlices::setLabelOpacity(double opacity) {
  for (const auto& slice : slices_) slice->setLabelOpacity(opacity);
}

void FourSlices::setLabelColor(std::uint8_t label, views::Color color) {
  for (const auto& slice : slices_) slice->setLabelColor(label, color);
}

double FourSlices::renderTime_s() const {
  double sum_s = 0;
  for (const auto& slice : slices_) sum_s += slice->renderer()->GetLastRenderTimeInSeconds();
  return sum_s;
}

}  // namespace insonate::train
