#include "TissueShown.h"

#include "../model/CaseModel.h"
#include "../model/Disclosure.h"
#include "../model/LiveModel.h"
#include "../model/StatusLine.h"
#include "AreaPlot.h"
#include "TissueStrip.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QPushButton>
#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kShownKeys[TissueStrip::kShows] = {"tissueGrid", "tissuePressure", "tissueCurve"};

}  // namespace

TissueShown::TissueShown(StatusLine& status, DisclosureModel& disclosure, CaseModel& patientCase, LiveModel& live,
                         views::UltrasoundView& image, ui::Commands& commands, QWidget* column)
    : QObject(column),
      status_(status),
      disclosure_(disclosure),
      patientCase_(patientCase),
      live_(live),
      image_(image),
      strip_(new TissueStrip(disclosure_, patientCase_, live_, commands, column)) {
  curve_ = buildCurve(column);
  connect(strip_, &TissueStrip::shownChanged, this, [this] { choose(); });
  connect(&live_, &LiveModel::pictureShown, this, [this] { showPicture(); });
  connect(&disclosure_, &DisclosureModel::changed, this, [this] { choose(); });
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] {
    plot_->clear();
    choose();
  });
  choose();
}

QWidget* TissueShown::buildCurve(QWidget* column) {
  auto* curve = new QWidget(column);
  plot_ = new AreaPlot(curve);
  auto* clear = new QPushButton(tr("Clear"), curve);
  clear->setObjectName("clearCurve");
  clear->setAccessibleName(tr("Clear the curve"));
  clear->setToolTip(tr("Clears the curve"));
  clear->setFocusPolicy(Qt::TabFocus);
  connect(clear, &QPushButton::clicked, plot_, &AreaPlot::clear);
  auto* row = new QHBoxLayout(curve);
  row->setContentsMargins(8, 8, 8, 0);
  row->setSpacing(8);
  row->addWidget(plot_, 1);
  row->addWidget(clear, 0, Qt::AlignBottom);
  return curve;
}

void TissueShown::toggle(int what) {
  const auto one = TissueStrip::Show(what);
  strip_->setShown(one, !strip_->shows(one));
}

bool TissueShown::shows(int what) const {
  return disclosure_.current().anatomy && strip_->shows(TissueStrip::Show(what));
}

void TissueShown::choose() {
  const bool mesh = shows(TissueStrip::kGrid) || shows(TissueStrip::kPressure);
  live_.setMeshRequested(mesh);
  curve_->setVisible(patientCase_.patient() && shows(TissueStrip::kPlot));
  if (mesh && live_.isFrozen() && live_.shown() && live_.shown()->press.mesh.nodes.empty())
    status_.showMessage(tr("The frozen image has no stored grid and pressure; unfreeze the image to show them."));
  showPicture();
}

void TissueShown::showPicture() {
  const auto& frame = live_.shown();
  // Kept while it is hidden, too, for who looks later.
  if (frame && !live_.isFrozen())
    plot_->add(frame->press);
  else if (frame)
    plot_->show(frame->press);
  const bool grid = shows(TissueStrip::kGrid), pressure = shows(TissueStrip::kPressure);
  mesh_.columns = mesh_.rows = 0;
  mesh_.nodes.clear();
  mesh_.pressure_kPa.clear();
  if (frame && (grid || pressure)) {
    const TissueMesh& mesh = frame->press.mesh;
    mesh_.columns = mesh.columns, mesh_.rows = mesh.rows;
    for (const MeshNode& node : mesh.nodes) mesh_.nodes.push_back({node.x_mm, node.z_mm});
    mesh_.pressure_kPa.assign(mesh.pressure_kPa.begin(), mesh.pressure_kPa.end());
  }
  image_.setTissue(mesh_, grid, pressure);
}

void TissueShown::save(QSettings& settings) const {
  for (int k = 0; k < TissueStrip::kShows; ++k) settings.setValue(kShownKeys[k], strip_->shows(TissueStrip::Show(k)));
}

void TissueShown::restore(QSettings& settings) {
  for (int k = 0; k < TissueStrip::kShows; ++k)
    strip_->setShown(TissueStrip::Show(k), settings.value(kShownKeys[k], false).toBool());
}

}  // namespace insonate::train
