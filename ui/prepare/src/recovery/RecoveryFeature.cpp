#include "RecoveryFeature.h"

#include "../labels/LabelSession.h"
#include "../layout/PrepareLayout.h"
#include "../model/CaseChanges.h"
#include "../model/CasePlaces.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "../model/StructureAppearance.h"
#include "../model/TermsEditor.h"
#include "CaseFolder.h"
#include "RestoreQuestion.h"
#include "UnsavedKeeper.h"

#include <insonate/core/ThreadPriority.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Text.h>

#include <QApplication>
#include <QEvent>
#include <QPointer>
#include <QTimer>
#include <QUndoCommand>
#include <QtConcurrent/QtConcurrentRun>
#include <memory>
#include <utility>

namespace insonate::prepare {
namespace {

constexpr int kUntilFree_ms = 500;

/// The looks after the case's colors and display settings were replaced by these.
StructureLooks looksWith(StructureLooks looks, const LabelColors& colors, const ShownStructures& shown) {
  for (int label = 1; label < 256; ++label) {
    const auto value = std::uint8_t(label);
    looks[value].color = viewColor(caseLabelColor(colors, value));
  }
  takeShown(shown, looks);
  return looks;
}

}  // namespace

RecoveryFeature::RecoveryFeature(PrepareModel& model, PrepareLayout& layout)
    : Feature(model, layout), keeper_(*new UnsavedKeeper(model, this)) {
  connect(&model_.openCase, &OpenCase::shown, this, &RecoveryFeature::lookAtCase);
  connect(&looking_, &QFutureWatcherBase::finished, this, &RecoveryFeature::found);
  connect(&keeper_, &UnsavedKeeper::failed, &model_.notice, &Notice::showMessage);
  layout_.workspace().installEventFilter(this);
}

RecoveryFeature::~RecoveryFeature() = default;

void RecoveryFeature::keepIn(const QString& folder) {
  root_ = folder.toStdString();
  keeper_.keepIn(root_);
  look();
}

bool RecoveryFeature::eventFilter(QObject* workspace, QEvent* event) {
  if (event->type() == QEvent::Show) QTimer::singleShot(0, this, &RecoveryFeature::look);
  return Feature::eventFilter(workspace, event);
}

void RecoveryFeature::lookAtCase() {
  lookedAt_ = nullptr;
  const auto& patient = model_.openCase.patient();
  if (copied_ && patient && patient == copy_) {
    lookedAt_ = patient;
    copy_ = nullptr;
    return restoreWork(*std::exchange(copied_, nullptr));
  }
  copied_ = nullptr, copy_ = nullptr;
  look();
}

void RecoveryFeature::look() {
  const auto& patient = model_.openCase.patient();
  if (root_.empty() || !patient || lookedAt_ == patient || !layout_.workspace().isVisible()) return;
  lookedAt_ = patient;
  KeptWorkQuery query{root_, folderOf(model_.openCase.origin()).toStdString(), patient, asksOthers_};
  looking_.setFuture(QtConcurrent::run(&keeper_.thread(), [query = std::move(query)] {
    lowerThreadPriority();
    return std::make_shared<KeptWorkResult>(findKeptWork(query));
  }));
}

void RecoveryFeature::found() {
  if (looking_.isRunning() || lookedAt_ != model_.openCase.patient()) return;
  if (!layout_.workspace().isVisible()) return lookedAt_.reset();
  // Another question has precedence.
  if (QApplication::activeModalWidget()) return QTimer::singleShot(kUntilFree_ms, this, &RecoveryFeature::found);
  const std::shared_ptr<KeptWorkResult> result = looking_.result();
  if (!result) return;
  if (!result->problems.isEmpty())
    Q_EMIT layout_.workspace().failed(tr("Unsaved work could not be restored."),
                                      std::exchange(result->problems, {}).join(QLatin1Char('\n')), {});
  const std::filesystem::path chosen = std::exchange(accepted_, {});
  if (!result->latest) {
    asksOthers_ = false;
    return;
  }
  const KeptWork kept = *std::exchange(result->latest, {});
  if (kept.isHere && !kept.wasChanged && kept.folder->path() == chosen) return restoreWork(kept);
  ask(kept);
}

void RecoveryFeature::ask(const KeptWork& kept) {
  auto* question = new RestoreQuestion(kept, &layout_.workspace());
  connect(question, &RestoreQuestion::restoreChosen, this, [this, kept] { accept(kept); });
  connect(question, &RestoreQuestion::discardChosen, this, [this, kept] { discard(kept); });
  connect(question, &RestoreQuestion::laterChosen, this, [this] { asksOthers_ = false; });
  question->open();
}

void RecoveryFeature::accept(const KeptWork& kept) {
  asksOthers_ = false;
  kept.isHere ? restoreWork(kept) : openCase(kept);
}

void RecoveryFeature::openCase(const KeptWork& kept) {
  if (!kept.work.folder.empty()) {
    accepted_ = kept.folder->path();
    // The question, which holds the lock of the folder, must have ended before the case is open.
    return QTimer::singleShot(
        0, this, [this, folder = ui::qt(kept.work.folder)] { Q_EMIT layout_.workspace().caseRequested(folder); });
  }
  using Read = std::shared_ptr<const PatientCase>;
  layout_.workspace().tasks().run<Read>(
      tr("Reading the kept case"),
      [kept](const Progress&) -> Result<Read> {
        auto read = readCase(kept.folder->caseCopy());
        if (!read) return tl::unexpected(read.error());
        if (sumsOf(read->patient) != kept.work.sums) return fail("The kept copy of the case is damaged.");
        return std::make_shared<const PatientCase>(std::move(read->patient));
      },
      [self = QPointer(this), kept](const Result<Read>& read) {
        if (!self || (!read && read.error().message == kCancelled)) return;
        self->openCopy(kept, read);
      });
}

void RecoveryFeature::openCopy(const KeptWork& kept, const Result<std::shared_ptr<const PatientCase>>& read) {
  if (read && model_.changes.isUnsaved())
    return model_.notice.showMessage(tr("Not restored: save the open case first, and start Insonate again."));
  if (!read) return giveUp(kept, read.error());
  copied_ = std::make_shared<const KeptWork>(kept);
  copy_ = *read;
  Q_EMIT layout_.workspace().caseMade(*read);
}

void RecoveryFeature::restoreWork(const KeptWork& kept) {
  using Made = std::shared_ptr<const KeptLabels>;
  const auto patient = model_.openCase.patient();
  layout_.workspace().tasks().run<Made>(
      tr("Restoring unsaved work"),
      [kept, patient](const Progress&) -> Result<Made> {
        auto labels = labelsOf(kept.work, *patient);
        if (!labels) return tl::unexpected(labels.error());
        return std::make_shared<const KeptLabels>(std::move(*labels));
      },
      [self = QPointer(this), kept, patient](const Result<Made>& made) {
        if (!self || patient != self->model_.openCase.patient()) return;
        if (made) return self->apply(kept, **made);
        if (made.error().message != kCancelled) self->giveUp(kept, made.error());
      });
}

void RecoveryFeature::giveUp(const KeptWork& kept, const Error& why) {
  const std::filesystem::path aside = kept.folder->setAside();
  Q_EMIT layout_.workspace().failed(tr("Unsaved work could not be restored: %1").arg(ui::qt(why.message)),
                                    tr("The files were set aside in %1.").arg(ui::qt(aside.string())), {});
}

void RecoveryFeature::apply(const KeptWork& kept, const KeptLabels& labels) {
  if (labels.labels) model_.labeling.restore(labels.labels, labels.recipe.steps, labels.change);
  CaseManifest manifest = model_.openCase.patient()->manifest;
  LabelColors colors = model_.openCase.patient()->colors;
  applyValues(kept.work, manifest, colors);
  auto all = std::make_unique<QUndoCommand>();
  model_.openCase.restoreTitle(ui::qt(manifest.title), *all);
  model_.terms.restore(termsOf(manifest), *all);
  model_.places.restore(placesOf(manifest), *all);
  model_.appearance.restore(looksWith(model_.appearance.looks(), colors, manifest.shown), *all);
  QUndoStack& undo = model_.openCase.undoStack();
  undo.push(all.release());
  undo.clear();
  keeper_.adopt(kept.folder, kept.work, !kept.wasChanged && !kept.work.hasAllLabels);
  model_.notice.showMessage(tr("The unsaved work is restored. Ctrl+S saves the case."));
}

void RecoveryFeature::discard(const KeptWork& kept) {
  QtConcurrent::run(&keeper_.thread(), [folder = kept.folder] { folder->remove(); });
  // There may be more work.
  lookedAt_ = nullptr;
  look();
}

}  // namespace insonate::prepare
