#include "LabelSession.h"

#include <insonate/ui/TaskBar.h>

#include <tbb/parallel_for_each.h>

#include <QPointer>
#include <QUndoCommand>
#include <QtConcurrent/QtConcurrentRun>
#include <functional>
#include <string>
#include <utility>

namespace insonate::prepare {
namespace {

/// A labeling step as a command of the undo stack; the edits of one step of the guide are one command. Their changes
/// are in LabelEdit, in the same order.
class LabelCommand : public QUndoCommand {
 public:
  /// `undo` and `redo` apply to one recorded step; `undo` returns false if the step was discarded. `of`: the step of
  /// the guide; empty for none.
  LabelCommand(std::function<bool()> undo, std::function<void()> redo, const QString& name, std::string of)
      : QUndoCommand(name), undo_(std::move(undo)), redo_(std::move(redo)), of_(std::move(of)) {}
  void undo() override;
  void redo() override;
  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* next) override;

 private:
  std::function<bool()> undo_;
  std::function<void()> redo_;
  std::string of_;
  int steps_ = 1;
  bool isDone_ = true;  ///< the tool has done it before the command was made
};

void LabelCommand::undo() {
  int undone = 0;
  while (undone < steps_ && undo_()) ++undone;
  if (undone == steps_) return;
  // If it fails, nothing changes, and the stack drops the command.
  for (; undone > 0; --undone) redo_();
  setObsolete(true);
}

void LabelCommand::redo() {
  if (std::exchange(isDone_, false)) return;
  for (int step = 0; step < steps_; ++step) redo_();
}

bool LabelCommand::mergeWith(const QUndoCommand* next) {
  const auto& other = static_cast<const LabelCommand&>(*next);
  if (of_.empty() || of_ != other.of_) return false;
  steps_ += other.steps_;
  return true;
}

/// Tells whether a tool writes LabelStep::label. The other tools find the labels that they write by themselves.
bool writesItsLabel(const LabelTool& tool) {
  return !std::holds_alternative<step::Auto>(tool) && !std::holds_alternative<step::GrowSeeds>(tool) &&
         !std::holds_alternative<step::Watershed>(tool) && !std::holds_alternative<step::SmoothTogether>(tool);
}

}  // namespace

LabelSession::LabelSession(ui::TaskBar& tasks, QUndoStack& undo, QObject* parent)
    : QObject(parent), tasks_(tasks), undo_(undo), preview_(this) {
  connect(&preview_, &LabelPreview::failed, this, &LabelSession::failed);
  connect(&writing_, &QFutureWatcher<Result<LabelChange>>::finished, this, [this] { finishWriting(); });
}

LabelSession::~LabelSession() {
  // Writes to the working map, for a fraction of a second.
  writing_.waitForFinished();
}

void LabelSession::discardEdits() {
  settle();
  preview_.clear();
  endStroke();
  edit_ = nullptr, snapshots_ = nullptr, working_ = nullptr, before_ = nullptr;
  ready_.reset();
  restored_.clear(), steps_.clear(), undone_.clear();
  first_ = ++states_;
}

void LabelSession::setCase(std::shared_ptr<const PatientCase> patient) {
  discardEdits();
  saved_ = first_;
  patient_ = std::move(patient);
  rules_ = {};
  Q_EMIT caseSet();
  Q_EMIT seenChanged();
  Q_EMIT rulesChanged();
}

void LabelSession::replaceCase(std::shared_ptr<const PatientCase> patient) {
  patient_ = std::move(patient);
  if (!working_) return;
  edit_->setCt(patient_->ct);
  // Edits made during the writing are not in it.
  if (labels().voxels == patient_->labels.voxels) saved_ = state();
}

std::shared_ptr<const LabelMap> LabelSession::seen() const {
  if (before_) return before_;
  if (working_ || !patient_) return working_;
  return {patient_, &patient_->labels};
}

std::shared_ptr<const LabelMap> LabelSession::snapshot() {
  if (before_) return before_;
  return working_ ? snapshots_->take() : seen();
}

std::shared_ptr<const LabelMap> LabelSession::snapshotIfCheap() {
  return working_ && !before_ ? snapshots_->takeIfCheap() : seen();
}

