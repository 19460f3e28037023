#include "VesselSession.h"

#include "../labels/LabelSession.h"
#include "../model/Crosshair.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../model/TermsEditor.h"

#include <insonate/segmentation/CenterLine.h>
#include <insonate/tissue/Labels.h>

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace insonate::prepare {
namespace {

/// The center lines are computed this long after the last of several edits.
constexpr int kAgain_ms = 400;
/// Maximum distance of the crosshair from a course at which the section follows the crosshair.
constexpr double kNear_mm = 20;

/// Returns the courses of all vessels with a label. Only the part of the map that contains the label is searched.
std::vector<VesselCourse> coursesOf(const LabelMap& labels, std::uint8_t label, const Progress& progress) {
  constexpr double kMargin_mm = 3;
  const VoxelBox box = grown(boundingBoxOf(labels, label), labels.geometry, kMargin_mm);
  std::vector<VesselCourse> courses;
  if (box.empty()) return courses;
  const LabelMap part = cropped(labels, box);
  auto found = centerLines(part, label, progress);
  if (!found) return courses;
  const std::vector<CenterLine> lines = joinedLines(std::move(*found), part, label);
  for (const CenterLine& line : lines)
    if (auto course = VesselCourse::make(extendedToEnds(line, part, label))) courses.push_back(std::move(*course));
  return courses;
}

}  // namespace

VesselSession::VesselSession(PrepareModel& shared, QObject* parent) : QObject(parent), shared_(shared) {
  again_.setSingleShot(true);
  again_.setInterval(kAgain_ms);
  connect(&again_, &QTimer::timeout, this, [this] { find(); });
  connect(&shared_.openCase, &OpenCase::closing, this, [this] { clear({}); });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { find(); });
  connect(&shared_.structures, &StructureList::selectedChanged, this, [this] { find(); });
  connect(&shared_.terms, &TermsEditor::changed, &again_, qOverload<>(&QTimer::start));
  connect(&shared_.crosshair, &Crosshair::moved, this, [this] {
    if (!moving_) goToCrosshair();
  });
  connect(&shared_.labeling, &LabelSession::changed, this, [this] { followEdit(); });
  connect(&shared_.labeling, &LabelSession::seenChanged, this, &VesselSession::labelsChanged);
  connect(&shared_.labeling.preview(), &LabelPreview::changed, this, &VesselSession::labelsChanged);
}

VesselSession::~VesselSession() {
  if (stop_) *stop_ = true;
}

void VesselSession::setActive(bool active) {
  if (std::exchange(active_, active) == active) return;
  active_ ? find() : clear({});
}

void VesselSession::clear(const QString& reason) {
  if (stop_) *stop_ = true;
  stop_ = nullptr;
  start_.reset(), dragged_.reset();
  courses_.clear();
  chosen_ = 0;
  reason_ = reason;
  Q_EMIT courseChanged();
}

void VesselSession::find() {
  again_.stop();
  if (!active_ || !shared_.openCase.patient()) return clear({});
  const std::uint8_t selected = shared_.structures.selected();
  const std::uint8_t tissue = tissueOf(shared_.terms.value().own, selected);
  if (tissue != kVein && tissue != kArtery) {
    label_ = selected;
    return clear(tr("Select a vein or an artery in the table of structures. Its course is then shown here."));
  }
  if (stop_) *stop_ = true;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  // After an edit, the former course is shown until the new course is found.
  const QString name = shared_.terms.nameOf(selected);
  if (std::exchange(label_, selected) != selected || courses_.empty()) {
    courses_.clear();
    start_.reset(), dragged_.reset();
    reason_ = tr("Finding the center line of %1 ...").arg(name);
    Q_EMIT courseChanged();
  }
  QtConcurrent::run([self = QPointer(this), stop = stop_, labels = shared_.labeling.snapshot(), label = label_, name] {
    Found found{coursesOf(*labels, label, [&stop](std::string_view, double) { return !*stop; }), {}};
    if (found.courses.empty())
      found.reason =
          tr("No center line was found in %1: the label is empty, or shorter than wide. Label a longer piece "
             "of the vessel.")
              .arg(name);
    QMetaObject::invokeMethod(qApp, [self, stop, found = std::move(found)]() mutable {
      if (self && self->stop_ == stop) self->take(std::move(found));
    });
  });
}

