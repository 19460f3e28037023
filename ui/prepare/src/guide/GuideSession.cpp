#include "GuideSession.h"

#include "../labels/LabelSession.h"
#include "../model/CaseMeasuring.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PlaceProposing.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "../model/TermsEditor.h"
#include "../model/VesselNaming.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/tissue/Labels.h>

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <filesystem>
#include <memory>

namespace insonate::prepare {
namespace {

constexpr const char* kRecipeFile = "recipe.json";

constexpr const char* kPlacesStep = "places";

/// The labeling steps, and the places that training needs.
Guide neckGuide() {
  // The guide is compiled in, and a test reads it.
  Guide guide = *readGuide(guidePresets().front().text);
  GuideStep places;
  places.name = kPlacesStep;
  places.title = GuideSession::tr("Target and start poses").toStdString();
  places.instruction = GuideSession::tr(
                           "Click Propose. The program proposes a target in the vein, a transverse and a longitudinal "
                           "start pose of the probe over the target, and the puncture site. The vein must be labeled "
                           "and have a name; Accept gives it its name. If trainees shall also puncture the left vein, "
                           "label it first.")
                           .toStdString();
  places.lookFor = GuideSession::tr(
                       "The target lies in the middle of the vein, where it is wide and near the skin. The ultrasound "
                       "image begins over the target. Targets and landmarks, under Check, moves and removes places.")
                       .toStdString();
  // Training needs the places, but not the optional structures.
  guide.steps.insert(std::ranges::find(guide.steps, true, &GuideStep::optional), std::move(places));
  return guide;
}

/// An author's edits besides voxels: appearance and terms of structures, the title and the places.
struct AuthoredState {
  StructureLooks looks;
  QString title;
  CasePlaces places;
  LabelTerms terms;
};

AuthoredState authoredState(const PrepareModel& shared) {
  return {shared.appearance.looks(), shared.openCase.title(), shared.places.value(), shared.terms.value()};
}

/// Edits what differs from `state`, as one undoable step.
void restore(const AuthoredState& state, PrepareModel& shared) {
  auto all = std::make_unique<QUndoCommand>(GuideSession::tr("restore colors, title and marks"));
  shared.appearance.restore(state.looks, *all);
  shared.openCase.restoreTitle(state.title, *all);
  shared.places.restore(state.places, *all);
  shared.terms.restore(state.terms, *all);
  if (all->childCount() > 0) shared.openCase.undoStack().push(all.release());
}

/// A scan that shows only a short piece of a vessel has no center line, wherever the author clicks.
bool hasCourse(const std::vector<Vec3>& clicks_mm) {
  constexpr double kShort_mm = 20;
  return clicks_mm.size() > 1 && norm(clicks_mm.back() - clicks_mm.front()) > kShort_mm;
}

/// All labels that a step makes.
std::vector<std::uint8_t> labelsOf(const GuideStep& step) {
  std::vector<std::uint8_t> labels = step.makes;
  if (step.label != kBackground) labels.push_back(step.label);
  return labels;
}

bool hasObstacle(const std::vector<GuideFinding>& findings) {
  return std::ranges::any_of(findings, [](const GuideFinding& finding) { return !finding.canBeAccepted; });
}

}  // namespace

bool GuideSession::StepProgress::isWrong() const {
  return hasObstacle(findings);
}

GuideSession::GuideSession(PrepareModel& shared, QObject* parent)
    : QObject(parent),
      shared_(shared),
      guide_(neckGuide()),
      replay_(*new StepReplay(shared.labeling, shared.openCase.undoStack(), this)),
      progress_(guide_.steps.size()) {
  const LabelSession& labels = shared_.labeling;
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { beginCase(); });
  connect(&shared_.openCase, &OpenCase::saved, this, [this] { saveRecipe(); });
  connect(&labels, &LabelSession::restored, this, [this] { takeUp(shared_.labeling.recipe()); });
  connect(&labels, &LabelSession::changed, this, [this] {
    recipe_ = shared_.labeling.recipe();
    findWarningsAgain();
    Q_EMIT changed();
  });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { beginAtFirstToDo(); });
  connect(&labels, &LabelSession::busyChanged, this, &GuideSession::changed);
  connect(&shared_.places, &PlacesEditor::changed, this, &GuideSession::changed);
  connect(&shared_.terms, &TermsEditor::changed, this, &GuideSession::changed);
  connect(&shared_.proposing, &PlaceProposing::runningChanged, this, &GuideSession::changed);
  connect(&labels, &LabelSession::failed, this, &GuideSession::messageReported);
}

