#include "Positions.h"

#include "../model/CaseModel.h"
#include "../model/History.h"
#include "../model/ProbeMotion.h"
#include "../model/StatusLine.h"

#include <insonate/simulator/ProbePose.h>

#include <QCryptographicHash>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kRowsShown = 4;
constexpr int kMenu_px = 36;

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

Positions::Positions(StatusLine& status, History& history, CaseModel& patientCase, ProbeMotion& motion, QWidget* parent)
    : QWidget(parent),
      status_(status),
      history_(history),
      patientCase_(patientCase),
      motion_(motion),
      list_(new QListWidget(this)),
      saveButton_(new QPushButton(tr("Save position"), this)),
      menuButton_(new QPushButton(this)) {
  list_->setObjectName("positions");
  list_->setAccessibleName(tr("Positions of the probe"));
  list_->setToolTip(
      tr("Click a position, or press 1 to 9, to move the probe to it. Your own positions: F2 renames, Alt+Up and "
         "Alt+Down reorder, Delete removes a position."));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
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
  saveButton_->setToolTip(tr("Saves the probe's present position in the list"));
  menuButton_->setObjectName("positionMenu");
  menuButton_->setAccessibleName(tr("Actions for the selected position"));
  menuButton_->setToolTip(tr("Renames, reorders or removes the selected position"));
  menuButton_->setFocusPolicy(Qt::TabFocus);
  menuButton_->setFixedWidth(kMenu_px);
  menuButton_->setMenu(buildMenu());
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(saveButton_, 1);
  row->addWidget(menuButton_);
  box->addLayout(row);
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) { nameEdited(item); });
  connect(list_, &QListWidget::itemClicked, this, [this] { recall(list_->currentRow()); });
  connect(list_, &QListWidget::itemActivated, this, [this] { recall(list_->currentRow()); });
  connect(saveButton_, &QPushButton::clicked, this, [this] { saveCurrent(); });
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { refresh(); });
  connect(&motion_, &ProbeMotion::handMoved, this, [this] {
    if (!saveButton_->isEnabled()) refresh();
    if (!going_) list_->setCurrentRow(-1);
  });
  refresh();
}

QMenu* Positions::buildMenu() {
  auto* menu = new QMenu(this);
  const auto add = [this, menu](const QString& text, auto act) {
    connect(menu->addAction(text), &QAction::triggered, this, [this, act] {
      if (list_->currentRow() >= 0)
        act(list_->currentRow());
      else
        status_.showMessage(tr("Choose a position in the list first."));
    });
  };
  add(tr("Rename\tF2"), [this](int place) {
    if (ownAt(place)) list_->editItem(list_->item(place));
  });
  add(tr("Move up\tAlt+Up"), [this](int place) { shift(place, -1); });
  add(tr("Move down\tAlt+Down"), [this](int place) { shift(place, 1); });
  add(tr("Remove\tDelete"), [this](int place) { remove(place); });
  return menu;
}

QString Positions::caseKey() const {
  if (!patientCase_.patient()) return {};
  const auto& size = patientCase_.patient()->labels.geometry.size;
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(QByteArray::fromStdString(patientCase_.patient()->manifest.title));
  hash.addData(QByteArray::fromStdString(patientCase_.patient()->manifest.source));
  for (int n : size) hash.addData(QByteArray::number(n) + ' ');
  return QString::fromLatin1(hash.result().toHex().left(16));
}

std::vector<StartPose> Positions::ofCase() const {
  if (!patientCase_.patient()) return {};
  auto poses = patientCase_.patient()->manifest.startPoses;
  if (poses.empty() && motion_.isReady()) poses.push_back(patientCase_.start());
  return poses;
}

std::vector<StartPose> Positions::all() const {
  auto poses = ofCase();
  if (!patientCase_.patient()) return poses;
  const auto own = own_.value(caseKey());
  poses.insert(poses.end(), own.begin(), own.end());
  return poses;
}

int Positions::count() const {
  return list_->count();
}