void VesselSession::take(Found found) {
  stop_ = nullptr;
  // The dragged outline belongs to the former course.
  if (start_) return again_.start();
  courses_ = std::move(found.courses);
  reason_ = std::move(found.reason);
  chosen_ = 0, frame_ = 0;
  if (!courses_.empty()) {
    const Vec3 at_mm = shared_.crosshair.position_mm();
    chosen_ = std::size_t(
        std::ranges::min_element(
            courses_, {}, [&](const VesselCourse& c) { return norm(c.frames()[c.nearest(at_mm)].center_mm - at_mm); }) -
        courses_.begin());
    frame_ = course()->nearest(at_mm);
  }
  Q_EMIT courseChanged();
}

void VesselSession::followEdit() {
  if (!active_) return;
  // The outline was dragged along the present course, which stays valid.
  if (!writing_) again_.start();
  Q_EMIT labelsChanged();
}

void VesselSession::goToCrosshair() {
  if (courses_.empty() || start_) return;
  const Vec3 at_mm = shared_.crosshair.position_mm();
  double nearest_mm = kNear_mm;
  const std::size_t before = chosen_;
  for (std::size_t n = 0; n < courses_.size(); ++n) {
    const std::size_t frame = courses_[n].nearest(at_mm);
    const double mm = norm(courses_[n].frames()[frame].center_mm - at_mm);
    if (mm < nearest_mm) nearest_mm = mm, chosen_ = n, frame_ = frame;
  }
  if (chosen_ != before) Q_EMIT courseChanged();
  Q_EMIT moved();
}

VesselVolumes VesselSession::volumes() const {
  return {shared_.openCase.patient()->ct, shared_.labeling.labels(), shared_.labeling.preview().proposal().get()};
}

void VesselSession::moveTo(int frame) {
  if (!course() || start_) return;
  frame_ = std::size_t(std::clamp(frame, 0, int(course()->frames().size()) - 1));
  moving_ = true;
  shared_.crosshair.moveTo(course()->frames()[frame_].center_mm);
  moving_ = false;
  Q_EMIT moved();
}

void VesselSession::rotate(double by_deg) {
  constexpr double kTurn = 2 * std::numbers::pi;
  angle_rad_ = std::fmod(angle_rad_ + by_deg * kTurn / 360 + kTurn, kTurn);
  Q_EMIT rotated();
}

double VesselSession::reach_mm() const {
  return outlineReach_mm(shared_.labeling.labels().geometry, course()->frames()[frame_].along);
}

VesselOutline VesselSession::outlineAt(std::size_t frame) const {
  return outlineOf(shared_.labeling.labels(), label_, course()->frames()[frame]);
}

VesselOutline VesselSession::outline() const {
  return dragged_ ? *dragged_ : outlineAt(frame_);
}

bool VesselSession::beginDrag() {
  if (!course() || start_) return false;
  if (shared_.labeling.isBusy()) {
    shared_.notice.showMessage(tr("A tool is running; wait for it or cancel it first."));
    return false;
  }
  if (!shared_.labeling.rules().mayEdit(label_)) {
    shared_.notice.showMessage(
        tr("%1 is locked or hidden; unlock or show it to edit it.").arg(shared_.terms.nameOf(label_)));
    return false;
  }
  shared_.labeling.getReady();
  start_ = outlineAt(frame_);
  return true;
}

LabelStep VesselSession::draggedStep() const {
  LabelStep step;
  step.tool = step::Outline{outlineStep(*course(), frame_, *dragged_, reach_mm())};
  step.label = label_;
  step.rest = LabelStep::kSurroundings;
  return step;
}

void VesselSession::drag(int ray, double radius_mm) {
  if (!start_ || writing_) return;
  dragged_ = dragged(*start_, ray, radius_mm);
  shared_.labeling.wantPreview(draggedStep());
  Q_EMIT outlineDragged();
}

void VesselSession::endDrag() {
  if (!start_ || writing_) return;
  if (!dragged_) return start_.reset();
  const QString what = tr("Outline %1").arg(shared_.terms.nameOf(label_));
  writing_ = true;
  shared_.labeling.run(draggedStep(), what, [self = QPointer(this), what](const Result<LabelChange>& change) {
    if (!self) return;
    self->writing_ = false;
    self->start_.reset(), self->dragged_.reset();
    if (change) self->shared_.notice.showMessage(tr("%1: changed; Ctrl+Z undoes it.").arg(what));
    Q_EMIT self->outlineDragged();
  });
}

}  // namespace insonate::prepare
