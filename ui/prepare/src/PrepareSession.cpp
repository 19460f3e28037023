#include "PrepareSession.h"

#include "edit/Edits.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate::prepare {
namespace {

/// Few enough triangles that 3D turns without a graphics card: fine for what is small, coarse for what fills the body.
SurfaceOptions surfaceOptions(std::uint8_t label) {
  switch (label) {
    case kSkin:
      return {8, 3};
    case kFat:
    case kSoftTissue:
      return {6, 3};
    case kBone:
    case kAirway:
    case kMuscle:
    case kSternocleidomastoid:
      return {5, 2};
    case kThyroid:
    case kGland:
    case kOesophagus:
    case kCartilage:
      return {5, 1.5};
    default:
      return {4, 1};
  }
}

/// After the last of several edits.
constexpr int kRecheck_ms = 700;

/// Center of the middle voxel: between two voxels, slices blend both, and the labels are of one side.
Vec3 middleOf(const VolumeGeometry& grid) {
  const auto [i, j, k] = nearestVoxel(grid.indexFromPatient() * grid.centre_mm());
  return grid.patientFromIndex() * Vec3{double(i), double(j), double(k)};
}

/// Structures in the order in which authors look for them.
constexpr std::uint8_t kOrder[] = {kVein, kArtery, kSkin, kBone, kAirway, kThyroid, kCartilage, kSternocleidomastoid};

}  // namespace

PrepareSession::PrepareSession(ui::TaskBar& tasks, QObject* parent)
    : QObject(parent),
      looks_(defaultLooks({})),
      measuring_(tasks, this),
      live_(this),
      labelling_(tasks, undo_, this),
      followers_(
          labelling_, live_, measuring_, [this](const LabelSet& labels) { return changedSurfaces(labels); }, this) {
  undo_.setUndoLimit(kMostUndo);
  said_.setSingleShot(true);
  said_.setInterval(kSaid_ms);
  recheck_.setSingleShot(true);
  recheck_.setInterval(kRecheck_ms);
  connect(&recheck_, &QTimer::timeout, this, [this] {
    if (patient_) measuring_.setWords(places_, terms_);
  });
  connect(&said_, &QTimer::timeout, this, [this] {
    message_.clear();
    Q_EMIT messageChanged();
  });
  connect(&measuring_, &CaseMeasuring::changed, this, [this] { listStructures(); });
  connect(&live_, &LivePatient::started, this, [this] {
    const auto& start = *live_.start();
    found_ = start;
    // The view begins where the case begins, unless the author already looks elsewhere.
    if (crosshair_mm_ == middleOf(patient_->ct.geometry)) {
      crosshair_mm_ = start.position_mm;
      Q_EMIT crosshairMoved();
    }
    Q_EMIT messageChanged();
  });
  labelling_.setNames([this](std::uint8_t label) { return nameOf(label); });
  connect(&labelling_, &LabelSession::failed, this, &PrepareSession::say);
  connect(&labelling_, &LabelSession::changed, this, [this](const LabelChange& change) {
    const LabelSet before = added_;
    added_ |= change.labels;
    added_.reset(kBackground);
    if (added_ != before) listStructures();
    notifyEdits();
    Q_EMIT messageChanged();
  });
}

void PrepareSession::setOrigin(const ui::CaseOrigin& origin) {
  origin_ = origin;
  Q_EMIT originChanged();
}

void PrepareSession::setCase(std::shared_ptr<const PatientCase> patient) {
  live_.stop();
  undo_.clear();
  patient_ = std::move(patient);
  structures_.clear();
  added_.reset();
  surfaceWanted_ = {};
  selected_ = 0;
  message_.clear();
  looks_ = defaultLooks(patient_ ? patient_->colours : LabelColours{});
  for (const auto& [label, habit] : habits_)
    // Without skin, another patient would look broken.
    looks_[label].opacity = habit.opacity, looks_[label].visible = habit.visible || label == kSkin,
    looks_[label].onSlices = habit.onSlices;
  if (patient_) takeShown(patient_->manifest.shown, looks_);
  kept_ = looks_;
  recheck_.stop();
  places_ = patient_ ? placesOf(patient_->manifest) : CasePlaces{};
  terms_ = patient_ ? termsOf(patient_->manifest) : LabelTerms{};
  found_.reset();
  title_ = patient_ ? QString::fromStdString(patient_->manifest.title) : QString();
  crosshair_mm_ = patient_ ? middleOf(patient_->ct.geometry) : Vec3{};
  pointer_mm_.reset();
  labelling_.setCase(patient_);
  // Before anybody asks what the case has.
  measuring_.setCase(patient_);
  notifyHidden();
  Q_EMIT caseChanged();
  live_.setPatient(patient_, missingSurfaces());
  live_.setOwnLabels(terms_.own);
  notifyEdits();
  Q_EMIT messageChanged();
}

