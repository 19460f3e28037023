#include "Positions.h"

#include "../TrainSession.h"

#include <insonate/simulator/ProbePose.h>

#include <QCryptographicHash>
#include <QKeyEvent>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

constexpr int kRowsShown = 4;

QVariantList numbers(const StartPose& pose) {
  QVariantList all;
  for (const Vec3& v : {pose.position_mm, pose.axial, pose.lateral}) all << v.x << v.y << v.z;
  return all;
}

bool readNumbers(const QVariantList& all, StartPose& pose) {
  if (all.size() != 9) return false;
  Vec3* parts[] = {&pose.position_mm, &pose.axial, &pose.lateral};
  for (int i = 0; i < 9; ++i) {
    bool ok = false;
    (*parts[i / 3])[i % 3] = all[i].toDouble(&ok);
    if (!ok) return false;
  }
  return patientFromProbe(pose.position_mm, pose.axial, pose.lateral).has_value();
}

}  // namespace

Positions::Positions(TrainSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      list_(new QListWidget(this)),
      saveButton_(new QPushButton(tr("Save position"), this)) {
  list_->setObjectName("positions");
  list_->setAccessibleName(tr("Positions of the probe"));
  list_->setToolTip(tr("Click, or press 1 to 9. Delete removes one of your own."));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setFocusPolicy(Qt::TabFocus);
  list_->installEventFilter(this);
  saveButton_->setObjectName("savePosition");
  saveButton_->setFocusPolicy(Qt::TabFocus);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  box->addWidget(list_);
  box->addWidget(saveButton_);
  connect(list_, &QListWidget::itemClicked, this, [this] { recall(list_->currentRow()); });
  connect(list_, &QListWidget::itemActivated, this, [this] { recall(list_->currentRow()); });
  connect(saveButton_, &QPushButton::clicked, this, [this] { saveCurrent(); });
  connect(&session_, &TrainSession::caseChanged, this, [this] { refresh(); });
  connect(&session_, &TrainSession::handMoved, this, [this] {
    if (!saveButton_->isEnabled()) refresh();
  });
  refresh();
}

QString Positions::caseKey() const {
  if (!session_.patient()) return {};
  const auto& size = session_.patient()->labels.geometry.size;
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(QByteArray::fromStdString(session_.patient()->manifest.title));
  hash.addData(QByteArray::fromStdString(session_.patient()->manifest.source));
  for (int n : size) hash.addData(QByteArray::number(n) + ' ');
  return QString::fromLatin1(hash.result().toHex().left(16));
}

std::vector<StartPose> Positions::ofCase() const {
  if (!session_.patient()) return {};
  auto poses = session_.patient()->manifest.startPoses;
  if (poses.empty() && session_.handReady()) poses.push_back(session_.start());
  return poses;
}

std::vector<StartPose> Positions::all() const {
  auto poses = ofCase();
  if (!session_.patient()) return poses;
  const auto own = own_.value(caseKey());
  poses.insert(poses.end(), own.begin(), own.end());
  return poses;
}

int Positions::count() const {
  return list_->count();
}

void Positions::refresh() {
  const int current = list_->currentRow();
  list_->clear();
  const auto poses = all();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const QString name = poses[i].name.empty() ? tr("start") : QString::fromStdString(poses[i].name);
    auto* item = new QListWidgetItem(QStringLiteral("%1  %2").arg(i + 1).arg(name), list_);
    item->setToolTip(name);
  }
  list_->setCurrentRow(current < list_->count() ? current : -1);
  saveButton_->setEnabled(session_.handReady());
  const int row_px = list_->count() ? list_->sizeHintForRow(0) : fontMetrics().height() + 4;
  list_->setFixedHeight(kRowsShown * row_px + 2 * list_->frameWidth());
}

void Positions::recall(int place) {
  const auto poses = all();
  if (place < 0 || place >= int(poses.size())) return;
  list_->setCurrentRow(place);
  session_.goTo(poses[place]);
}

void Positions::saveCurrent() {
  if (!session_.handReady()) return;
  StartPose pose = poseOf(session_.pose());
  auto& own = own_[caseKey()];
  pose.name = tr("position %1").arg(own.size() + 1).toStdString();
  own.push_back(pose);
  refresh();
  list_->setCurrentRow(list_->count() - 1);
  session_.say(tr("Position saved as %1.").arg(list_->count()));
}

void Positions::remove(int place) {
  const int first = int(ofCase().size());
  auto& own = own_[caseKey()];
  if (place < first) return session_.say(tr("Positions of the case stay; your own can be removed."));
  if (place - first >= int(own.size())) return;
  own.erase(own.begin() + (place - first));
  refresh();
}

bool Positions::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete && list_->currentRow() >= 0) {
    remove(list_->currentRow());
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void Positions::save(QSettings& settings) const {
  settings.beginGroup("positions");
  settings.remove("");
  for (auto it = own_.begin(); it != own_.end(); ++it) {
    settings.beginWriteArray(it.key(), int(it.value().size()));
    for (int i = 0; i < int(it.value().size()); ++i) {
      settings.setArrayIndex(i);
      settings.setValue("name", QString::fromStdString(it.value()[i].name));
      settings.setValue("pose", numbers(it.value()[i]));
    }
    settings.endArray();
  }
  settings.endGroup();
}

void Positions::restore(QSettings& settings) {
  own_.clear();
  settings.beginGroup("positions");
  for (const QString& key : settings.childGroups()) {
    const int count = settings.beginReadArray(key);
    for (int i = 0; i < count; ++i) {
      settings.setArrayIndex(i);
      StartPose pose;
      pose.name = settings.value("name").toString().toStdString();
      if (readNumbers(settings.value("pose").toList(), pose)) own_[key].push_back(pose);
    }
    settings.endArray();
  }
  settings.endGroup();
  refresh();
}

}  // namespace insonate::train
