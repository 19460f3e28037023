#include "ProbeChooser.h"

#include "../model/ImagingModel.h"
#include "ProbeLibrary.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kName = Qt::UserRole + 1;  // of the probe; Qt::UserRole is what loadProbe() takes

bool sameProbe(const Probe& a, const Probe& b) {
  return a.name == b.name && a.shape == b.shape && std::ranges::all_of(probeFields(), [&](const ProbeField& field) {
           return !applies(field, a.shape) || a.*field.member == b.*field.member;
         });
}

}  // namespace

ProbeChooser::ProbeChooser(ImagingModel& imaging, ProbeLibrary& library, QWidget* parent)
    : QWidget(parent), imaging_(imaging), library_(library), list_(new QComboBox), edit_(new QPushButton(tr("Edit"))) {
  list_->setObjectName("probe");
  list_->setFocusPolicy(Qt::TabFocus);
  list_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list_->setAccessibleName(tr("probe"));
  list_->setToolTip(tr("Chooses a built-in probe or a probe of your own; also sets its depth, frequency and focus"));
  edit_->setObjectName("editProbe");
  edit_->setFocusPolicy(Qt::TabFocus);
  edit_->setToolTip(tr("Changes shape and beam of the probe, or fits the probe to an image of a machine"));
  edit_->setAccessibleName(tr("Edit the probe"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(list_, 1);
  row->addWidget(edit_);
  connect(list_, qOverload<int>(&QComboBox::activated), this, [this] {
    const QString key = list_->currentData().toString();
    if (!key.isEmpty()) imaging_.setProbe(key.toStdString());
  });
  connect(edit_, &QPushButton::clicked, this, &ProbeChooser::editRequested);
  connect(&library_, &ProbeLibrary::changed, this, &ProbeChooser::fill);
  connect(&imaging_, &ImagingModel::setupChanged, this, &ProbeChooser::showCurrent);
  fill();
}

QString ProbeChooser::key() const {
  return list_->currentData().toString();
}

void ProbeChooser::fill() {
  list_->clear();
  for (const std::string& name : probePresetNames()) {
    list_->addItem(QString::fromStdString(name), QString::fromStdString(name));
    list_->setItemData(list_->count() - 1, QString::fromStdString(name), kName);
  }
  for (const ProbeLibrary::Entry& entry : library_.entries()) {
    list_->addItem(entry.name, entry.file);
    list_->setItemData(list_->count() - 1, entry.name, kName);
  }
  showCurrent();
}

void ProbeChooser::showCurrent() {
  const Probe& now = imaging_.probe();
  const QString name = QString::fromStdString(now.name);
  int at = list_->findData(name, kName);
  const ProbeLibrary::Entry* own = library_.find(now.name);
  const bool saved = own ? sameProbe(own->probe, now) : isBuiltIn(now.name) && sameProbe(*loadProbe(now.name), now);
  // A probe that is in no file: the last of the list, while it is in use.
  const int edited = list_->findData(QString());
  if (edited >= 0 && saved) list_->removeItem(edited);
  if (!saved) {
    if (edited < 0) list_->addItem(QString(), QString());
    at = list_->count() - 1;
    list_->setItemText(at, tr("%1, edited").arg(name));
  }
  list_->setCurrentIndex(at);
}

}  // namespace insonate::train