void PrepareSession::replaceCase(std::shared_ptr<const PatientCase> patient) {
  // An import is named as it is saved.
  if (patient_ && title_.toStdString() == patient_->manifest.title) {
    title_ = QString::fromStdString(patient->manifest.title);
    Q_EMIT titleChanged();
  }
  patient_ = std::move(patient);
  labelling_.replaceCase(patient_);
  live_.replacePatient(patient_);
  takeShown(patient_->manifest.shown, kept_);
  Q_EMIT placesChanged();
  notifyEdits();
}

void PrepareSession::setAwake(bool awake) {
  measuring_.setAllowed(awake);
  live_.setAwake(awake);
}

void PrepareSession::stop() {
  measuring_.setAllowed(false);
  live_.stop();
}

std::vector<ui::SurfaceWish> PrepareSession::missingSurfaces() {
  std::vector<ui::SurfaceWish> wishes;
  const auto wish = [&](std::uint8_t label) {
    if (!looks_[label].visible || looks_[label].opacity <= 0 || std::exchange(surfaceWanted_[label], true)) return;
    wishes.push_back({label, surfaceOptions(label)});
  };
  for (const std::uint8_t label : kOrder) wish(label);
  for (int label = 1; label < 256; ++label) wish(std::uint8_t(label));
  return wishes;
}

std::vector<ui::SurfaceWish> PrepareSession::changedSurfaces(const LabelSet& labels) const {
  std::vector<ui::SurfaceWish> wishes;
  for (int label = 1; label < 256; ++label) {
    const auto value = std::uint8_t(label);
    // The surface of the skin is that of the body: it moves where the outside does.
    const bool moved = labels.test(value) || (value == kSkin && labels.test(kBackground));
    if (moved && looks_[value].opacity > 0) wishes.push_back({value, surfaceOptions(value)});
  }
  return wishes;
}

void PrepareSession::notifyHidden() {
  LabelRules rules = labelling_.rules();
  for (int label = 0; label < 256; ++label) rules.hidden.set(std::size_t(label), !looks_[std::size_t(label)].visible);
  if (rules.hidden != labelling_.rules().hidden) labelling_.setRules(rules);
}

void PrepareSession::push(std::uint8_t label, const StructureLook& look, const QString& what) {
  if (!patient_ || look == looks_[label]) return;
  undo_.push(new LookEdit(*this, label, look, what));
}

void PrepareSession::setColour(std::uint8_t label, views::Colour colour) {
  StructureLook look = looks_[label];
  look.colour = colour;
  push(label, look, tr("color of %1").arg(nameOf(label)));
}

void PrepareSession::setOpacity(std::uint8_t label, double opacity) {
  StructureLook look = looks_[label];
  look.opacity = std::clamp(opacity, 0.0, 1.0);
  push(label, look, tr("opacity of %1").arg(nameOf(label)));
}

void PrepareSession::setShareOnSlices(std::uint8_t label, double share) {
  StructureLook look = looks_[label];
  look.onSlices = std::clamp(share, 0.0, 1.0);
  push(label, look, tr("opacity of %1").arg(nameOf(label)));
}

void PrepareSession::setVisible(std::uint8_t label, bool visible) {
  StructureLook look = looks_[label];
  look.visible = visible;
  push(label, look, (visible ? tr("show %1") : tr("hide %1")).arg(nameOf(label)));
}

void PrepareSession::showOnly(std::uint8_t label) {
  auto all = std::make_unique<QUndoCommand>(tr("show only %1").arg(nameOf(label)));
  for (const std::uint8_t one : structures_) {
    StructureLook look = looks_[one];
    look.visible = one == label;
    if (look != looks_[one]) new LookEdit(*this, one, look, {}, all.get());
  }
  if (all->childCount() > 0) undo_.push(all.release());
}

void PrepareSession::showAll() {
  auto all = std::make_unique<QUndoCommand>(tr("show all"));
  for (const std::uint8_t one : structures_) {
    StructureLook look = looks_[one];
    look.visible = true;
    if (look != looks_[one]) new LookEdit(*this, one, look, {}, all.get());
  }
  if (all->childCount() > 0) undo_.push(all.release());
}

void PrepareSession::applyLook(std::uint8_t label, const StructureLook& look) {
  looks_[label] = look;
  habits_[label] = {look.opacity, look.visible, look.onSlices};
  notifyHidden();
  for (ui::SurfaceWish& wish : missingSurfaces()) {
    wish.labels = labelling_.snapshot();
    live_.wantSurface(wish);
  }
  Q_EMIT lookChanged(label);
  notifyEdits();
}

void PrepareSession::setTitle(const QString& title) {
  const QString tidy = title.simplified();
  if (!patient_ || tidy == title_ || tidy.isEmpty()) return Q_EMIT titleChanged();  // Restores the field.
  undo_.push(new TitleEdit(*this, tidy));
}

