#pragma once

#include "CurriculumShelf.h"

#include <insonate/curriculum/CurriculumDraft.h>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {

class Account;

/// The curricula of the store, and the selected one, without a widget. A draft is saved in the store a moment after
/// each change and when it is left. For the window's thread.
class CurriculumDesk : public QObject {
  Q_OBJECT

 public:
  explicit CurriculumDesk(Account& account, QObject* parent = nullptr);
  /// Saves unsaved changes, if the account still exists; the end of the program saves them, too.
  ~CurriculumDesk() override;

  const std::vector<OfferedCurriculum>& offers() const { return offers_; }
  const std::vector<Cohort>& cohorts() const { return cohorts_; }
  /// The selected offer; null: none.
  const OfferedCurriculum* chosen() const { return chosen_ ? &*chosen_ : nullptr; }
  /// Selects a curriculum once the changes of the present one are stored; if the store refuses them, the present one
  /// stays.
  void choose(const OfferedCurriculum& offer);
  /// `go` once all that was written is in the store, or another user has saved another; `refused` where the store does
  /// not take it.
  void afterSaving(std::function<void()> go, std::function<void()> refused);

  /// The selected curriculum; null before it is read.
  const Curriculum* curriculum() const { return curriculum_ ? &*curriculum_ : nullptr; }
  bool isDraft() const { return curriculum_ && chosen_->kind == OfferedCurriculum::Kind::Draft; }
  /// Reasons why the draft cannot be published.
  const std::vector<DraftTrouble>& troubles() const { return troubles_; }
  /// Names that a curriculum can refer to on this computer.
  const TeachingNames& known() const { return known_; }

  /// One step of undo; changes of one field after the other are one, unless `field` is empty.
  void edit(const QString& field, const std::function<void(Curriculum&)>& change);
  void undo();
  void redo();
  bool canUndo() const { return !past_.empty(); }
  bool canRedo() const { return !future_.empty(); }

  /// Tells whether the store has the draft as it is here.
  bool isSaved() const { return saved_; }
  /// Another user has saved another: nothing is saved until one of these is called.
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
  void offersChanged();      ///< offers() or cohorts()
  void curriculumChanged();  ///< all that is told of the one that is looked at
  void savingChanged();
  void said(const QString& sentence, bool isTrouble);

 private:
  struct Shelf {
    std::vector<OfferedCurriculum> offers;
    std::vector<Cohort> cohorts;
  };
  void refresh();
  void read(const OfferedCurriculum& offer);
  void take(const OfferedCurriculum& offer, const Result<std::string>& text);
  void takeDraft(const Result<KeptDraft>& draft);
  void show(Curriculum curriculum);
  void changed();
  void save();
  void takeSaved(const std::string& text, const Result<void>& done);
  void contest(const std::string& refusal);

  QPointer<Account> account_;
  TeachingNames known_;
  std::vector<OfferedCurriculum> offers_;
  std::vector<Cohort> cohorts_;
  std::optional<OfferedCurriculum> chosen_;
  std::optional<Curriculum> curriculum_;
  std::vector<DraftTrouble> troubles_;
  std::vector<Curriculum> past_, future_;
  QString field_;     ///< that was changed last
  std::string kept_;  ///< the draft as the store is known to have it
  std::string sent_;  ///< as it has it once all that was sent is done
  bool saved_ = true, contested_ = false;
  std::function<void()> go_, refused_;  ///< what waits for saving
  int round_ = 0;                       ///< of choosing: answers about another are not taken
  QTimer soon_;
};

}  // namespace insonate::ui