void GuideSession::beginCase() {
  replay_.forget();
  progress_.assign(guide_.steps.size(), {});
  before_ = recipe_ = {}, working_ = -1, current_ = 0, correcting_ = begun_ = false;
  takeUpRecipe();
  goToNext();
}

/// The recipe of the last save contains the author's progress and the clicks.
void GuideSession::takeUpRecipe() {
  const QString folder = shared_.openCase.origin().folder;
  if (folder.isEmpty() || !shared_.openCase.patient() || !recipe_.steps.empty() || !before_.steps.empty()) return;
  const std::filesystem::path file = std::filesystem::path(folder.toStdString()) / kRecipeFile;
  if (!std::filesystem::exists(file)) return;
  auto read = loadRecipe(file.string());
  if (!read) return Q_EMIT messageReported(QString::fromStdString(read.error().message));
  before_ = std::move(*read);
  takeUp(before_);
}

void GuideSession::takeUp(const Recipe& recipe) {
  for (std::size_t n = 0; n < guide_.steps.size(); ++n) {
    const GuideStep& step = guide_.steps[n];
    if (std::ranges::find(recipe.steps, step.name, &LabelStep::of) == recipe.steps.end()) continue;
    progress_[n].restored = true;
    progress_[n].clicks_mm = clicksOf(step, recipe);
    if (!step.vessel.empty()) findWarnings(int(n));
  }
  goToNext();
}

/// The labels of the import are known only once the case has been measured.
void GuideSession::beginAtFirstToDo() {
  if (!shared_.measuring.measures() || std::exchange(begun_, true)) return Q_EMIT changed();
  if (recipe_.steps.empty() && clicks_mm().empty()) goToNext();
}

void GuideSession::go(int index) {
  if (index < 0 || index >= int(progress_.size()) || index == current_) return;
  current_ = index;
  setCorrecting(false);
  Q_EMIT changed();
  Q_EMIT clicksChanged();
}

bool GuideSession::goToStepFor(std::uint8_t label) {
  const auto step = std::ranges::find_if(guide_.steps, [label](const GuideStep& one) {
    return one.label == label || std::ranges::find(one.makes, label) != one.makes.end();
  });
  if (step == guide_.steps.end()) return false;
  go(int(step - guide_.steps.begin()));
  return true;
}

GuideSession::Span GuideSession::spanOf(int index) const {
  const std::string& name = guide_.steps[std::size_t(index)].name;
  const auto& all = recipe_.steps;
  const auto first = std::ranges::find(all, name, &LabelStep::of);
  const auto last = std::find_if(first, all.end(), [&](const LabelStep& step) { return step.of != name; });
  return {std::size_t(first - all.begin()), std::size_t(last - first)};
}

/// Undo and redo remove and restore the result of a step.
bool GuideSession::isMade(int index) const {
  const std::size_t made = progress_[std::size_t(index)].made;
  return made > 0 && spanOf(index).count == made;
}

bool GuideSession::proposesPlaces(int index) const {
  return guide_.steps[std::size_t(index)].name == kPlacesStep;
}

