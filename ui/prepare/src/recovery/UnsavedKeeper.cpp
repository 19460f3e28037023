#include "UnsavedKeeper.h"

#include "../labels/LabelSession.h"
#include "../model/CaseChanges.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/TermsEditor.h"
#include "CaseFolder.h"

#include <insonate/core/ThreadPriority.h>

#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <ctime>
#include <system_error>
#include <utility>
#include <variant>

namespace insonate::prepare {
namespace fs = std::filesystem;
namespace {

constexpr int kUntilCheap_ms = 200;

}  // namespace

struct UnsavedKeeper::Job {
  std::shared_ptr<Kept> kept;
  fs::path root;
  std::shared_ptr<const PatientCase> base;
  UnsavedWork work;
  Recipe recipe;
};

UnsavedKeeper::UnsavedKeeper(PrepareModel& model, QObject* parent) : QObject(parent), model_(model) {
  thread_.setMaxThreadCount(1);
  due_.setSingleShot(true);
  connect(&due_, &QTimer::timeout, this, &UnsavedKeeper::keep);
  connect(&writing_, &QFutureWatcher<Result<void>>::finished, this, &UnsavedKeeper::ended);
  connect(&model_.openCase, &OpenCase::shown, this, &UnsavedKeeper::begin);
  connect(&model_.openCase, &OpenCase::originChanged, this, [this] {
    caseFolder_ = folderOf(model_.openCase.origin());
    refresh();
  });
  connect(&model_.changes, &CaseChanges::edited, this, &UnsavedKeeper::refresh);
}

UnsavedKeeper::~UnsavedKeeper() {
  forget();
  thread_.waitForDone();
}

void UnsavedKeeper::keepIn(const fs::path& root) {
  root_ = root;
  refresh();
}

void UnsavedKeeper::begin() {
  // Imported labels replace the case by one that contains all edits so far.
  if (!model_.openCase.origin().labelsReplaced) forget();
  hasFailed_ = false;
  refresh();
}

bool UnsavedKeeper::isAtStake() const {
  const ui::CaseOrigin& origin = model_.openCase.origin();
  const bool isNowhere = caseFolder_.isEmpty() && !origin.builtIn;
  return model_.openCase.patient() && (model_.changes.isUnsaved() || origin.labelsReplaced || isNowhere);
}

void UnsavedKeeper::refresh() {
  if (root_.empty()) return;
  if (!isAtStake()) return forget();
  if (!waiting_) waiting_.emplace().start();
  due_.start(std::clamp(kLongest_ms - int(waiting_->elapsed()), 0, kAfterEdit_ms));
}

void UnsavedKeeper::forget() {
  due_.stop();
  waiting_.reset();
  if (!std::exchange(isKept_, false)) return;
  kept_->isOver = true;
  QtConcurrent::run(&thread_, [kept = std::exchange(kept_, std::make_shared<Kept>())] {
    if (kept->folder) kept->folder->remove();
  });
}

void UnsavedKeeper::adopt(std::shared_ptr<KeptFolder> folder, const UnsavedWork& work, bool isSameCase) {
  forget();
  kept_->folder = std::move(folder);
  if (isSameCase) {
    kept_->base = model_.openCase.patient();
    kept_->sums = work.sums;
    kept_->isCopied = work.folder.empty();
  }
  isKept_ = true;
  refresh();
}

void UnsavedKeeper::keep() {
  if (writing_.isRunning()) return;  // ended() starts the next one
  const OpenCase& open = model_.openCase;
  const bool hasLabels = model_.labeling.isChanged() || open.origin().labelsReplaced;
  auto labels = hasLabels ? model_.labeling.snapshotIfCheap() : nullptr;
  // The live image soon takes a snapshot, which is then used here, too.
  if (hasLabels && !labels) return due_.start(kUntilCheap_ms);
  waiting_.reset();
  Job job{kept_, root_, open.patient(), {}, model_.labeling.unsavedRecipe()};
  const auto strokes = std::ranges::count_if(
      job.recipe.steps, [](const LabelStep& step) { return std::holds_alternative<step::Paint>(step.tool); });
  job.recipe.labels = model_.terms.value().own;
  UnsavedWork& work = job.work;
  work.folder = caseFolder_.toStdString();
  work.time_s = std::int64_t(std::time(nullptr));
  work.strokes = int(strokes), work.steps = int(job.recipe.steps.size()) - work.strokes;
  work.hasAllLabels = open.origin().labelsReplaced;
  work.before = work.after = job.base->manifest;
  work.colorsBefore = work.colorsAfter = job.base->colors;
  model_.changes.putValues(work.after, work.colorsAfter);
  isKept_ = true;
  writing_.setFuture(QtConcurrent::run(&thread_, [job = std::move(job), labels = std::move(labels)]() mutable {
    lowerThreadPriority();
    return write(job, std::move(labels));
  }));
}

/// Takes the snapshot over, since a snapshot that is held long makes the next one slow.
Result<void> UnsavedKeeper::write(const Job& job, std::shared_ptr<const LabelMap> labels) {
  Kept& kept = *job.kept;
  if (kept.isOver) return {};
  UnsavedWork work = job.work;
  const std::vector<std::uint8_t> none;
  if (labels) work.runs = runsBetween(work.hasAllLabels ? none : job.base->labels.voxels, labels->voxels);
  labels = nullptr;
  if (!kept.folder) {
    auto made = KeptFolder::make(job.root);
    if (!made) return tl::unexpected(made.error());
    kept.folder = std::move(*made);
  }
  std::error_code error;
  if (std::exchange(kept.base, job.base) != job.base) {
    kept.sums = sumsOf(*job.base);
    kept.isCopied = false;
  }
  const Progress unlessOver = [&kept](std::string_view, double) { return !kept.isOver; };
  if (work.folder.empty() && !kept.isCopied) {
    if (auto ok = writeCase(*job.base, kept.folder->caseCopy(), unlessOver); !ok) return ok;
    kept.isCopied = true;
  } else if (!work.folder.empty()) {
    fs::remove_all(kept.folder->caseCopy(), error);
  }
  if (kept.isOver) return {};
  work.sums = kept.sums;
  if (!job.recipe.steps.empty()) work.recipe = textOf(job.recipe);
  return writeUnsavedWork(work, kept.folder->workFile());
}

void UnsavedKeeper::ended() {
  const Result<void> written = writing_.result();
  if (written) {
    hasFailed_ = false;
    Q_EMIT kept();
  } else if (written.error().message != kCancelled && !std::exchange(hasFailed_, true)) {
    Q_EMIT failed(QString::fromStdString(written.error().message));
  }
  if (waiting_ && !due_.isActive()) keep();
}

}  // namespace insonate::prepare
