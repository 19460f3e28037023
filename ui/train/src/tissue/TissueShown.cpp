#include "TissueShown.h"

#include "../TrainSession.h"
#include "AreaPlot.h"
#include "TissueStrip.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QPushButton>
#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kKeys[TissueStrip::kShows] = {"tissueGrid", "tissuePressure", "tissueCurve"};

}  // namespace

TissueShown::TissueShown(TrainSession& session, views::UltrasoundView& image, QWidget* column)
    : QObject(column), session_(session), image_(image), strip_(new TissueStrip(session, column)) {
  curve_ = buildCurve(column);
  connect(strip_, &TissueStrip::shownChanged, this, [this] { choose(); });
  connect(&session_, &TrainSession::pictureShown, this, [this] { showPicture(); });
  connect(&session_, &TrainSession::disclosureChanged, this, [this] { choose(); });
  connect(&session_, &TrainSession::caseChanged, this, [this] {
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
  return session_.disclosure().anatomy && strip_->shows(TissueStrip::Show(what));
}

void TissueShown::choose() {
  const bool mesh = shows(TissueStrip::kGrid) || shows(TissueStrip::kPressure);
  session_.setMeshWanted(mesh);
  curve_->setVisible(session_.patient() && shows(TissueStrip::kPlot));
  if (mesh && session_.isFrozen() && session_.shown() && session_.shown()->press.mesh.nodes.empty())
    session_.say(tr("The frozen image came without its mesh; the live one shows it."));
  showPicture();
}

void TissueShown::showPicture() {
  const auto& frame = session_.shown();
  // Kept while it is hidden, too, for who looks later.
  if (frame && !session_.isFrozen())
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
  for (int k = 0; k < TissueStrip::kShows; ++k) settings.setValue(kKeys[k], strip_->shows(TissueStrip::Show(k)));
}

void TissueShown::restore(QSettings& settings) {
  for (int k = 0; k < TissueStrip::kShows; ++k)
    strip_->setShown(TissueStrip::Show(k), settings.value(kKeys[k], false).toBool());
}

}  // namespace insonate::train
