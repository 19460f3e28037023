#include "PlacesBox.h"

#include "../labels/LabelSession.h"
#include "../model/Crosshair.h"
#include "../model/LivePatient.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PlaceProposing.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../model/TermsEditor.h"
#include "../model/VesselNaming.h"

#include <insonate/cases/Landmarks.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/LetterKeyFilter.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::prepare {
namespace {

constexpr int kKindRole = Qt::UserRole, kIndexRole = Qt::UserRole + 1;
constexpr int kListHeight_px = 190;

}  // namespace

PlacesBox::PlacesBox(PrepareModel& shared, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      list_(new QTreeWidget),
      kind_(new QComboBox),
      add_(ui::pushButton("placeAdd", tr("Mark"), tr("Adds the mark at the crosshair, or a start pose at the probe"))),
      propose_(ui::pushButton("placePropose", tr("Propose what is missing"),
                              tr("Proposes a target in the vein, start poses over the target, and the puncture site"))),
      show_(
          ui::pushButton("placeShow", tr("Show"), tr("Moves the crosshair or the probe to the selected mark (Enter)"))),
      put_(ui::pushButton("placePut", tr("Move here"),
                          tr("Moves the selected mark to the crosshair; moves a selected start pose to the present "
                             "pose of the probe"))),
      first_(ui::pushButton("placeFirst", tr("Put first in list"),
                            tr("Moves the selected start pose or target to the top of its list"))),
      split_(ui::pushButton("placeSplit", tr("Split"),
                            tr("Splits the selected vessel at the crosshair into two vessels with different names"))),
      remove_(ui::pushButton("placeRemove", tr("Remove"), tr("Removes the selected mark"))) {
  arrange();
  connect(kind_, qOverload<int>(&QComboBox::activated), this, [this] { shared_.places.beginMarking(); });
  connect(add_, &QPushButton::clicked, this, [this] { add(); });
  connect(propose_, &QPushButton::clicked, &shared_.proposing, &PlaceProposing::start);
  connect(show_, &QPushButton::clicked, this, [this] { show(); });
  connect(put_, &QPushButton::clicked, this, [this] { moveHere(); });
  connect(first_, &QPushButton::clicked, this, [this] { makeFirst(); });
  connect(split_, &QPushButton::clicked, this, [this] { splitVesselHere(); });
  connect(remove_, &QPushButton::clicked, this, [this] { remove(); });
  connect(list_, &QTreeWidget::itemActivated, this, [this] { show(); });
  connect(list_, &QTreeWidget::currentItemChanged, this, [this] { refreshButtons(); });
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!showing_) rename(item);
  });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { refresh(); });
  connect(&shared_.places, &PlacesEditor::changed, this, [this] { refresh(); });
  connect(&shared_.proposing, &PlaceProposing::runningChanged, this, [this] { refreshButtons(); });
  refresh();
}

void PlacesBox::arrange() {
  kind_->setObjectName(QStringLiteral("placeKind"));
  kind_->setAccessibleName(tr("Kind of mark"));
  kind_->setToolTip(tr("Kind of mark to add; first click on the location of the mark in a slice or in 3D"));
  for (const LandmarkKind& kind : landmarkKinds()) kind_->addItem(ui::qt(kind.name), ui::qt(kind.code));
  kind_->addItem(tr("another landmark"), QString());
  kind_->addItem(tr("target of the puncture"), kTargetKind);
  kind_->addItem(tr("start pose of the probe"), kStartPoseKind);
  for (const VesselKind& kind : vesselKinds()) kind_->addItem(ui::qt(kind.name), kVesselKind);
  kind_->addItem(tr("another vessel"), kVesselKind);
  list_->setObjectName(QStringLiteral("places"));
  list_->setAccessibleName(tr("Targets, vessels, landmarks and start poses"));
  list_->setToolTip(tr("F2 renames the selected mark, Enter shows it"));
  new ui::LetterKeyFilter(list_);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setIndentation(ui::kGap);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setFixedHeight(kListHeight_px);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QLabel* how = ui::paragraph("placeHow", "quiet",
                              tr("Click on a location in a slice or in 3D, choose a kind of mark, and click Mark."));
  auto* marking = new QHBoxLayout;
  marking->setSpacing(ui::kSmallGap);
  marking->addWidget(kind_, 1);
  marking->addWidget(add_);
  auto* acting = new QGridLayout;
  acting->setSpacing(ui::kSmallGap);
  acting->addWidget(show_, 0, 0);
  acting->addWidget(put_, 0, 1);
  acting->addWidget(first_, 1, 0);
  acting->addWidget(split_, 1, 1);
  acting->addWidget(remove_, 2, 0, 1, 2);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(how);
  box->addLayout(marking);
  box->addWidget(propose_);
  box->addWidget(list_);
  box->addLayout(acting);
}

void PlacesBox::offer(const QString& kind) {
  kind_->setCurrentIndex(std::max(0, kind_->findData(kind)));
  kind_->setFocus();
  shared_.places.beginMarking();
}