void LabelSession::setRules(const LabelRules& rules) {
  rules_ = rules;
  Q_EMIT rulesChanged();
}

void LabelSession::setLocked(std::uint8_t label, bool locked) {
  LabelRules rules = rules_;
  rules.locked.set(label, locked);
  setRules(rules);
}

void LabelSession::setBusy(bool busy) {
  if (busy == std::exchange(busy_, busy)) return;
  Q_EMIT busyChanged();
}

void LabelSession::getReady() {
  if (!patient_ || working_ || ready_) return;
  copy({patient_, &patient_->labels});
}

void LabelSession::copy(std::shared_ptr<const LabelMap> labels) {
  ready_ = QtConcurrent::run([labels = std::move(labels)] {
    auto copies = std::make_shared<Copies>(Copies{std::make_shared<LabelMap>(), {}});
    std::vector<LabelMap*> all{copies->working.get()};
    for (LabelMap& snapshot : copies->snapshots) all.push_back(&snapshot);
    tbb::parallel_for_each(all, [&](LabelMap* copy) { *copy = *labels; });
    return copies;
  });
}

void LabelSession::restore(std::shared_ptr<const LabelMap> labels, std::vector<LabelStep> steps,
                           const LabelChange& change) {
  discardEdits();
  copy(std::move(labels));
  beginWork();
  restored_ = std::move(steps);
  Q_EMIT restored();
  Q_EMIT changed(change);
}

void LabelSession::beginWork() {
  if (working_) return;
  getReady();
  const std::shared_ptr<Copies> copies = ready_->result();
  ready_.reset();
  working_ = std::move(copies->working);
  edit_ = std::make_unique<LabelEdit>(patient_->ct, *working_);
  snapshots_ = std::make_unique<LabelSnapshots>(*working_, std::move(copies->snapshots));
  Q_EMIT seenChanged();
}

void LabelSession::wantPreview(LabelStep step) {
  if (!patient_ || busy_) return;
  preview_.want(withRules(std::move(step), rules_), {patient_, &patient_->ct}, snapshot());
}

void LabelSession::run(LabelStep step, const QString& name, Done done) {
  if (const QString why = refusal(step); !why.isEmpty()) {
    Q_EMIT failed(why);
    if (done) done(fail(why.toStdString()));
    return;
  }
  start(withRules(std::move(step), rules_), name, std::move(done));
}

void LabelSession::runAgain(LabelStep step, const QString& name, Done done) {
  start(std::move(step), name, std::move(done));
}

bool LabelSession::isFree() const {
  return !busy_ && !tasks_.isRunning();
}

void LabelSession::start(LabelStep step, const QString& name, Done done) {
  endStroke();
  preview_.clear();
  beginWork();
  setBusy(true);
  using Made = std::shared_ptr<const Proposal>;
  tasks_.run<Made>(
      name,
      [step, ct = std::shared_ptr<const CtVolume>(patient_, &patient_->ct),
       labels = snapshot()](const Progress& progress) -> Result<Made> {
        auto made = propose(step, *ct, *labels, progress);
        if (!made) return tl::unexpected(made.error());
        return std::make_shared<const Proposal>(std::move(*made));
      },
      [self = QPointer(this), step, name, done](Result<Made> made) {
        if (!self) return;
        if (made) return self->write(step, name, std::move(*made), done);
        self->setBusy(false);
        if (made.error().message != kCancelled) Q_EMIT self->failed(QString::fromStdString(made.error().message));
        if (done) done(tl::unexpected(made.error()));
      },
      ui::TaskBar::WhenClosed::Ask);
}

void LabelSession::write(LabelStep step, QString name, std::shared_ptr<const Proposal> proposal, Done done) {
  before_ = snapshots_->take();
  Q_EMIT seenChanged();
  edit_->rules = rulesOf(step);
  atWork_ = Writing{std::move(step), name, std::move(done)};
  writing_.setFuture(QtConcurrent::run([edit = edit_.get(), proposal = std::move(proposal), text = name.toStdString()] {
    return edit->apply(*proposal, text);
  }));
}

void LabelSession::endWriting() {
  before_ = nullptr;
  atWork_.reset();
  setBusy(false);
  Q_EMIT seenChanged();
}