/// The import has made this label, or the case has these places.
bool GuideSession::isThere(int index) const {
  if (proposesPlaces(index)) return shared_.proposing.isDone();
  const auto& makes = guide_.steps[std::size_t(index)].makes;
  return !makes.empty() &&
         std::ranges::all_of(makes, [this](std::uint8_t label) { return shared_.measuring.hasVoxels(label); });
}

GuideSession::State GuideSession::state(int index) const {
  const StepProgress& p = progress_[std::size_t(index)];
  if (index == working_ || (proposesPlaces(index) && shared_.proposing.isRunning())) return State::Working;
  if (isMade(index)) return p.findings.empty() || (p.accepted && !p.isWrong()) ? State::Done : State::Warning;
  if (p.restored) return p.isWrong() ? State::Warning : State::Done;
  if (isThere(index)) return State::Done;
  return p.skipped ? State::Skipped : State::ToDo;
}

std::optional<LabelState> GuideSession::labelState(int index) const {
  if (state(index) != State::Done) return std::nullopt;
  std::optional<LabelState> least;
  for (const std::uint8_t label : labelsOf(guide_.steps[std::size_t(index)]))
    if (const LabelState one = shared_.terms.stateOf(label); !least || one < *least) least = one;
  // The list shows new voxels only once they are measured.
  return least ? std::max(*least, LabelState::InProgress) : least;
}

/// The list of structures then shows what the guide shows. A label that the author has flagged stays flagged.
void GuideSession::completeLabels() {
  LabelTerms terms = shared_.terms.value();
  for (const std::uint8_t label : labelsOf(step()))
    if (shared_.terms.stateOf(label) != LabelState::Flagged) terms.states[label] = LabelState::Completed;
  if (terms != shared_.terms.value())
    shared_.terms.set(std::move(terms), tr("complete %1").arg(QString::fromStdString(step().title)));
}

bool GuideSession::continues() const {
  const bool led = std::ranges::any_of(progress_, &StepProgress::restored);
  for (int n = 0; led && n < int(progress_.size()); ++n)
    if (!guide_.steps[std::size_t(n)].optional && state(n) == State::ToDo) return true;
  return false;
}

QStringList GuideSession::remarks(int index) const {
  const StepProgress& p = progress_[std::size_t(index)];
  QStringList words;
  for (const GuideFinding& finding : p.findings)
    // The author has accepted the others before the case was saved.
    if (isMade(index) || !finding.canBeAccepted) words << QString::fromStdString(finding.text);
  if (isMade(index)) return p.caution.isEmpty() ? words : words + QStringList{p.caution};
  if (p.restored)
    return words.isEmpty() ? QStringList{tr("This step was completed before the case was opened.")} : words;
  if (isThere(index))
    return proposesPlaces(index) ? QStringList{} : QStringList{tr("The case has these labels already.")};
  const std::uint8_t label = guide_.steps[std::size_t(index)].label;
  if (label != kBackground && shared_.measuring.hasVoxels(label) && before_.steps.empty() && recipe_.steps.empty())
    return {tr("The case already contains the label %1. Look at this label in the slices first: you may not need this "
               "step.")
                .arg(shared_.terms.nameOf(label))};
  return {};
}

void GuideSession::setShown(bool shown) {
  if (shown == std::exchange(shown_, shown)) return;
  Q_EMIT clicksChanged();
}

std::vector<Vec3> GuideSession::shownClicks_mm() const {
  return takesClicks() || isBusy() ? clicks_mm() : std::vector<Vec3>{};
}

void GuideSession::addClick(Vec3 patient_mm) {
  if (!takesClicks() || !isFinite(patient_mm)) return;
  progress_[std::size_t(current_)].clicks_mm.push_back(patient_mm);
  Q_EMIT clicksChanged();
  Q_EMIT changed();
}

void GuideSession::moveClick(std::size_t index, Vec3 patient_mm) {
  auto& all_mm = progress_[std::size_t(current_)].clicks_mm;
  if (!takesClicks() || index >= all_mm.size() || !isFinite(patient_mm)) return;
  all_mm[index] = patient_mm;
  Q_EMIT clicksChanged();
}