void PlacesBox::refresh() {
  Chosen before{};
  const bool had = chosen(before);
  showing_ = true;
  list_->clear();
  const CasePlaces& places = shared_.places.value();
  const auto heading = [this](const QString& words) {
    auto* item = new QTreeWidgetItem(list_, {words});
    item->setFlags(Qt::ItemIsEnabled);
    return item;
  };
  const auto add = [&](QTreeWidgetItem* under, Kind kind, std::size_t index, const QString& name) {
    auto* item = new QTreeWidgetItem(under, {name.isEmpty() ? tr("unnamed") : name});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
    item->setData(0, kKindRole, int(kind));
    item->setData(0, kIndexRole, int(index));
    if (had && before.kind == kind && before.index == index) list_->setCurrentItem(item);
  };
  auto* targets =
      heading(places.targets.empty() ? tr("Targets: none yet") : tr("Targets; trainees practice on the first target"));
  for (std::size_t n = 0; n < places.targets.size(); ++n)
    add(targets, Kind::Target, n, QString::fromStdString(places.targets[n].name));
  auto* vessels = heading(places.vessels.empty() ? tr("Vessels: none named yet") : tr("Vessels"));
  for (std::size_t n = 0; n < places.vessels.size(); ++n)
    add(vessels, Kind::Vessel, n, QString::fromStdString(places.vessels[n].name));
  auto* poses =
      heading(places.startPoses.empty() ? tr("Start poses of the probe: none yet")
                                        : tr("Start poses of the probe; the case opens at the first start pose"));
  for (std::size_t n = 0; n < places.startPoses.size(); ++n)
    add(poses, Kind::StartPose, n, QString::fromStdString(places.startPoses[n].name));
  auto* landmarks = heading(places.landmarks.empty() ? tr("Landmarks: none yet") : tr("Landmarks"));
  for (std::size_t n = 0; n < places.landmarks.size(); ++n)
    add(landmarks, Kind::Landmark, n, QString::fromStdString(places.landmarks[n].name));
  list_->expandAll();
  showing_ = false;
  refreshButtons();
}

bool PlacesBox::chosen(Chosen& one) const {
  const QTreeWidgetItem* item = list_->currentItem();
  if (!item || !item->parent()) return false;
  one = {Kind(item->data(0, kKindRole).toInt()), std::size_t(item->data(0, kIndexRole).toInt())};
  return true;
}

void PlacesBox::refreshButtons() {
  Chosen one{};
  const bool any = chosen(one);
  for (QPushButton* each : {show_, put_, remove_}) each->setEnabled(any);
  first_->setEnabled(any && (one.kind == Kind::Target || one.kind == Kind::StartPose) && one.index > 0);
  split_->setEnabled(any && one.kind == Kind::Vessel);
  add_->setEnabled(shared_.openCase.patient() != nullptr);
  propose_->setEnabled(shared_.openCase.patient() != nullptr && !shared_.proposing.isRunning());
}

void PlacesBox::change(const QString& what, const std::function<void(CasePlaces&)>& how) {
  CasePlaces places = shared_.places.value();
  how(places);
  shared_.places.set(std::move(places), what);
}

void PlacesBox::add() {
  const QString what = kind_->currentData().toString(), name = kind_->currentText();
  const Vec3 here_mm = shared_.crosshair.position_mm();
  if (what == kStartPoseKind) {
    const auto pose = shared_.live.standing();
    if (!pose) return shared_.notice.showMessage(tr("The probe has no position yet. Click on the skin first."));
    return change(tr("start pose"), [&](CasePlaces& places) {
      places.startPoses.push_back(toStartPose(*pose));
      places.startPoses.back().name = tr("start %1").arg(places.startPoses.size()).toStdString();
    });
  }
  if (what == kVesselKind) return nameVesselAt(shared_, {here_mm}, name);
  if (what == kTargetKind) return addTarget();
  addLandmark(what.toStdString(), name);
}

/// A target in a named vessel gets that name.
void PlacesBox::addTarget() {
  const Vec3 here_mm = shared_.crosshair.position_mm();
  const LabelMap& labels = shared_.labeling.labels();
  const std::uint8_t label =
      tissueOf(shared_.terms.value().own, sampleNearest(labels, labels.geometry.indexFromPatient() * here_mm));
  if (label != kVein && label != kArtery)
    return shared_.notice.showMessage(
        tr("A target must lie in a vein or an artery. Move the crosshair into the vessel first."));
  change(tr("target"), [&](CasePlaces& places) {
    std::string name = structureName(label).toStdString();
    for (const NamedVessel& vessel : places.vessels)
      if (vessel.label == label && distanceToWall_mm(vessel, here_mm) < 0) name = vessel.name;
    places.targets.push_back({name, label, here_mm});
  });
}

