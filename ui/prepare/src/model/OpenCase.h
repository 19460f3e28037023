#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/ui/Workspace.h>

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>

namespace insonate::prepare {

/// The open case: its voxels as they were opened or last saved, its folder and title, and the undo stack of all edits.
class OpenCase : public QObject {
  Q_OBJECT

 public:
  explicit OpenCase(QObject* parent);

  /// Sets the case and discards edits; null: no case.
  void setCase(std::shared_ptr<const PatientCase> patient);
  /// Replaces the case by its saved state.
  void replaceCase(std::shared_ptr<const PatientCase> patient);
  const std::shared_ptr<const PatientCase>& patient() const { return patient_; }
  void setOrigin(const ui::CaseOrigin& origin);
  const ui::CaseOrigin& origin() const { return origin_; }

  const QString& title() const { return title_; }
  void setTitle(const QString& title);
  /// Adds to `all` an edit that sets the title, if it differs from the present one.
  void restoreTitle(const QString& title, QUndoCommand& all);

  QUndoStack& undoStack() { return undo_; }
  /// Maximum number of undoable edits, which is the number of steps that LabelEdit stores.
  static constexpr int kMaxUndo = int(LabelEdit::kMaxSteps);

 Q_SIGNALS:
  void closing();      ///< emitted before another case is set, while patient() is still the former case
  void opened();       ///< emitted first after setCase(), so that the parts of the model take over the case
  void caseChanged();  ///< emitted second after setCase(), so that panels show the case
  void shown();        ///< emitted last after setCase(), so that background work begins
  void saved();        ///< emitted when replaceCase() has replaced patient()
  void originChanged();
  void titleChanged();

 private:
  QUndoCommand* titleEdit(const QString& title, QUndoCommand* parent);

  std::shared_ptr<const PatientCase> patient_;
  ui::CaseOrigin origin_;
  QString title_;
  QUndoStack undo_;
};

}  // namespace insonate::prepare
