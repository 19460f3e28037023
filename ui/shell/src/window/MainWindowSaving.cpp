// The part of the window that keeps edits: saving, and asking before they would be lost.
#include "HeaderBar.h"
#include "RecentCases.h"
#include "StatusStrip.h"

#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <QAction>
#include <QMessageBox>
#include <QTimer>
#include <utility>

namespace insonate::ui {

void MainWindow::open(const QString& path) {
  whenNothingIsLost([this, path] { loader_->open(path); });
}

void MainWindow::openTextbook() {
  whenNothingIsLost([this] { loader_->openTextbook(); });
}

void MainWindow::reload() {
  if (!case_.folder.isEmpty()) open(case_.folder);
}

std::vector<CaseEdit> MainWindow::unsavedEdits() const {
  std::vector<CaseEdit> edits;
  for (const Room& room : rooms_)
    if (CaseEdit edit = room.workspace->unsavedEdit()) edits.push_back(std::move(edit));
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
  loader_->save(case_.patient, folder, unsavedEdits());
}

void MainWindow::showSaved(const QString& folder, const std::shared_ptr<const PatientCase>& patient) {
  case_.folder = folder;
  case_.builtIn = false;
  const bool edited = patient != std::exchange(case_.patient, patient);
  rememberCase({folder, QString::fromStdString(patient->manifest.title)});
  for (const Room& room : rooms_) {
    room.workspace->setOrigin({case_.folder, case_.notes, case_.builtIn});
    if (edited) room.workspace->caseSaved(patient);
  }
  showTitle();
  status_->say(tr("Saved to %1.").arg(folder));
  if (const auto go = std::exchange(afterSaving_, {})) go();
}

void MainWindow::whenNothingIsLost(std::function<void()> go) {
  if (unsavedEdits().empty()) return go();
  if (findChild<QMessageBox*>(QStringLiteral("unsavedQuestion"))) return;
  auto* question = new QMessageBox(
      QMessageBox::NoIcon, tr("Unsaved changes"),
      tr("%1 has changes that are not saved.").arg(QString::fromStdString(case_.patient->manifest.title)),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  question->setObjectName(QStringLiteral("unsavedQuestion"));
  question->setInformativeText(tr("Without saving, they are lost."));
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [this, go = std::move(go)](int answer) {
    // Once the question is gone: it must not go with the window in the middle of its own end.
    if (answer == QMessageBox::Discard) return QTimer::singleShot(0, this, go);
    if (answer != QMessageBox::Save) return;
    afterSaving_ = go;
    saveCase();
  });
  question->open();
}

void MainWindow::showTitle() {
  const bool changed = !unsavedEdits().empty();
  save_->setEnabled(case_.patient && !tasks_->isRunning() && (changed || case_.folder.isEmpty()));
  reload_->setEnabled(!case_.folder.isEmpty());
  if (!case_.patient) return;
  const CaseManifest& manifest = case_.patient->manifest;
  QString title = QString::fromStdString(manifest.title), hint = QString::fromStdString(manifest.description);
  if (case_.folder.isEmpty() && !case_.builtIn)
    title += tr(" (not saved)");
  else if (changed)
    title += tr(" (changed)");
  if (!case_.folder.isEmpty()) hint += (hint.isEmpty() ? QString() : QStringLiteral("\n")) + case_.folder;
  header_->setCaseTitle(title, hint);
  setWindowTitle(QStringLiteral("%1 - Insonate").arg(title));
}

}  // namespace insonate::ui