/// A neck has one of each known landmark; marking it again moves it.
void PlacesBox::addLandmark(const std::string& code, const QString& name) {
  const Vec3 here_mm = shared_.crosshair.position_mm();
  const auto& before = shared_.places.value().landmarks;
  const auto same = code.empty() ? before.end() : std::ranges::find(before, code, &Landmark::code);
  if (same == before.end())
    return change(tr("landmark"), [&](CasePlaces& places) {
      places.landmarks.push_back({code, name.toStdString(), here_mm});
    });
  const auto index = same - before.begin();
  const QString told = ui::qt(same->name);
  change(tr("landmark"), [&](CasePlaces& places) { places.landmarks[std::size_t(index)].position_mm = here_mm; });
  shared_.notice.showMessage(
      tr("\"%1\" existed already and was moved to the crosshair; Ctrl+Z undoes the move.").arg(told));
}

void PlacesBox::show() {
  Chosen one{};
  if (!chosen(one)) return;
  const CasePlaces& places = shared_.places.value();
  switch (one.kind) {
    case Kind::Target:
      shared_.structures.select(places.targets[one.index].label);
      return shared_.crosshair.moveTo(places.targets[one.index].position_mm);
    case Kind::Vessel: {
      const NamedVessel& vessel = places.vessels[one.index];
      shared_.structures.select(vessel.label);
      return shared_.crosshair.moveTo(vessel.course[vessel.course.size() / 2].position_mm);
    }
    case Kind::Landmark:
      return shared_.crosshair.moveTo(places.landmarks[one.index].position_mm);
    case Kind::StartPose:
      return shared_.crosshair.goTo(places.startPoses[one.index]);
  }
}

void PlacesBox::moveHere() {
  Chosen one{};
  if (!chosen(one)) return;
  if (one.kind == Kind::Vessel)
    return nameVesselAt(shared_, {shared_.crosshair.position_mm()},
                        ui::qt(shared_.places.value().vessels[one.index].name));
  const auto pose = shared_.live.standing();
  change(tr("move a mark"), [&](CasePlaces& places) {
    const Vec3 here_mm = shared_.crosshair.position_mm();
    if (one.kind == Kind::Target) places.targets[one.index].position_mm = here_mm;
    if (one.kind == Kind::Landmark) places.landmarks[one.index].position_mm = here_mm;
    if (one.kind != Kind::StartPose || !pose) return;
    StartPose moved = toStartPose(*pose);
    moved.name = places.startPoses[one.index].name;
    places.startPoses[one.index] = std::move(moved);
  });
}

void PlacesBox::makeFirst() {
  Chosen one{};
  if (!chosen(one)) return;
  change(tr("reorder marks"), [&](CasePlaces& places) {
    const auto toFront = [&](auto& list) {
      std::rotate(list.begin(), list.begin() + std::ptrdiff_t(one.index), list.begin() + std::ptrdiff_t(one.index) + 1);
    };
    one.kind == Kind::Target ? toFront(places.targets) : toFront(places.startPoses);
  });
}

void PlacesBox::splitVesselHere() {
  Chosen one{};
  if (!chosen(one) || one.kind != Kind::Vessel) return;
  auto parts = splitVessel(shared_.places.value().vessels[one.index], shared_.crosshair.position_mm());
  if (!parts) return shared_.notice.showMessage(ui::qt(parts.error().message));
  parts->second.name += ", part 2";
  change(tr("split a vessel"), [&](CasePlaces& places) {
    const auto at = places.vessels.begin() + std::ptrdiff_t(one.index);
    *at = std::move(parts->first);
    places.vessels.insert(at + 1, std::move(parts->second));
  });
}

void PlacesBox::remove() {
  Chosen one{};
  if (!chosen(one)) return;
  change(tr("remove a mark"), [&](CasePlaces& places) {
    const auto erase = [&](auto& list) { list.erase(list.begin() + std::ptrdiff_t(one.index)); };
    if (one.kind == Kind::Target) erase(places.targets);
    if (one.kind == Kind::Vessel) erase(places.vessels);
    if (one.kind == Kind::Landmark) erase(places.landmarks);
    if (one.kind == Kind::StartPose) erase(places.startPoses);
  });
}

void PlacesBox::rename(QTreeWidgetItem* item) {
  const auto index = std::size_t(item->data(0, kIndexRole).toInt());
  const std::string name = item->text(0).simplified().toStdString();
  // The list is built again, which must not happen during the signal of one of its items.
  QMetaObject::invokeMethod(
      this,
      [this, index, name, kind = Kind(item->data(0, kKindRole).toInt())] {
        change(tr("rename a mark"), [&](CasePlaces& places) {
          if (name.empty()) return;
          if (kind == Kind::Target) places.targets[index].name = name;
          if (kind == Kind::Vessel) places.vessels[index].name = name;
          if (kind == Kind::Landmark) places.landmarks[index].name = name;
          if (kind == Kind::StartPose) places.startPoses[index].name = name;
        });
      },
      Qt::QueuedConnection);
}

}  // namespace insonate::prepare
