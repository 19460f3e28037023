#pragma once

#include "CurriculumShelf.h"

#include <insonate/curriculum/CurriculumDraft.h>
#include <insonate/ui/RecentCases.h>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {

class Account;

/// The store's curricula, and the selected curriculum. Uses no widgets. A draft is saved in the store a moment after
/// each change, and when another curriculum is selected. May be used only on the window's thread.
class CurriculumController : public QObject {
  Q_OBJECT

 public:
  explicit CurriculumController(Account& account, QObject* parent = nullptr);
  /// Saves unsaved changes if the account still exists. Also called at the end of the program.
  ~CurriculumController() override;

  const std::vector<OfferedCurriculum>& offers() const { return offers_; }
  const std::vector<Cohort>& cohorts() const { return cohorts_; }
  /// The selected entry of offers(); null: none.
  const OfferedCurriculum* chosen() const { return chosen_ ? &*chosen_ : nullptr; }
  /// Selects a curriculum as soon as the changes of the present one are stored. If the store refuses the changes, the
  /// present curriculum stays selected.
  void choose(const OfferedCurriculum& offer);
  /// Saves the draft, then calls `go`, or `refused` if the store does not accept the draft. Calls `go` at once if there
  /// are no unsaved changes or the draft is contested.
  void afterSaving(std::function<void()> go, std::function<void()> refused);

  /// The selected curriculum; null until it is read.
  const Curriculum* curriculum() const { return curriculum_ ? &*curriculum_ : nullptr; }
  bool isDraft() const { return curriculum_ && chosen_->kind == OfferedCurriculum::Kind::Draft; }
  /// Reasons why the draft cannot be published.
  const std::vector<DraftError>& errors() const { return errors_; }
  /// Names that a curriculum can refer to on this computer.
  const TeachingNames& known() const { return known_; }
  /// Searches the cases of this computer again; emits curriculumChanged() if they have changed.
  void refreshCases();

  /// Applies a change as one step of undo. Consecutive changes of one field are one step, unless `field` is empty.
  void edit(const QString& field, const std::function<void(Curriculum&)>& change);
  void undo();
  void redo();
  bool canUndo() const { return history_.canUndo(); }
  bool canRedo() const { return history_.canRedo(); }

  /// Tells whether the store has the present state of the draft.
  bool isSaved() const { return saved_; }
  /// Tells whether another user has saved a different state of the draft. In that case, no changes are saved until
  /// reloadDraft() or overwriteTheirs() is called.
  bool isContested() const { return contested_; }
  void reloadDraft();
  void overwriteTheirs();

  void begin(const QString& name, std::function<void(Result<void>)> done);
  /// Begins a draft of the next version of the selected curriculum.
  void beginVersion();
  void discard();
  void publish(std::function<void(Result<void>)> done);
  void teach(const std::string& cohort);

 Q_SIGNALS:
  void offersChanged();      ///< emitted when offers() or cohorts() has changed
  void curriculumChanged();  ///< emitted when the selected curriculum or its state has changed
  void savingChanged();
  void statusMessage(const QString& sentence, bool isError);

 private:
  struct Shelf {
    std::vector<OfferedCurriculum> offers;
    std::vector<Cohort> cohorts;
  };
  class Edit;
  void refresh();
  void readLibrary();
  void showCases();
  void read(const OfferedCurriculum& offer);
  void take(const OfferedCurriculum& offer, const Result<std::string>& text);
  void takeDraft(const Result<KeptDraft>& draft);
  void show(Curriculum curriculum);
  void changed();
  void save();
  void takeSaved(const std::string& text, const Result<void>& done);
  void handleRefusal(const std::string& refusal);

  QPointer<Account> account_;
  TeachingNames known_;
  std::vector<RecentCase> library_;
  std::vector<OfferedCurriculum> offers_;
  std::vector<Cohort> cohorts_;
  std::optional<OfferedCurriculum> chosen_;
  std::optional<Curriculum> curriculum_;
  std::vector<DraftError> errors_;
  QUndoStack history_;
  QString field_;     ///< field that was changed last; empty: the next change is a step of its own
  int step_ = 0;      ///< number of the last step; changes with the same number are undone together
  std::string kept_;  ///< text of the draft that the store has confirmed
  std::string sent_;  ///< text of the draft that was sent last
  bool saved_ = true, contested_ = false;
  std::function<void()> go_, refused_;  ///< callbacks of afterSaving()
  int round_ = 0;                       ///< number of the selection; results for earlier selections are dropped
  QTimer soon_;
};

}  // namespace insonate::ui