void Positions::refresh() {
  refreshing_ = true;
  const int current = list_->currentRow();
  const int first = int(ofCase().size());
  list_->clear();
  const auto poses = all();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const QString name = poses[i].name.empty() ? tr("start") : QString::fromStdString(poses[i].name);
    auto* item = new QListWidgetItem(QStringLiteral("%1  %2").arg(i + 1).arg(name), list_);
    item->setToolTip(name);
    if (int(i) >= first) item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  list_->setCurrentRow(current < list_->count() ? current : -1);
  refreshing_ = false;
  saveButton_->setEnabled(motion_.isReady());
  const int row_px = list_->count() ? list_->sizeHintForRow(0) : fontMetrics().height() + 4;
  list_->setFixedHeight(kRowsShown * row_px + 2 * list_->frameWidth());
}

void Positions::recall(int place) {
  const auto poses = all();
  if (place < 0 || place >= int(poses.size())) return;
  list_->setCurrentRow(place);
  going_ = true;
  motion_.goTo(poses[place]);
  going_ = false;
}

void Positions::change(Own next, const QString& what, int current) {
  const QString key = caseKey();
  const auto exchange = [this, key, other = std::move(next)]() mutable {
    std::swap(own_[key], other);
    refresh();
  };
  History::Exchange now = exchange;
  now();
  history_.add(what, std::move(now));
  if (current < list_->count()) list_->setCurrentRow(current);
}

void Positions::saveCurrent() {
  if (!motion_.isReady()) return;
  StartPose pose = toStartPose(motion_.pose());
  Own own = own_.value(caseKey());
  pose.name = tr("saved position %1").arg(own.size() + 1).toStdString();
  own.push_back(pose);
  change(std::move(own), tr("saving of a probe position"), list_->count());
  status_.showMessage(tr("Position saved as number %1; F2 in the list renames it.").arg(list_->count()));
}

std::optional<std::size_t> Positions::ownAt(int place) {
  const int first = int(ofCase().size());
  if (place < 0 || place >= list_->count()) return std::nullopt;
  if (place >= first) return std::size_t(place - first);
  status_.showMessage(tr("Positions of the case cannot be changed. You can change only your own positions."));
  return std::nullopt;
}

void Positions::remove(int place) {
  const auto index = ownAt(place);
  if (!index) return;
  Own own = own_.value(caseKey());
  own.erase(own.begin() + long(*index));
  change(std::move(own), tr("removal of a probe position"), std::max(0, std::min(place, list_->count() - 2)));
  status_.showMessage(tr("Position removed; Ctrl+Z restores it."));
}

void Positions::rename(int place, const QString& name) {
  const auto index = ownAt(place);
  if (!index || name.trimmed().isEmpty()) return;
  Own own = own_.value(caseKey());
  own[*index].name = name.trimmed().toStdString();
  change(std::move(own), tr("renaming of a probe position"), place);
}

void Positions::shift(int place, int by) {
  const auto index = ownAt(place);
  if (!index) return;
  Own own = own_.value(caseKey());
  const long target = long(*index) + by;
  if (target < 0 || target >= long(own.size())) return;
  std::swap(own[*index], own[std::size_t(target)]);
  change(std::move(own), tr("reordering of probe positions"), place + by);
}

void Positions::nameEdited(QListWidgetItem* item) {
  if (refreshing_) return;
  const int place = list_->row(item);
  // The number before the name is not part of it; who edits may have left it there.
  QString name = item->text().trimmed();
  const QString number = QString::number(place + 1) + QStringLiteral("  ");
  if (name.startsWith(number)) name = name.mid(number.size());
  // Not from within the list's own signal.
  QMetaObject::invokeMethod(
      this,
      [this, place, name] {
        if (name.trimmed().isEmpty())
          refresh();
        else
          rename(place, name);
      },
      Qt::QueuedConnection);
}

bool Positions::eventFilter(QObject* watched, QEvent* event) {
  if (watched != list_ || event->type() != QEvent::KeyPress || list_->currentRow() < 0)
    return QWidget::eventFilter(watched, event);
  const auto& press = *static_cast<QKeyEvent*>(event);
  const bool up = press.key() == Qt::Key_Up, down = press.key() == Qt::Key_Down;
  if (press.key() == Qt::Key_Delete)
    remove(list_->currentRow());
  else if ((up || down) && press.modifiers() & Qt::AltModifier)
    shift(list_->currentRow(), up ? -1 : 1);
  else if (press.key() == Qt::Key_F2 && !ownAt(list_->currentRow()))
    return true;
  else
    return QWidget::eventFilter(watched, event);
  return true;
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