void PrepareSession::applyTitle(const QString& title) {
  title_ = title;
  Q_EMIT titleChanged();
  notifyEdits();
}

bool PrepareSession::isUnsaved() const {
  if (!patient_) return false;
  return title_.toStdString() != patient_->manifest.title || !samePlaces(places_, placesOf(patient_->manifest)) ||
         terms_ != termsOf(patient_->manifest) || labelling_.isChanged() ||
         coloursDiffer(looks_, structures_, patient_->colours);
}

ui::CaseEdit PrepareSession::unsavedEdit() {
  if (!isUnsaved()) return {};
  return [title = title_.toStdString(), looks = looks_, structures = structures_, places = places_, terms = terms_,
          labels = labelling_.isChanged() ? labelling_.snapshot() : nullptr](PatientCase& copy) {
    if (labels) copy.labels = *labels;
    putPlaces(places, copy.manifest);
    putTerms(terms, copy.manifest);
    copy.manifest.title = title;
    putColours(looks, structures, copy.colours);
  };
}

ui::CaseEdit PrepareSession::quietEdit() const {
  if (!patient_ || !shownDiffers(looks_, kept_, structures_)) return {};
  return [looks = looks_, structures = structures_](PatientCase& copy) {
    putShown(looks, structures, copy.manifest.shown);
  };
}

void PrepareSession::notifyEdits() {
  const std::array<bool, 2> has{isUnsaved(), quietEdit() != nullptr};
  if (has != std::exchange(hadEdits_, has)) Q_EMIT editsChanged();
}

void PrepareSession::setCrosshair(Vec3 patient_mm) {
  if (!patient_ || !isFinite(patient_mm)) return;
  const VolumeGeometry& grid = patient_->ct.geometry;
  Vec3 index = grid.indexFromPatient() * patient_mm;
  for (int axis = 0; axis < 3; ++axis) index[axis] = std::clamp(index[axis], -0.5, grid.size[axis] - 0.5);
  const Vec3 kept_mm = grid.patientFromIndex() * index;
  if (kept_mm == crosshair_mm_) return;
  crosshair_mm_ = kept_mm;
  live_.follow(crosshair_mm_);
  message_.clear();
  Q_EMIT crosshairMoved();
  Q_EMIT messageChanged();
}

void PrepareSession::goToStart() {
  if (live_.start()) goTo(*live_.start());
}

void PrepareSession::goTo(const StartPose& pose) {
  setCrosshair(pose.position_mm);
  live_.goTo(pose);
}

void PrepareSession::setWindowLevel(views::WindowLevel value) {
  if (value == windowLevel_) return;
  windowLevel_ = value;
  Q_EMIT slicesChanged();
}

void PrepareSession::setLabelOpacity(double opacity) {
  opacity = std::clamp(opacity, 0.0, 1.0);
  if (opacity == labelOpacity_) return;
  labelOpacity_ = opacity;
  Q_EMIT slicesChanged();
}

void PrepareSession::setLabelsShown(bool shown) {
  if (shown == labelsShown_) return;
  labelsShown_ = shown;
  Q_EMIT slicesChanged();
}

void PrepareSession::setLabelStyle(const views::LabelStyle& style) {
  if (style == labelStyle_) return;
  labelStyle_ = style;
  Q_EMIT slicesChanged();
}

void PrepareSession::setPlacesShown(bool shown) {
  if (shown == placesShown_) return;
  placesShown_ = shown;
  Q_EMIT slicesChanged();
}

void PrepareSession::pointAt(std::optional<Vec3> patient_mm) {
  if (patient_mm == std::exchange(pointer_mm_, patient_mm) || !message_.isEmpty()) return;
  Q_EMIT messageChanged();
}

QString PrepareSession::placeText() const {
  const Vec3 at_mm = pointer_mm_.value_or(crosshair_mm_);
  const Vec3 index = patient_->ct.geometry.indexFromPatient() * at_mm;
  const std::uint8_t label = sampleNearest(labelling_.labels(), index);
  return tr("(%1, %2, %3) mm   %4 HU   %5")
      .arg(at_mm.x, 0, 'f', 1)
      .arg(at_mm.y, 0, 'f', 1)
      .arg(at_mm.z, 0, 'f', 1)
      .arg(std::lround(sampleLinear(patient_->ct, index)))
      .arg(label == kBackground ? tr("not labeled") : nameOf(label));
}

QString PrepareSession::message() const {
  if (!message_.isEmpty()) return message_;
  return patient_ ? placeText() : tr("Drop a case or a CT on the window.");
}

void PrepareSession::say(const QString& sentence) {
  said_.start();
  message_ = sentence;
  Q_EMIT messageChanged();
}

}  // namespace insonate::prepare
