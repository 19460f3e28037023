// The part of the window that saves edits and asks before they are discarded.
#include "CaseExchange.h"
#include "HeaderBar.h"
#include "LossQuestion.h"
#include "StatusStrip.h"

#include <insonate/ui/Attempts.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/TaskBar.h>

#include <QAction>
#include <QTimer>
#include <utility>

namespace insonate::ui {

void MainWindow::open(const QString& path) {
  if (attemptRoom() && isAttemptFile(path)) return openAttempt(path);
  confirmDiscard(LostBy::Opening, [this, path] { loader_->open(path); });
}

void MainWindow::openTextbook() {
  openBuiltIn(builtInNames().front());
}

void MainWindow::openBuiltIn(const QString& variant) {
  confirmDiscard(LostBy::Opening, [this, variant] { loader_->openBuiltIn(variant); });
}

void MainWindow::reload() {
  if (!case_.folder.isEmpty()) open(case_.folder);
}

bool MainWindow::isWithoutFolder() const {
  return case_.patient && case_.folder.isEmpty() && !case_.builtIn && case_.versionOf.isEmpty();
}

std::vector<CaseEdit> MainWindow::unsavedEdits() const {
  std::vector<CaseEdit> edits;
  for (const Room& room : rooms_)
    if (CaseEdit edit = room.workspace->unsavedEdit()) edits.push_back(std::move(edit));
  return edits;
}

std::vector<CaseEdit> MainWindow::quietEdits() const {
  std::vector<CaseEdit> edits;
  for (const Room& room : rooms_)
    if (CaseEdit edit = room.workspace->quietEdit()) edits.push_back(std::move(edit));
  return edits;
}

void MainWindow::saveCase() {
  if (!case_.patient) return;
  if (case_.folder.isEmpty())
    chooseTarget();
  else
    saveTo(case_.folder);
}

void MainWindow::saveTo(const QString& folder) {
  std::vector<CaseEdit> edits = unsavedEdits();
  for (CaseEdit& edit : quietEdits()) edits.push_back(std::move(edit));
  const bool kept = folder == case_.folder;
  loader_->save(case_.patient, folder, std::move(edits), kept ? std::optional(case_.content) : std::nullopt);
}

void MainWindow::showSaved(const SavedCase& saved) {
  case_.folder = saved.folder;
  case_.builtIn = false;
  case_.versionOf.clear();
  case_.content = saved.content;
  const bool edited = saved.patient != std::exchange(case_.patient, saved.patient);
  rememberCase({saved.folder, QString::fromStdString(saved.patient->manifest.title)});
  for (const Room& room : rooms_) {
    room.workspace->setOrigin(origin());
    if (edited) room.workspace->caseSaved(saved.patient);
  }
  showTitle();
  const QString also = tr(" Another user had saved it meanwhile; that version is kept as an earlier one.");
  status_->say(tr("Saved to %1.").arg(saved.folder) + (saved.overAnother ? also : QString()));
  if (const auto go = std::exchange(afterSaving_, {})) QTimer::singleShot(0, this, go);
}

Loss MainWindow::loss() const {
  Loss loss;
  if (tasks_->asksWhenClosed()) loss.job = tasks_->title();
  for (const Room& room : rooms_)
    if (loss.ending.isEmpty()) loss.ending = room.workspace->endsWithTheCase();
  loss.nowhere = isWithoutFolder();
  if (loss.nowhere || !unsavedEdits().empty()) loss.title = QString::fromStdString(case_.patient->manifest.title);
  return loss;
}

void MainWindow::confirmDiscard(LostBy by, std::function<void()> go) {
  const Loss lost = loss();
  if (!lost) return go();
  if (auto* asked = findChild<LossQuestion*>()) return asked->raise();
  auto* question = new LossQuestion(lost, by, this);
  // After the dialog has closed, since the window must not delete it during its own close event.
  connect(question, &LossQuestion::continueChosen, this, [this, go] { QTimer::singleShot(0, this, go); });
  connect(question, &LossQuestion::saveChosen, this, [this, go] {
    afterSaving_ = go;
    saveCase();
  });
  // The situation has changed: asks again if other work would be lost now, for example an import.
  connect(tasks_, &TaskBar::runningChanged, question, [this, question, by, go] {
    if (!question->isVisible()) return;
    question->reject();
    QTimer::singleShot(0, this, [this, by, go] {
      if (loss()) confirmDiscard(by, go);
    });
  });
  question->open();
}

void MainWindow::showTitle() {
  const bool changed = !unsavedEdits().empty();
  const bool toWrite = changed || case_.folder.isEmpty() || !quietEdits().empty();
  save_->setEnabled(case_.patient && !tasks_->isRunning() && toWrite);
  saveAs_->setEnabled(case_.patient && !tasks_->isRunning());
  exchange_->setEnabled(case_.patient && !tasks_->isRunning());
  reload_->setEnabled(!case_.folder.isEmpty());
  if (!case_.patient) return;
  const CaseManifest& manifest = case_.patient->manifest;
  QString title = QString::fromStdString(manifest.title), hint = QString::fromStdString(manifest.description);
  if (isWithoutFolder())
    title += tr(" (not saved)");
  else if (changed)
    title += tr(" (changed)");
  if (!case_.folder.isEmpty()) hint += (hint.isEmpty() ? QString() : QStringLiteral("\n")) + case_.folder;
  header_->setCaseTitle(title, hint);
  setWindowTitle(QStringLiteral("%1 - Insonate").arg(title));
}

}  // namespace insonate::ui