void GuideSession::removeClick(std::size_t index) {
  auto& all_mm = progress_[std::size_t(current_)].clicks_mm;
  if (!takesClicks() || index >= all_mm.size()) return;
  all_mm.erase(all_mm.begin() + std::ptrdiff_t(index));
  Q_EMIT clicksChanged();
  Q_EMIT changed();
}

bool GuideSession::isBusy() const {
  return replay_.isRunning() || shared_.labeling.isBusy();
}

bool GuideSession::canRun() const {
  if (proposesPlaces(current_)) return shared_.openCase.patient() && !isBusy() && !shared_.proposing.isRunning();
  // Until the case is measured, the guide does not know whether this step, which replaces all labels, was done before.
  if (step().clicks == 0 && !shared_.measuring.measures()) return false;
  return shared_.openCase.patient() && !isBusy() && int(clicks_mm().size()) >= clicksNeeded();
}

int GuideSession::clicksNeeded() const {
  const auto& patient = shared_.openCase.patient();
  return patient ? insonate::clicksNeeded(step(), clicks_mm(), patient->ct) : step().minClicks;
}

void GuideSession::run() {
  if (!shared_.openCase.patient() || isBusy()) return;
  if (proposesPlaces(current_)) return shared_.proposing.start();
  auto way = methodFor(step(), clicks_mm(), shared_.openCase.patient()->ct);
  if (!way) return Q_EMIT messageReported(QString::fromStdString(way.error().message));
  for (LabelStep& made : way->steps) made.of = step().name;
  setCorrecting(false);
  Q_EMIT messageReported({});
  const int index = current_;
  const Span before = isMade(index) ? spanOf(index) : Span{recipe_.steps.size(), 0};
  working_ = index;
  // Undoing an earlier step also undoes the terms set since then.
  const bool begun = replay_.run(
      std::move(way->steps), before.first, before.first + before.count, QString::fromStdString(step().title),
      [this, index, authored = authoredState(shared_), caution = QString::fromStdString(way->caution)](bool well) {
        restore(authored, shared_);
        if (well) progress_[std::size_t(index)].caution = caution;
        finished(index, well);
      });
  if (!begun) {
    working_ = -1;
    Q_EMIT messageReported(tr("This step is too old to be repeated. Correct its result with the brush."));
  }
  Q_EMIT changed();
}

void GuideSession::cancel() {
  if (working_ >= 0) shared_.labeling.cancel();
}

void GuideSession::finished(int index, bool well) {
  working_ = -1;
  recipe_ = shared_.labeling.recipe();
  if (well) {
    // An author who hid the labels to find the structure in the CT must see the result.
    shared_.slices.setLabelsShown(true);
    StepProgress& p = progress_[std::size_t(index)];
    p.made = spanOf(index).count;
    p.accepted = p.skipped = false;
    p.findings.clear();
    if (p.made == 0)
      Q_EMIT messageReported(p.clicks_mm.empty()
                                 ? tr("No voxel changed: all voxels already had this label.")
                                 : tr("No voxel changed. Check whether the clicks lie in the structure."));
    findWarnings(index);
  }
  Q_EMIT changed();
}

void GuideSession::findWarnings(int index) {
  const GuideStep& about = guide_.steps[std::size_t(index)];
  StepProgress& p = progress_[std::size_t(index)];
  p.look = ++looks_;
  QtConcurrent::run([self = QPointer(this), about, clicks_mm = p.clicks_mm, labels = shared_.labeling.snapshot(),
                     own = shared_.terms.value().own, index, look = p.look] {
    auto findings = checkGuideStep(about, clicks_mm, *labels);
    if (!about.vessel.empty() && hasCourse(clicks_mm) && !hasObstacle(findings))
      if (const auto vessel = vesselAt(*labels, own, clicks_mm, about.vessel); !vessel)
        findings.push_back({vessel.error().message +
                                " Without a course, the vessel gets no name, and a vein without a name is no target. "
                                "Correct the label or the clicks.",
                            false});
    QMetaObject::invokeMethod(qApp, [self, findings = std::move(findings), index, look] {
      if (!self || look != self->progress_[std::size_t(index)].look) return;
      self->progress_[std::size_t(index)].findings = findings;
      Q_EMIT self->changed();
    });
  });
}

