#include "GuideSession.h"

#include "../PrepareSession.h"

#include <insonate/core/AtomicFile.h>

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>

namespace insonate::prepare {
namespace {

constexpr const char* kRecipeFile = "recipe.json";

Guide neckGuide() {
  // It is compiled in, and a test reads it.
  return *readGuide(guidePresets().front().text);
}

/// The points of a step that may be clicks.
const std::vector<Vec3>* pointsOf(const LabelTool& tool) {
  return std::visit(
      [](const auto& parameters) -> const std::vector<Vec3>* {
        if constexpr (requires { parameters.points_mm; }) return &parameters.points_mm;
        return nullptr;
      },
      tool);
}

}  // namespace

GuideSession::GuideSession(PrepareSession& session, QObject* parent)
    : QObject(parent),
      session_(session),
      guide_(neckGuide()),
      replay_(session.labelling(), session.undoStack()),
      progress_(guide_.steps.size()) {
  const LabelSession& labels = session_.labelling();
  connect(&session_, &PrepareSession::caseChanged, this, [this] { beginCase(); });
  connect(&session_, &PrepareSession::originChanged, this, [this] { takeUpRecipe(); });
  connect(&labels, &LabelSession::changed, this, [this] {
    recipe_ = session_.labelling().recipe();
    Q_EMIT changed();
  });
  connect(&labels, &LabelSession::busyChanged, this, &GuideSession::changed);
  connect(&labels, &LabelSession::failed, this, &GuideSession::told);
}

void GuideSession::beginCase() {
  replay_.forget();
  progress_.assign(guide_.steps.size(), {});
  before_ = recipe_ = {}, working_ = -1, current_ = 0, correcting_ = false;
  takeUpRecipe();
  goToNext();
}

/// What was recorded when the case was saved says how far the author was, and where the clicks were.
void GuideSession::takeUpRecipe() {
  const QString folder = session_.origin().folder;
  if (folder.isEmpty() || !recipe_.steps.empty() || !before_.steps.empty()) return;
  const std::filesystem::path file = std::filesystem::path(folder.toStdString()) / kRecipeFile;
  if (!std::filesystem::exists(file)) return;
  auto read = loadRecipe(file.string());
  if (!read) return Q_EMIT told(QString::fromStdString(read.error().message));
  before_ = std::move(*read);
  std::vector<bool> taken(before_.steps.size(), false);
  for (std::size_t n = 0; n < guide_.steps.size(); ++n)
    for (std::size_t m = 0; m < taken.size(); ++m) {
      const LabelStep& made = before_.steps[m];
      const auto fits = [&](const GuideWay& way) {
        return way.steps.front().tool.index() == made.tool.index() && way.steps.front().label == made.label;
      };
      if (taken[m] || !std::ranges::any_of(guide_.steps[n].ways, fits)) continue;
      taken[m] = progress_[n].restored = true;
      if (const auto* points_mm = pointsOf(made.tool)) progress_[n].clicks_mm = *points_mm;
      break;
    }
  goToNext();
}

void GuideSession::go(int index) {
  if (index < 0 || index >= int(progress_.size()) || index == current_) return;
  current_ = index;
  setCorrecting(false);
  Q_EMIT changed();
  Q_EMIT clicksChanged();
}

std::string GuideSession::textOfSteps(std::size_t first, std::size_t count) const {
  if (first + count > recipe_.steps.size()) return {};
  const auto begin = recipe_.steps.begin() + std::ptrdiff_t(first);
  return textOf(Recipe{{}, {begin, begin + std::ptrdiff_t(count)}});
}

/// Undone and redone, a step's result goes and comes.
bool GuideSession::isMade(int index) const {
  const StepProgress& p = progress_[std::size_t(index)];
  return p.made && p.made->count > 0 && textOfSteps(p.made->first, p.made->count) == p.made->text;
}

GuideSession::State GuideSession::state(int index) const {
  const StepProgress& p = progress_[std::size_t(index)];
  if (index == working_) return State::Working;
  if (isMade(index)) return p.doubts.isEmpty() || p.accepted ? State::Done : State::Doubtful;
  if (p.restored) return State::Done;
  return p.skipped ? State::Skipped : State::ToDo;
}

QStringList GuideSession::remarks(int index) const {
  const StepProgress& p = progress_[std::size_t(index)];
  if (isMade(index)) return p.doubts;
  return p.restored ? QStringList{tr("Made when the case was saved.")} : QStringList{};
}

void GuideSession::setShown(bool shown) {
  if (shown == std::exchange(shown_, shown)) return;
  Q_EMIT clicksChanged();
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
  return replay_.isRunning() || session_.labelling().isBusy();
}

bool GuideSession::canRun() const {
  return session_.patient() && !isBusy() && int(clicks_mm().size()) >= step().leastClicks;
}

void GuideSession::run() {
  if (!session_.patient() || isBusy()) return;
  auto steps = stepsFor(step(), clicks_mm(), session_.patient()->ct);
  if (!steps) return Q_EMIT told(QString::fromStdString(steps.error().message));
  setCorrecting(false);
  const int index = current_;
  const StepProgress& p = progress_[std::size_t(index)];
  const std::size_t end = recipe_.steps.size();
  const bool again = isMade(index);
  const std::size_t first = again ? p.made->first : end;
  working_ = index;
  const QString name = QString::fromStdString(step().title);
  const bool begun = replay_.run(std::move(*steps), first, again ? first + p.made->count : end, name,
                                 [this, index, first](const std::vector<std::size_t>& places, bool well) {
                                   finished(index, first, places, well);
                                 });
  if (!begun) {
    working_ = -1;
    Q_EMIT told(tr("This step lies too far back to be done again; correct its result with the brush."));
  }
  Q_EMIT changed();
}

void GuideSession::finished(int index, std::size_t first, const std::vector<std::size_t>& places, bool well) {
  working_ = -1;
  recipe_ = session_.labelling().recipe();
  StepProgress& p = progress_[std::size_t(index)];
  if (well) {
    const std::size_t oldEnd = p.made && p.made->first == first ? first + p.made->count : first;
    // Steps of the guide that were made again lie elsewhere now.
    for (StepProgress& other : progress_) {
      if (&other == &p || !other.made || other.made->first < oldEnd) continue;
      const std::size_t from = other.made->first - oldEnd, to = from + other.made->count;
      if (to >= places.size()) continue;
      other.made->first = places[from], other.made->count = places[to] - places[from];
      other.made->text = textOfSteps(other.made->first, other.made->count);
    }
    const std::size_t count = places.front() - first;
    p.made = Made{first, count, textOfSteps(first, count)};
    p.accepted = p.skipped = false;
    p.doubts.clear();
    if (count == 0) Q_EMIT told(tr("Nothing has changed: look whether the clicks lie in the structure."));
    lookForDoubts(index);
  }
  Q_EMIT changed();
}

void GuideSession::lookForDoubts(int index) {
  const GuideStep& about = guide_.steps[std::size_t(index)];
  const auto clicks_mm = progress_[std::size_t(index)].clicks_mm;
  const std::string text = progress_[std::size_t(index)].made->text;
  QtConcurrent::run([self = QPointer(this), about, clicks_mm, labels = session_.labelling().snapshot(), index, text] {
    QStringList doubts;
    for (const std::string& doubt : doubtsAbout(about, clicks_mm, *labels)) doubts << QString::fromStdString(doubt);
    QMetaObject::invokeMethod(qApp, [self, doubts, index, text] {
      if (!self) return;
      StepProgress& p = self->progress_[std::size_t(index)];
      if (!p.made || p.made->text != text) return;
      p.doubts = doubts;
      Q_EMIT self->changed();
    });
  });
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

void GuideSession::accept() {
  if (!isMade(current_) && !progress_[std::size_t(current_)].restored) return;
  progress_[std::size_t(current_)].accepted = true;
  goToNext();
}

void GuideSession::skip() {
  if (isBusy()) return;
  progress_[std::size_t(current_)].skipped = true;
  goToNext();
}

void GuideSession::proceed() {
  const State now = state(current_);
  if (now == State::Done || now == State::Doubtful) return accept();
  run();
}

void GuideSession::setCorrecting(bool on) {
  if (on == correcting_) return;
  correcting_ = on;
  if (on) {
    LabelRules rules = session_.labelling().rules();
    rules.locked.reset(step().label);
    rules.over = LabelRules::Over::Filling;
    session_.labelling().setRules(rules);
    session_.select(step().label);
  }
  Q_EMIT changed();
  Q_EMIT clicksChanged();
}

Result<void> GuideSession::saveRecipe(const std::filesystem::path& folder) const {
  // Asked for now: a stroke has all its points at its end only.
  const Recipe made = session_.labelling().recipe();
  if (made.steps.empty()) return {};
  Recipe all = before_;
  all.description = "What made the labels of this case out of those that its import gave, in this order.";
  all.steps.insert(all.steps.end(), made.steps.begin(), made.steps.end());
  return writeAtomically(folder / kRecipeFile, textOf(all));
}

}  // namespace insonate::prepare