void LabelSession::finishWriting() {
  if (!atWork_) return;
  const Writing writing = *atWork_;
  const Result<LabelChange> change = writing_.result();
  if (change) snapshots_->changed(change->box);
  endWriting();
  if (!change) {
    Q_EMIT failed(QString::fromStdString(change.error().message));
  } else if (change->voxels > 0) {
    record(writing.step, writing.name);
    Q_EMIT changed(*change);
  }
  if (writing.done) writing.done(change);
}

/// Cancels the work of a tool; the labels are as they were before.
void LabelSession::settle() {
  if (!busy_) return;
  if (!atWork_) return tasks_.cancel();
  writing_.waitForFinished();
  const Done done = atWork_->done;
  if (const Result<LabelChange> change = writing_.result(); change && change->voxels > 0) edit_->undo();
  endWriting();
  if (done) done(fail(std::string(kCancelled)));
}

void LabelSession::record(LabelStep step, const QString& name) {
  undone_.clear();
  auto* made = new LabelCommand([this] { return undo(); }, [this] { redo(); }, name, step.of);
  steps_.push_back({std::move(step), ++states_});
  undo_.push(made);
}

void LabelSession::announce(const LabelChange& change) {
  snapshots_->changed(change.box);
  Q_EMIT changed(change);
}

bool LabelSession::undo() {
  settle();
  endStroke();
  if (edit_->undoSteps() == 0) {
    Q_EMIT failed(tr("Older changes cannot be undone: they were discarded to save memory."));
    return false;
  }
  undone_.push_back(std::move(steps_.back()));
  steps_.pop_back();
  announce(edit_->undo());
  return true;
}

void LabelSession::redo() {
  settle();
  endStroke();
  steps_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  announce(edit_->redo());
}

QString LabelSession::refusal(const LabelStep& step) const {
  if (!patient_) return tr("There is no case to label; open a case first.");
  if (busy_) return tr("A tool is running; wait for it or cancel it first.");
  if (!writesItsLabel(step.tool)) return {};
  if (rules_.locked.test(step.label))
    return tr("The label %1 is locked; unlock it to edit it.").arg(names_(step.label));
  if (rules_.hidden.test(step.label)) return tr("The label %1 is hidden; show it to edit it.").arg(names_(step.label));
  return {};
}

bool LabelSession::beginStroke(LabelStep step, const QString& name) {
  if (const QString why = refusal(step); !why.isEmpty()) {
    Q_EMIT failed(why);
    return false;
  }
  endStroke();
  preview_.clear();
  beginWork();
  stroke_ = withRules(std::move(step), rules_);
  std::get<step::Paint>(stroke_->tool).points_mm.clear();
  strokeName_ = name, strokeRecorded_ = false;
  edit_->beginStroke(name.toStdString());
  return true;
}

void LabelSession::strokeTo(Vec3 patient_mm) {
  if (!stroke_ || !isFinite(patient_mm)) return;
  auto& all_mm = std::get<step::Paint>(stroke_->tool).points_mm;
  all_mm.push_back(patient_mm);
  LabelStep dab = *stroke_;
  if (all_mm.size() > 2) std::get<step::Paint>(dab.tool).points_mm.assign(all_mm.end() - 2, all_mm.end());
  const auto change = perform(dab, *edit_);
  if (!change || change->voxels == 0) return;
  if (!std::exchange(strokeRecorded_, true)) record(*stroke_, strokeName_);
  announce(*change);
}

void LabelSession::endStroke() {
  if (!stroke_) return;
  if (strokeRecorded_) steps_.back().step = std::move(*stroke_);
  stroke_.reset();
  edit_->endStroke();
}

Recipe LabelSession::recipe() const {
  return recipeAfter(-1);
}

Recipe LabelSession::unsavedRecipe() const {
  return recipeAfter(saved_);
}

Recipe LabelSession::recipeAfter(int state) const {
  Recipe recipe;
  if (first_ > state) recipe.steps = restored_;
  for (const Step& step : steps_)
    if (step.state > state) recipe.steps.push_back(step.step);
  // A stroke is recorded at its first change, and its points are complete at its end.
  if (stroke_ && strokeRecorded_ && !recipe.steps.empty()) recipe.steps.back() = *stroke_;
  return recipe;
}

}  // namespace insonate::prepare