void GuideSession::findWarningsAgain() {
  for (std::size_t n = 0; n < progress_.size(); ++n)
    if (progress_[n].isWrong() && !isBusy()) findWarnings(int(n));
}

void GuideSession::goToNext() {
  const int count = int(progress_.size());
  int next = current_;
  while (next < count && state(next) != State::ToDo) ++next;
  if (next == count) next = std::min(current_ + 1, count - 1);
  go(next);
  Q_EMIT changed();
  Q_EMIT clicksChanged();
}

bool GuideSession::canAccept() const {
  const State now = state(current_);
  return (now == State::Done || now == State::Warning) && !progress_[std::size_t(current_)].isWrong();
}

void GuideSession::accept() {
  if (!canAccept()) return;
  progress_[std::size_t(current_)].accepted = true;
  // The author may have edited the labels since the step was run.
  if (!step().vessel.empty()) findWarnings(current_);
  if (!step().vessel.empty() && isMade(current_))
    nameVesselAt(shared_, clicks_mm(), QString::fromStdString(step().vessel));
  completeLabels();
  goToNext();
  tellWhatIsLeft();
}

/// Without a step that is to do, accepting a step would change nothing visible.
void GuideSession::tellWhatIsLeft() {
  bool isOptionalLeft = false;
  for (int n = 0; n < int(progress_.size()); ++n) {
    if (state(n) != State::ToDo) continue;
    if (!guide_.steps[std::size_t(n)].optional) return;
    isOptionalLeft = true;
  }
  Q_EMIT messageReported(isOptionalLeft
                             ? tr("All required steps are done; the steps that are left are optional. Go on with them, "
                                  "or check and publish the case.")
                             : tr("All steps are done. Look at the findings under Check, save the case (Ctrl+S), and "
                                  "publish it."));
  Q_EMIT changed();
}

void GuideSession::skip() {
  if (isBusy()) return;
  progress_[std::size_t(current_)].skipped = true;
  goToNext();
}

void GuideSession::proceed() {
  const State now = state(current_);
  if (now == State::Done || now == State::Warning) return accept();
  run();
}

void GuideSession::setCorrecting(bool on) {
  if (on == correcting_) return;
  correcting_ = on;
  if (on) {
    LabelRules rules = shared_.labeling.rules();
    rules.locked.reset(step().label);
    rules.over = LabelRules::Over::Filling;
    shared_.labeling.setRules(rules);
    shared_.structures.select(step().label);
  }
  Q_EMIT changed();
  Q_EMIT clicksChanged();
}

void GuideSession::saveRecipe() {
  const QString folder = shared_.openCase.origin().folder;
  // Queried now, since a stroke has all its points only at its end.
  const Recipe made = shared_.labeling.recipe();
  if (folder.isEmpty() || made.steps.empty()) return;
  Recipe all = before_;
  all.description = "Steps that changed the imported labels of this case to the present labels, in this order.";
  all.labels = shared_.terms.value().own;
  all.steps.insert(all.steps.end(), made.steps.begin(), made.steps.end());
  const auto ok = writeAtomically(std::filesystem::path(folder.toStdString()) / kRecipeFile, textOf(all));
  if (!ok)
    shared_.notice.showMessage(tr("The case is saved, but the recipe with its labeling steps is not: %1")
                                   .arg(QString::fromStdString(ok.error().message)));
}

}  // namespace insonate::prepare
