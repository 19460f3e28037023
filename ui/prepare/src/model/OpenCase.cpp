#include "OpenCase.h"

#include "ValueEdit.h"

#include <utility>

namespace insonate::prepare {

OpenCase::OpenCase(QObject* parent) : QObject(parent) {
  undo_.setUndoLimit(kMaxUndo);
}

void OpenCase::setCase(std::shared_ptr<const PatientCase> patient) {
  Q_EMIT closing();
  undo_.clear();
  patient_ = std::move(patient);
  title_ = patient_ ? QString::fromStdString(patient_->manifest.title) : QString();
  Q_EMIT opened();
  Q_EMIT caseChanged();
  Q_EMIT shown();
}

void OpenCase::replaceCase(std::shared_ptr<const PatientCase> patient) {
  // An import has the name under which it would be saved.
  const bool named = patient_ && title_.toStdString() == patient_->manifest.title;
  if (named) title_ = QString::fromStdString(patient->manifest.title);
  patient_ = std::move(patient);
  Q_EMIT saved();
  if (named) Q_EMIT titleChanged();
}

void OpenCase::setOrigin(const ui::CaseOrigin& origin) {
  origin_ = origin;
  Q_EMIT originChanged();
}

void OpenCase::setTitle(const QString& title) {
  const QString tidy = title.simplified();
  if (!patient_ || tidy == title_ || tidy.isEmpty()) return Q_EMIT titleChanged();  // Restores the field.
  undo_.push(titleEdit(tidy, nullptr));
}

void OpenCase::restoreTitle(const QString& title, QUndoCommand& all) {
  if (title != title_) titleEdit(title, &all);
}

QUndoCommand* OpenCase::titleEdit(const QString& title, QUndoCommand* parent) {
  const auto apply = [this](const QString& value) {
    title_ = value;
    Q_EMIT titleChanged();
  };
  return new ValueEdit<QString>(title_, title, apply, tr("title of the case"), parent);
}

}  // namespace insonate::prepare
